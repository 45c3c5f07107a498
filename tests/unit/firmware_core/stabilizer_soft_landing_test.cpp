#include <gtest/gtest.h>

#include "firmware/core/stabilizer/soft_landing.hpp"
#include "tests/unit/firmware_core/flat_walk.hpp"

namespace surefoot::stabilizer {
namespace {

const SoftLandingConfig kConfig{};

/// The left foot has just come down; the floor turns it by these moments.
StabilizerInput landing(double roll_moment_nm, double pitch_moment_nm) {
  StabilizerInput input = standing_on(Side::kRight, 1.0e-3);
  input.walk.stage = decision::WalkStage::kLowerLeft;
  input.walk.is_double_support = true;
  input.walk.has_landed = true;
  input.ankle[index(Side::kLeft)] = {300.0, roll_moment_nm, pitch_moment_nm};
  input.ankle[index(Side::kRight)] = {300.0, 40.0, 40.0};
  return input;
}

// u (C s + K) = T beyond the band: after one time constant C / K, 63.2 % of T / K. Positive roll moments carry the left
// edge, which then has to rise, and a right-handed turn about x lifts it; the heel likewise with pitch.
TEST(SoftLanding, YieldsToTheFloorAsASpringAndADamperDo) {
  SoftLandingState state;
  const StabilizerInput input = landing(kConfig.band_nm + 10.0, -kConfig.band_nm - 20.0);
  Adjustment adjustment;
  for (int k = 0; k < 50; ++k) adjustment = step(kConfig, state, input, true);
  const double reached = 1.0 - std::exp(-1.0);
  EXPECT_NEAR(adjustment.ankle_roll_rad[index(Side::kLeft)], reached * 10.0 / 1000.0, 1e-9);
  EXPECT_NEAR(adjustment.ankle_pitch_rad[index(Side::kLeft)], -reached * 20.0 / 1000.0, 1e-9);
  EXPECT_EQ(adjustment.ankle_roll_rad[index(Side::kRight)], 0.0);
}

TEST(SoftLanding, LeavesAFlatLandingAlone) {
  SoftLandingState state;
  for (int k = 0; k < 100; ++k) {
    const Adjustment adjustment = step(kConfig, state, landing(4.9, -4.9), true);
    EXPECT_EQ(adjustment.ankle_roll_rad[1], 0.0);
    EXPECT_EQ(adjustment.ankle_pitch_rad[1], 0.0);
  }
}

TEST(SoftLanding, TurnsNoFurtherThanItsLimit) {
  SoftLandingState state;
  Adjustment adjustment;
  for (int k = 0; k < 2000; ++k) adjustment = step(kConfig, state, landing(60.0, 60.0), true);
  EXPECT_NEAR(adjustment.ankle_roll_rad[1], kConfig.max_angle_rad, 1e-9);
  EXPECT_NEAR(adjustment.ankle_pitch_rad[1], kConfig.max_angle_rad, 1e-9);
}

TEST(SoftLanding, ComesBackInTheAir) {
  SoftLandingState state;
  for (int k = 0; k < 100; ++k) (void)step(kConfig, state, landing(30.0, 0.0), true);
  StabilizerInput airborne = standing_on(Side::kRight, 1.0e-3);
  airborne.ankle[index(Side::kLeft)] = {20.0, 30.0, 0.0};
  for (int k = 0; k < 900; ++k) (void)step(kConfig, state, airborne, true);
  EXPECT_NEAR(state.added_angle[1].roll_rad, 0.0, 0.002);
}

TEST(SoftLanding, WaitsForContactWhileTheFootComesDown) {
  SoftLandingState state;
  const SoftLandingConfig config;
  EXPECT_TRUE(step(config, state, landing(0.0, 0.0), true).waits_for_contact);
  // Before the contact the schedule does not let it act; that is when the wait is needed.
  EXPECT_TRUE(step(config, state, landing(0.0, 0.0), false).waits_for_contact);
  EXPECT_FALSE(step(config, state, standing_on(Side::kRight, 1.0e-3), true).waits_for_contact);
}

}  // namespace
}  // namespace surefoot::stabilizer
