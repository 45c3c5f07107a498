#include <gtest/gtest.h>

#include <cmath>

#include "firmware/core/stabilizer/landing_momentum.hpp"
#include "tests/unit/firmware_core/stabilizer_moments.hpp"

namespace surefoot::stabilizer {
namespace {

using testing::kDegree;

LandingMomentumConfig printed() {
  LandingMomentumConfig config;
  config.uses_nominal = false;
  return config;
}

/// A landing with the body rolling toward the landed foot; leaning to the left is negative roll.
StabilizerInput rolling_landing(Side foot, double toward_rad_s, double force_n = 400.0) {
  StabilizerInput input = testing::landed(foot, force_n);
  input.measured.support_roll_rate_rad_s = foot == Side::kLeft ? -toward_rad_s : toward_rad_s;
  return input;
}

// Kim, Park, Oh 2007, eq. (10) with I = 45.4 kg m2: 18.8 deg/s are 14.9 N m s, and -39 N m bring them to 11 in 0.1 s.
TEST(LandingMomentum, AsksForThePrintedMoment) {
  const LandingMomentumConfig config = printed();
  const double rate_rad_s = 18.8 * kDegree;
  EXPECT_NEAR(config.inertia_kg_m2 * rate_rad_s, 14.9, 0.01);
  EXPECT_NEAR(landing_moment_nm(config, 11.0, rate_rad_s), -39.0, 0.1);
  LandingMomentumState state;
  (void)step(config, state, rolling_landing(Side::kLeft, rate_rad_s), true);
  EXPECT_NEAR(state.wanted_moment_nm, -39.0, 0.1);
}

// Only the integral acts: 28 N m (400 N at 70 mm) times ki times 0.1 s.
TEST(LandingMomentum, PressesTheOuterEdgeDownForATenthOfASecondAtMost) {
  const LandingMomentumConfig config = printed();
  for (const Side foot : kSides) {
    LandingMomentumState state;
    Adjustment made;
    for (int tick = 0; tick < 100; ++tick) {
      made = step(config, state, rolling_landing(foot, 18.8 * kDegree), true);
      EXPECT_EQ(made.ankle_roll_rad[index(opposite(foot))], 0.0);
    }
    const double outward_rad = -lateral_sign(foot) * made.ankle_roll_rad[index(foot)];
    EXPECT_NEAR(outward_rad, 28.0 * config.ki_rad_per_nms * 0.1, 1e-4);
    for (int tick = 0; tick < 50; ++tick) made = step(config, state, rolling_landing(foot, 18.8 * kDegree), true);
    EXPECT_FALSE(state.is_acting);
    EXPECT_NEAR(-lateral_sign(foot) * made.ankle_roll_rad[index(foot)], outward_rad, 0.01 * outward_rad);
  }
}

TEST(LandingMomentum, StopsTurningWhenTheAnkleGivesTheMoment) {
  const LandingMomentumConfig config = printed();
  LandingMomentumState state;
  StabilizerInput input = rolling_landing(Side::kLeft, 18.8 * kDegree);
  input.ankle[index(Side::kLeft)].roll_moment_nm = 28.0;  // the left, outer edge carries
  for (int tick = 0; tick < 100; ++tick) {
    EXPECT_NEAR(step(config, state, input, true).ankle_roll_rad[index(Side::kLeft)], 0.0, 1e-9);
  }
}

TEST(LandingMomentum, DoesNothingInRangeAndStopsOnceInRange) {
  const LandingMomentumConfig config = printed();
  LandingMomentumState state;
  const double inside_rad_s = (11.0 + 1.4) / 45.4;
  EXPECT_EQ(step(config, state, rolling_landing(Side::kRight, inside_rad_s), true).ankle_roll_rad[0], 0.0);
  EXPECT_FALSE(state.is_acting);
  state = {};
  for (int tick = 0; tick < 20; ++tick) (void)step(config, state, rolling_landing(Side::kRight, 0.35), true);
  EXPECT_TRUE(state.is_acting);
  (void)step(config, state, rolling_landing(Side::kRight, inside_rad_s), true);
  EXPECT_FALSE(state.is_acting);
  (void)step(config, state, rolling_landing(Side::kRight, 0.35), true);
  EXPECT_FALSE(state.is_acting) << "one landing is judged once";
}

TEST(LandingMomentum, IsSilentAtALandingAsOnTheFlat) {
  LandingMomentumState state;
  StabilizerInput input = rolling_landing(Side::kLeft, 0.5);
  input.nominal.support_roll_rate_rad_s = -0.48;
  EXPECT_EQ(step(LandingMomentumConfig{}, state, input, true).ankle_roll_rad[index(Side::kLeft)], 0.0);
  EXPECT_FALSE(state.is_acting);
  EXPECT_NEAR(state.desired_nms, 0.48 * 45.4, 1e-9);
}

// Fig. 25b: the angle stays while the foot stands and goes back while it is lifted.
TEST(LandingMomentum, HoldsWhileTheFootStandsAndBleedsWhileItIsLifted) {
  const LandingMomentumConfig config = printed();
  LandingMomentumState state;
  Adjustment made;
  for (int tick = 0; tick < 47; ++tick) made = step(config, state, rolling_landing(Side::kLeft, 0.35), true);
  const double held_rad = made.ankle_roll_rad[index(Side::kLeft)];
  EXPECT_LT(held_rad, -0.003);
  for (int tick = 0; tick < 900; ++tick) made = step(config, state, testing::lifting(Side::kRight, 0.3), false);
  EXPECT_NEAR(made.ankle_roll_rad[index(Side::kLeft)], held_rad, 0.02 * std::abs(held_rad));
  for (int tick = 0; tick < 500; ++tick) made = step(config, state, testing::lifting(Side::kLeft, 0.3), false);
  EXPECT_NEAR(made.ankle_roll_rad[index(Side::kLeft)], 0.0, 0.01 * std::abs(held_rad));
}

TEST(LandingMomentum, TurnsNoAnkleWhoseFootHasLostContactAgain) {
  const LandingMomentumConfig config = printed();
  LandingMomentumState state;
  for (int tick = 0; tick < 50; ++tick) {
    EXPECT_EQ(step(config, state, rolling_landing(Side::kLeft, 0.35, 0.0), true).ankle_roll_rad[1], 0.0);
  }
}

}  // namespace
}  // namespace surefoot::stabilizer
