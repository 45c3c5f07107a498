#include <gtest/gtest.h>

#include "firmware/core/stabilizer/landing_timing.hpp"
#include "tests/unit/firmware_core/stabilizer_moments.hpp"

namespace surefoot::stabilizer {
namespace {

constexpr double kSwing_s = 0.9025;
constexpr double kDouble_s = 0.0475;

/// One swing in which the body turns back toward the swing foot at `turn_s` of the step, `nominal_turn_s` on the flat.
/// @return what the landing is ordered at its end
Adjustment swing(const LandingTimingConfig& config, LandingTimingState& state, Side foot, double turn_s,
                 double nominal_turn_s, double period_s = 1e-3, double noise_rad_s = 0.0) {
  Adjustment made;
  const auto ticks = static_cast<int>(kSwing_s / period_s);
  for (int tick = 0; tick < ticks; ++tick) {
    const double share = tick * period_s / kSwing_s;
    StabilizerInput input =
        share < 0.5 ? testing::lifting(foot, share, period_s) : testing::lowering(foot, share, period_s);
    const double toward_left = foot == Side::kLeft ? -1.0 : 1.0;  // roll rate of a body that goes to the swing foot
    const double noise = tick % 2 == 0 ? noise_rad_s : -noise_rad_s;
    input.measured.support_roll_rate_rad_s = toward_left * (input.walk.step_time_s - turn_s + noise);
    input.nominal.support_roll_rate_rad_s = toward_left * (input.walk.step_time_s - nominal_turn_s);
    made = step(config, state, input, share >= 0.5);
  }
  return made;
}

TEST(LandingTiming, LandsAnInwardTiltEarlierByWhatTheTurnLacksToTheWindow) {
  for (const double period_s : {0.25e-3, 1e-3, 10e-3}) {
    for (const Side foot : kSides) {
      LandingTimingState state;
      // A = 0.6 - 0.05, so E = 0.55 - 0.47.
      EXPECT_NEAR(swing({}, state, foot, 0.47, 0.6, period_s).earlier_landing_s, 0.08, 1e-6);
    }
  }
}

TEST(LandingTiming, KnowsTheNominalTurnFromTheStepBefore) {
  LandingTimingState state;
  (void)swing({}, state, Side::kLeft, 0.6, 0.6);
  Adjustment made;
  for (double share = 0.0; share < 0.58; share += 1e-3) {
    StabilizerInput input = share < 0.5 ? testing::lifting(Side::kLeft, share) : testing::lowering(Side::kLeft, share);
    input.measured.support_roll_rate_rad_s = -(input.walk.step_time_s - 0.4);
    input.nominal.support_roll_rate_rad_s = -(input.walk.step_time_s - 0.6);
    made = step(LandingTimingConfig{}, state, input, share >= 0.5);
  }
  EXPECT_NEAR(made.earlier_landing_s, 0.15, 1e-6) << "0.03 s before flat walking turns";
}

// Kim, Park, Oh 2007, section 3.2.4: the window about the foot's largest height, here at 0.0475 + 0.45125 s.
TEST(LandingTiming, KeepsThePrintedWindowToo) {
  LandingTimingConfig config;
  config.uses_nominal = false;
  LandingTimingState state;
  const double top_s = kDouble_s + 0.5 * kSwing_s;
  EXPECT_NEAR(swing(config, state, Side::kRight, 0.40, 0.6).earlier_landing_s, top_s - 0.05 - 0.40, 1.1e-3);
}

TEST(LandingTiming, KeepsThePatternsTimeWithinTheWindowAndAfterIt) {
  for (const double turn_s : {0.56, 0.6, 0.69, 0.8, 2.0}) {
    LandingTimingState state;
    EXPECT_EQ(swing({}, state, Side::kLeft, turn_s, 0.6).earlier_landing_s, 0.0) << turn_s;
  }
}

TEST(LandingTiming, NeverAdvancesByMoreThanThreeTenthsOfAStep) {
  LandingTimingState state;
  EXPECT_DOUBLE_EQ(swing({}, state, Side::kLeft, 0.1, 0.6).earlier_landing_s, 0.285);
}

TEST(LandingTiming, SeesTheTurnThroughTheGyrosNoise) {
  LandingTimingState state;
  EXPECT_NEAR(swing({}, state, Side::kLeft, 0.47, 0.6, 1e-3, 0.015).earlier_landing_s, 0.08, 0.003);
}

TEST(LandingTiming, WaitsForContactWhileTheFootIsLoweredAndInDoubleSupport) {
  LandingTimingState state;
  StabilizerInput late = testing::lowering(Side::kLeft, 1.0);
  late.walk.is_waiting = true;
  EXPECT_TRUE(step(LandingTimingConfig{}, state, late, true).waits_for_contact);
  EXPECT_TRUE(step(LandingTimingConfig{}, state, testing::landed(Side::kLeft, 300.0), true).waits_for_contact);
  EXPECT_FALSE(step(LandingTimingConfig{}, state, testing::lifting(Side::kRight, 0.1), false).waits_for_contact);
}

TEST(LandingTiming, KeepsTheOrderThroughTheDoubleSupportAndTakesItBackInTheNextLift) {
  LandingTimingState state;
  const double ordered_s = swing({}, state, Side::kLeft, 0.47, 0.6).earlier_landing_s;
  for (int tick = 0; tick < 100; ++tick) {
    EXPECT_EQ(step(LandingTimingConfig{}, state, testing::landed(Side::kLeft, 300.0), true).earlier_landing_s,
              ordered_s);
  }
  (void)swing({}, state, Side::kRight, 0.6, 0.6);
  EXPECT_EQ(state.earlier_s, 0.0);
}

}  // namespace
}  // namespace surefoot::stabilizer
