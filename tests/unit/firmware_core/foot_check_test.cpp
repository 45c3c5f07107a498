#include "firmware/core/safety/foot_check.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace surefoot::safety {
namespace {

constexpr double kPeriodS = 1.0e-3;
constexpr double kWeightN = 785.0;

/// A walk as the load cells feel it: 1.4 s on one foot, 1 s on both, and a ripple on whatever is loaded.
struct WalkingFeet {
  FootCheckConfig config{};
  FootCheckState state{};
  PerSide<FootSensors> feet{};
  bool is_moving = true;
  double weight_n = kWeightN;
  int tick = 0;

  template <typename Lie>
  bool next(Lie lie) {
    const int in_step = tick % 2400;
    const Side swing = tick / 2400 % 2 == 0 ? Side::kLeft : Side::kRight;
    const double ripple_n = 0.1 * (tick % 7);
    for (const Side side : kSides) {
      const bool is_up = side == swing && in_step >= 500 && in_step < 1900;
      const double share = is_up ? 0.0 : in_step >= 500 && in_step < 1900 ? 1.0 : 0.5;
      feet[index(side)].corner_force_n.fill(share == 0.0 ? 0.0 : share * kWeightN / 4.0 + ripple_n);
      feet[index(side)].freshness.age_ticks = 0;
    }
    ++tick;
    lie(feet);
    return are_feet_plausible(config, state, feet, is_moving, weight_n, kPeriodS);
  }
  template <typename Lie>
  int objects_after(int limit, Lie lie) {
    for (int i = 1; i <= limit; ++i) {
      if (!next(lie)) return i;
    }
    return 0;
  }
};

const auto kTruth = [](auto&) {};

TEST(FootCheck, AcceptsAWalkWithConstantZeroesInTheAir) {
  WalkingFeet robot;
  EXPECT_EQ(robot.objects_after(30'000, kTruth), 0);
}

TEST(FootCheck, FindsACornerThatKeepsItsBitsForOneAndAHalfCyclesOrUnderLoadForHalfASecond) {
  for (std::size_t foot = 0; foot < 2; ++foot) {
    for (std::size_t corner = 0; corner < 4; ++corner) {
      for (const double stuck_n : {0.0, 19.9, -19.9, 20.0, 120.0, -400.0}) {
        WalkingFeet robot;
        robot.weight_n = 0.0;
        const auto stuck = [&](auto& feet) { feet[foot].corner_force_n[corner] = stuck_n; };
        EXPECT_NEAR(robot.objects_after(10'000, stuck), std::abs(stuck_n) < 20.0 ? 7202 : 502, 1) << stuck_n;
      }
    }
  }
}

TEST(FootCheck, CountsFrozenCornersOnlyWhileTheRobotMoves) {
  WalkingFeet robot;
  const auto stuck = [](auto& feet) { feet[1].corner_force_n[2] = 120.0; };
  EXPECT_EQ(robot.objects_after(450, stuck), 0);
  robot.is_moving = false;
  EXPECT_EQ(robot.objects_after(20'000, stuck), 0);
  robot.is_moving = true;
  EXPECT_EQ(robot.objects_after(450, stuck), 0) << "what was before the stop is forgotten";
}

// The other foot's swing leaves nothing on a foot that reads zero: 0.4 s of it are enough.
TEST(FootCheck, FindsFeetThatTogetherFeelNoWeight) {
  WalkingFeet robot;
  robot.tick = 500;  // the left foot is in the air
  EXPECT_EQ(robot.objects_after(2000, [](auto& feet) { feet[0].corner_force_n.fill(0.0); }), 401);
}

TEST(FootCheck, FindsFeetThatTogetherFeelFarTooMuch) {
  WalkingFeet robot;
  robot.is_moving = false;
  EXPECT_EQ(robot.objects_after(2000, [](auto& feet) { feet[1].corner_force_n[0] += kWeightN; }), 401);
}

// 20 kg on an 80 kg robot, and the shocks and hops of a landing of up to 0.4 s.
TEST(FootCheck, AcceptsAPayloadAndTheHopOfAReflex) {
  WalkingFeet robot;
  const auto loaded = [](auto& feet) {
    for (FootSensors& foot : feet) {
      for (double& force_n : foot.corner_force_n) force_n *= 1.25;
    }
  };
  EXPECT_EQ(robot.objects_after(5000, loaded), 0);
  const auto hop = [&](auto& feet) {
    if (robot.tick % 500 < 390) feet[0].corner_force_n = feet[1].corner_force_n = {};
  };
  robot.is_moving = false;
  EXPECT_EQ(robot.objects_after(5000, hop), 0);
}

TEST(FootCheck, DoesNotJudgeAWeightThatItDoesNotKnow) {
  WalkingFeet robot;
  robot.weight_n = 0.0;
  robot.is_moving = false;
  EXPECT_EQ(robot.objects_after(3000, [](auto& feet) { feet[0].corner_force_n.fill(3000.0); }), 0);
}

TEST(FootCheck, DoesNotJudgeTheWeightWhileEitherFootIsSilent) {
  for (std::size_t silent = 0; silent < 2; ++silent) {
    WalkingFeet robot;
    robot.is_moving = false;
    const auto lie = [silent](auto& feet) {
      feet[silent].corner_force_n.fill(3000.0);
      feet[silent].freshness.age_ticks = 1;
    };
    EXPECT_EQ(robot.objects_after(3000, lie), 0);
  }
}

TEST(FootCheck, DoesNotCountTheLastWordOfASilentFoot) {
  WalkingFeet robot;
  for (int i = 0; i < 300; ++i) static_cast<void>(robot.next([](auto& feet) { feet[0].corner_force_n.fill(3000.0); }));
  for (int i = 0; i < 20'000; ++i) {
    ASSERT_TRUE(robot.next([](auto& feet) {
      feet[0].corner_force_n.fill(3000.0);
      feet[0].freshness.age_ticks = 3;
    }));
  }
}

}  // namespace
}  // namespace surefoot::safety
