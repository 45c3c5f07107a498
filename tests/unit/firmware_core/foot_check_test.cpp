#include "firmware/core/safety/foot_check.hpp"

#include <gtest/gtest.h>

namespace surefoot::safety {
namespace {

constexpr double kPeriodS = 1.0e-3;
constexpr double kWeightN = 785.0;

/// A walk as the load cells feel it: 1.4 s on one foot, 1 s on both, and a ripple on whatever is loaded.
struct WalkingFeet {
  FootCheckConfig config{};
  FootCheckState state{};
  PerSide<FootSensors> feet{};
  bool is_walking = true;
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
    return are_feet_plausible(config, state, feet, is_walking, weight_n, kPeriodS);
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

TEST(FootCheck, FindsACornerThatKeepsItsBitsForOneAndAHalfCycles) {
  for (std::size_t foot = 0; foot < 2; ++foot) {
    for (std::size_t corner = 0; corner < 4; ++corner) {
      WalkingFeet robot;
      EXPECT_EQ(robot.objects_after(10'000, [&](auto& feet) { feet[foot].corner_force_n[corner] = 120.0; }), 7202);
    }
  }
}

TEST(FootCheck, CountsFrozenCornersOnlyOverWalking) {
  WalkingFeet robot;
  const auto stuck = [](auto& feet) { feet[1].corner_force_n[2] = 120.0; };
  EXPECT_EQ(robot.objects_after(7000, stuck), 0);
  robot.is_walking = false;
  EXPECT_EQ(robot.objects_after(20'000, stuck), 0);
  robot.is_walking = true;
  EXPECT_EQ(robot.objects_after(7000, stuck), 0) << "what was before the stop is forgotten";
}

// The other foot's swing leaves nothing on a foot that reads zero: 0.4 s of it are enough.
TEST(FootCheck, FindsFeetThatTogetherFeelNoWeight) {
  WalkingFeet robot;
  robot.tick = 500;  // the left foot is in the air
  EXPECT_EQ(robot.objects_after(2000, [](auto& feet) { feet[0].corner_force_n.fill(0.0); }), 401);
}

TEST(FootCheck, FindsFeetThatTogetherFeelFarTooMuch) {
  WalkingFeet robot;
  robot.is_walking = false;
  EXPECT_EQ(robot.objects_after(2000, [](auto& feet) { feet[1].corner_force_n[0] += kWeightN; }), 401);
}

// 20 kg on an 80 kg robot, and the shocks and hops of a landing of up to 0.4 s.
TEST(FootCheck, AcceptsAPayloadAndTheHopOfAReflex) {
  WalkingFeet robot;
  EXPECT_EQ(robot.objects_after(5000, [](auto& feet) { feet[0].corner_force_n[0] += 20.0 * 9.81; }), 0);
  const auto hop = [&](auto& feet) {
    if (robot.tick % 500 < 390) feet[0].corner_force_n = feet[1].corner_force_n = {};
  };
  robot.is_walking = false;
  EXPECT_EQ(robot.objects_after(5000, hop), 0);
}

TEST(FootCheck, DoesNotJudgeAWeightThatItDoesNotKnow) {
  WalkingFeet robot;
  robot.weight_n = 0.0;
  robot.is_walking = false;
  EXPECT_EQ(robot.objects_after(3000, [](auto& feet) { feet[0].corner_force_n.fill(3000.0); }), 0);
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
