#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "firmware/core/stabilizer/shock_absorber.hpp"
#include "tests/unit/firmware_core/stabilizer_moments.hpp"

namespace surefoot::stabilizer {
namespace {

StabilizerInput early_contact(double force_n, double period_s = 1e-3) {
  StabilizerInput input = testing::lowering(Side::kLeft, 0.8, period_s);
  input.walk.has_landed = true;
  input.ankle[index(Side::kLeft)].normal_force_n = force_n;
  return input;
}

// m 28 kg, c 1500 N s/m, k 20 kN/m: poles at -25 and -200/7 1/s.
TEST(ShockAbsorber, AnswersAForceLikeMassSpringAndDamper) {
  const double slow = -25.0;
  const double fast = -200.0 / 7.0;
  for (const double period_s : {0.25e-3, 1e-3, 10e-3}) {
    ShockAbsorberState state;
    double time_s = 0.0;
    for (int tick = 0; tick < static_cast<int>(0.3 / period_s); ++tick) {
      const Adjustment made = step(ShockAbsorberConfig{}, state, early_contact(400.0, period_s), true);
      time_s += period_s;
      const double step_response =
          1.0 + (fast * std::exp(slow * time_s) - slow * std::exp(fast * time_s)) / (slow - fast);
      ASSERT_NEAR(made.pelvis_z_m, -400.0 / 2e4 * step_response, 1e-5) << time_s;
    }
  }
}

TEST(ShockAbsorber, StopsTheLoweringAtAnEarlyContactOnly) {
  ShockAbsorberState state;
  EXPECT_FALSE(step(ShockAbsorberConfig{}, state, testing::lowering(Side::kLeft, 0.8), true).holds_lowering);
  EXPECT_FALSE(step(ShockAbsorberConfig{}, state, early_contact(48.0), true).holds_lowering);
  EXPECT_TRUE(step(ShockAbsorberConfig{}, state, early_contact(50.0), true).holds_lowering);
  EXPECT_TRUE(step(ShockAbsorberConfig{}, state, early_contact(10.0), true).holds_lowering) << "chatter";
  EXPECT_TRUE(step(ShockAbsorberConfig{}, state, testing::landed(Side::kLeft, 500.0), true).holds_lowering);
  EXPECT_FALSE(step(ShockAbsorberConfig{}, state, testing::lifting(Side::kRight, 0.0), false).holds_lowering);
  for (const double force_n : {300.0, 549.0}) {
    const Adjustment planned = step(ShockAbsorberConfig{}, state, testing::landed(Side::kRight, force_n), true);
    EXPECT_FALSE(planned.holds_lowering);
    EXPECT_LE(std::abs(planned.pelvis_z_m), 1e-4);
  }
}

/// Largest force when half the robot comes down at 0.3 m/s on a leg of 50 kN/m.
double peak_force_n(bool is_absorbing) {
  constexpr double kMass_kg = 28.0;
  constexpr double kStep_s = 1e-3;
  ShockAbsorberState state;
  double depth_m = 0.0;
  double speed_m_s = 0.3;
  double offset_m = 0.0;
  double peak_n = 0.0;
  for (int tick = 0; tick < 150; ++tick) {
    const double force_n = std::max(0.0, 5e4 * (depth_m + offset_m));
    peak_n = std::max(peak_n, force_n);
    speed_m_s += kStep_s * (9.81 - force_n / kMass_kg);
    depth_m += kStep_s * speed_m_s;
    if (is_absorbing) offset_m = step(ShockAbsorberConfig{}, state, early_contact(force_n), true).pelvis_z_m;
  }
  return peak_n;
}

TEST(ShockAbsorber, LowersThePeakForceOfALandingByAFifthAtLeast) {
  EXPECT_LE(peak_force_n(true), 0.8 * peak_force_n(false));
}

TEST(ShockAbsorber, StaysWithinItsStrokeAndWashesOut) {
  ShockAbsorberState state;
  Adjustment made;
  for (int tick = 0; tick < 500; ++tick) {
    made = step(ShockAbsorberConfig{}, state, early_contact(1000.0), true);
    ASSERT_GE(made.pelvis_z_m, -0.03);
    ASSERT_LE(made.pelvis_z_m, 0.0);
  }
  EXPECT_DOUBLE_EQ(made.pelvis_z_m, -0.03);
  for (int tick = 0; tick < 200; ++tick) {
    made = step(ShockAbsorberConfig{}, state, testing::lifting(Side::kRight, 0.1), false);
  }
  EXPECT_NEAR(made.pelvis_z_m, -0.03 * std::exp(-1.0), 1e-9);
}

}  // namespace
}  // namespace surefoot::stabilizer
