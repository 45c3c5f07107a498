#include <gtest/gtest.h>

#include "firmware/core/stabilizer/landing_position.hpp"
#include "tests/unit/firmware_core/stabilizer_moments.hpp"

namespace surefoot::stabilizer {
namespace {

using testing::kDegree;

StabilizerInput rolling(Side foot, double toward_rad_s, double nominal_toward_rad_s, double share = 0.7) {
  StabilizerInput input = testing::lowering(foot, share);
  const double sign = foot == Side::kLeft ? -1.0 : 1.0;
  input.measured.support_roll_rate_rad_s = sign * toward_rad_s;
  input.nominal.support_roll_rate_rad_s = sign * nominal_toward_rad_s;
  return input;
}

Adjustment settled(const LandingPositionConfig& config, LandingPositionState& state, const StabilizerInput& input) {
  Adjustment made;
  for (int tick = 0; tick < 1000; ++tick) made = step(config, state, input, true);
  return made;
}

// Kim, Park, Oh 2007, eq. (14) with I = 45.4 kg m2, 56 kg, Delta t = 0.1 s, I w_after = 11 N m s.
TEST(LandingPosition, IsWhereThePrintedLawPutsIt) {
  EXPECT_NEAR(landing_distance_m({}, 56.0, 20.0 * kDegree), 0.088, 0.0005);
  EXPECT_NEAR(landing_distance_m({}, 56.0, 18.8 * kDegree), 0.071, 0.0005);
}

// kp (88 - 71 mm) = 5.2 mm.
TEST(LandingPosition, GoesOutwardWhenTheBodyComesTooFast) {
  LandingPositionConfig config;
  config.uses_nominal = false;
  for (const Side foot : kSides) {
    LandingPositionState state;
    const Adjustment made = settled(config, state, rolling(foot, 20.0 * kDegree, 0.0));
    EXPECT_NEAR(lateral_sign(foot) * made.landing_y_m, LandingPositionConfig{}.kp * (0.0882 - 0.071), 1e-4);
    EXPECT_EQ(made.landing_x_m, 0.0);
  }
}

TEST(LandingPosition, IsSilentWhileTheBodyComesAsOnTheFlat) {
  LandingPositionState state;
  EXPECT_EQ(settled({}, state, rolling(Side::kLeft, 0.45, 0.45)).landing_y_m, 0.0);
}

TEST(LandingPosition, MovesByNoMoreThanItsLimit) {
  LandingPositionState state;
  EXPECT_NEAR(settled({}, state, rolling(Side::kRight, 3.0, 0.4)).landing_y_m, -0.04, 1e-9);
}

TEST(LandingPosition, StaysInTheLastFiftyMillisecondsAndInDoubleSupport) {
  LandingPositionState state;
  const double held_m = settled({}, state, rolling(Side::kLeft, 0.5, 0.4)).landing_y_m;
  EXPECT_EQ(settled({}, state, rolling(Side::kLeft, 0.2, 0.4, 1.0 - 0.049 / 0.9025)).landing_y_m, held_m);
  EXPECT_EQ(settled({}, state, testing::landed(Side::kLeft, 300.0)).landing_y_m, held_m);
  EXPECT_NE(settled({}, state, rolling(Side::kLeft, 0.2, 0.4, 1.0 - 0.051 / 0.9025)).landing_y_m, held_m);
}

TEST(LandingPosition, DoesNotJumpWhenTheOtherFootBecomesTheMovingOne) {
  LandingPositionState state;
  const double held_m = settled({}, state, rolling(Side::kLeft, 0.5, 0.4)).landing_y_m;
  const double next_m = step(LandingPositionConfig{}, state, testing::lifting(Side::kRight, 0.0), false).landing_y_m;
  EXPECT_NEAR(next_m, held_m, 0.03 * held_m);
  for (int tick = 0; tick < 400; ++tick) {
    (void)step(LandingPositionConfig{}, state, testing::lifting(Side::kRight, 0.2), false);
  }
  EXPECT_NEAR(state.shift_y_m, 0.0, 1e-5);
}

}  // namespace
}  // namespace surefoot::stabilizer
