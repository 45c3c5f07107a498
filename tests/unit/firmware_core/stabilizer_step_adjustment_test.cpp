#include <gtest/gtest.h>

#include "firmware/core/stabilizer/step_adjustment.hpp"
#include "tests/unit/firmware_core/flat_walk.hpp"

namespace surefoot::stabilizer {
namespace {

const StepAdjustmentConfig kConfig{};
const double kOmega_per_s = std::sqrt(9.81 / 0.67);

/// The `moving` foot lands in `ahead_s`.
StabilizerInput landing_in(double ahead_s, Side moving) {
  StabilizerInput input = coming_down(moving, 1.0e-3);
  input.walk.step_time_s = FlatWalk::kStep_s - ahead_s;
  input.walk.step_share = input.walk.step_time_s / FlatWalk::kStep_s;
  return input;
}

Adjustment after(StepAdjustmentState& state, const StabilizerInput& input, int ticks, bool is_active = true) {
  Adjustment adjustment;
  for (int k = 0; k < ticks; ++k) adjustment = step(kConfig, state, input, is_active);
  return adjustment;
}

// xi = z_c (tilt + rate / omega), 0.1 s before the landing by exp(0.1 omega) smaller than at it.
TEST(StepAdjustment, FollowsTheCapturePointOfTheLinearPendulum) {
  StepAdjustmentState state;
  StabilizerInput input = landing_in(0.1, Side::kLeft);
  input.nominal.torso_pitch_rad = 0.01;
  input.measured.torso_pitch_rad = 0.03;
  input.measured.torso_pitch_rate_rad_s = 0.1;
  input.measured.torso_roll_rad = -0.02;
  const Adjustment adjustment = after(state, input, 1000);
  const double growth = std::exp(0.1 * kOmega_per_s);
  EXPECT_NEAR(adjustment.landing_x_m, 0.67 * (0.02 + 0.1 / kOmega_per_s) * growth - 0.015, 1e-6);
  EXPECT_NEAR(adjustment.landing_y_m, 0.67 * 0.02 * growth - 0.015, 1e-6);
}

// The pendulum x'' = omega^2 (x - p) about the foot that lands: a deviation that the landing point takes in (all but
// the band) stays as it is; about the planned point it would grow by exp(omega t) to its side.
TEST(StepAdjustment, KeepsAFallFromGrowingOverTheNextStep) {
  for (const double sign : {1.0, -1.0}) {
    double x_m = sign * 0.02;
    double rate_m_s = 0.0;
    StepAdjustmentState state;
    for (int k = 0; k < 200; ++k) {  // the last 0.2 s about the old foot
      StabilizerInput input = landing_in(0.2 - 1.0e-3 * k, Side::kRight);
      input.measured.torso_pitch_rad = x_m / 0.67;
      input.measured.torso_pitch_rate_rad_s = rate_m_s / 0.67;
      (void)step(kConfig, state, input, true);
      rate_m_s += kOmega_per_s * kOmega_per_s * x_m * 1.0e-3;
      x_m += rate_m_s * 1.0e-3;
    }
    const double capture_m = x_m + rate_m_s / kOmega_per_s;
    EXPECT_LT(std::abs(capture_m - state.shift.x_m), 0.5 * std::abs(capture_m)) << sign;
  }
}

TEST(StepAdjustment, SleepsInItsBandAndMovesNoFurtherThanItMay) {
  for (const Side moving : kSides) {
    const double outwards = -lateral_sign(moving);  // the roll towards the moving foot
    StabilizerInput input = landing_in(0.2, moving);
    input.measured.torso_roll_rad = 0.01 * outwards;
    input.measured.torso_pitch_rad = -0.01;
    StepAdjustmentState state;
    EXPECT_EQ(after(state, input, 100).landing_y_m, 0.0);
    EXPECT_EQ(state.shift.x_m, 0.0);
    input.measured.torso_roll_rad = outwards;
    input.measured.torso_pitch_rad = -1.0;
    EXPECT_NEAR(after(state, input, 1000).landing_y_m, lateral_sign(moving) * 0.05, 1e-9);
    EXPECT_NEAR(state.shift.x_m, -0.08, 1e-9);
    input.measured.torso_roll_rad = -outwards;
    EXPECT_NEAR(after(state, input, 1000).landing_y_m, 0.0, 1e-9) << "never onto the other foot";
  }
}

TEST(StepAdjustment, IsFrozenFiftyMillisecondsBeforeTheLandingAndUntilTheNextLift) {
  StepAdjustmentState state;
  StabilizerInput input = landing_in(0.051, Side::kLeft);
  input.measured.torso_pitch_rad = 0.08;
  const double frozen_m = after(state, input, 20).landing_x_m;
  EXPECT_GT(frozen_m, 0.005);
  input.measured.torso_pitch_rad = -0.08;
  EXPECT_LT(after(state, input, 1).landing_x_m, frozen_m);
  const double held_m = state.shift.x_m;
  input.walk.step_time_s += 0.002;
  input.walk.step_share = input.walk.step_time_s / FlatWalk::kStep_s;
  EXPECT_EQ(after(state, input, 40).landing_x_m, held_m);
  input.walk.has_landed = true;
  EXPECT_EQ(after(state, input, 40, false).landing_x_m, held_m);
  EXPECT_NEAR(after(state, standing_on(Side::kLeft, 1.0e-3), 500, false).landing_x_m, 0.0, 1e-6);
}

}  // namespace
}  // namespace surefoot::stabilizer
