#include "firmware/core/safety/encoder_check.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace surefoot::safety {
namespace {

constexpr double kPeriodS = 1.0e-3;

/// All joints swing by 0.4 rad once in 1.4 s, as in a walk: up to 0.9 rad/s.
struct SwingingLegs {
  EncoderCheckConfig config{};
  EncoderCheckState state{};
  PerSide<LegSensors> legs{};
  int tick = 0;

  static constexpr double kRate = 2.0 * std::numbers::pi / 1.4;

  /// One tick; `lie` bends what is measured, and says who stays silent.
  template <typename Lie>
  bool next(Lie lie) {
    const double phase = kRate * kPeriodS * tick++;
    for (LegSensors& leg : legs) {
      leg.angle_rad.fill(0.2 * std::sin(phase));
      leg.rate_rad_s.fill(0.2 * kRate * std::cos(phase));
      leg.freshness.age_ticks = 0;
    }
    lie(legs);
    return are_encoders_plausible(config, state, legs, kPeriodS);
  }
  bool next() {
    return next([](auto&) {});
  }
  /// Ticks until the check objects; 0 if it does not in `limit`.
  template <typename Lie>
  int objects_after(int limit, Lie lie) {
    for (int i = 1; i <= limit; ++i) {
      if (!next(lie)) return i;
    }
    return 0;
  }
};

TEST(EncoderCheck, AcceptsAnglesThatFollowTheirRates) {
  SwingingLegs robot;
  for (int i = 0; i < 10'000; ++i) ASSERT_TRUE(robot.next()) << i;
}

TEST(EncoderCheck, DoesNotMindWhereAJointIsWhenFirstHeard) {
  SwingingLegs robot;
  robot.tick = 350;  // a quarter of the swing
  EXPECT_TRUE(robot.next());
  EXPECT_EQ(robot.state.residual_rad[0][0], 0.0);
}

// 0.01 rad at up to 0.9 rad/s: some 11 ms in the middle of the swing, a quarter swing at worst.
TEST(EncoderCheck, FindsAnEncoderThatSticksWhileItsJointMoves) {
  for (std::size_t leg = 0; leg < 2; ++leg) {
    for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
      SwingingLegs robot;
      for (int i = 0; i < 1400; ++i) ASSERT_TRUE(robot.next());
      const double stuck_rad = robot.legs[leg].angle_rad[joint];
      const int ticks = robot.objects_after(100, [&](auto& legs) { legs[leg].angle_rad[joint] = stuck_rad; });
      EXPECT_GE(ticks, 10);
      EXPECT_LE(ticks, 20);
    }
  }
}

TEST(EncoderCheck, FindsARateThatSticksWhileTheEncoderMoves) {
  SwingingLegs robot;
  for (int i = 0; i < 1400; ++i) ASSERT_TRUE(robot.next());
  const int ticks = robot.objects_after(1400, [](auto& legs) { legs[1].rate_rad_s[3] = 0.0; });
  EXPECT_GE(ticks, 10);
  EXPECT_LE(ticks, 20);
}

TEST(EncoderCheck, FindsAJumpInItsOwnTickAndForgivesOneWithinTheLimit) {
  for (const double jump_rad : {0.0095, -0.0095, 0.0105, -0.0105}) {
    SwingingLegs robot;
    ASSERT_TRUE(robot.next());
    EXPECT_EQ(robot.next([&](auto& legs) { legs[0].angle_rad[5] += jump_rad; }), std::abs(jump_rad) < 0.01);
  }
}

// By theory: an error of 0.09 rad/s times the time constant of 0.1 s stays at 0.009 rad, 0.11 rad/s passes the limit.
TEST(EncoderCheck, LetsASmallRateErrorLeakAway) {
  SwingingLegs robot;
  EXPECT_EQ(robot.objects_after(5000, [](auto& legs) { legs[0].rate_rad_s[1] += 0.09; }), 0);
  EXPECT_NEAR(robot.state.residual_rad[0][1], -0.009, 2e-4);
  EXPECT_GT(robot.objects_after(5000, [](auto& legs) { legs[0].rate_rad_s[1] += 0.11; }), 0);
}

TEST(EncoderCheck, JudgesNobodyWhoIsSilentAndCountsTheWayOfTheGap) {
  SwingingLegs robot;
  for (int i = 0; i < 1400; ++i) ASSERT_TRUE(robot.next());
  for (int i = 0; i < 10; ++i) {
    ASSERT_TRUE(robot.next([](auto& legs) {
      legs[0].angle_rad.fill(3.0);
      legs[0].freshness.age_ticks = 1;
    }));
  }
  EXPECT_TRUE(robot.next());
  EXPECT_LT(std::abs(robot.state.residual_rad[0][2]), 1e-5);
  for (int i = 0; i < 4; ++i) static_cast<void>(robot.next([](auto& legs) { legs[0].freshness.age_ticks = 1; }));
  EXPECT_FALSE(robot.next([](auto& legs) { legs[0].angle_rad[2] += 0.02; })) << "a jump hidden in a gap shows after it";
}

// A host that stalls: two rates say little of the way between them.
TEST(EncoderCheck, DoesNotJudgeAcrossALongGap) {
  SwingingLegs robot;
  for (int i = 0; i < 1400; ++i) ASSERT_TRUE(robot.next());
  for (int i = 0; i < 5; ++i) static_cast<void>(robot.next([](auto& legs) { legs[0].freshness.age_ticks = 1; }));
  EXPECT_TRUE(robot.next([](auto& legs) { legs[0].angle_rad[2] += 0.02; }));
  EXPECT_FALSE(robot.next([](auto& legs) { legs[0].angle_rad[2] += 0.04; })) << "from there on it does";
}

}  // namespace
}  // namespace surefoot::safety
