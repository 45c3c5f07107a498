#include <gtest/gtest.h>

#include "firmware/core/stabilizer/tilt_landing_position.hpp"
#include "tests/unit/firmware_core/flat_walk.hpp"

namespace surefoot::stabilizer {
namespace {

const TiltLandingPositionConfig kConfig{};

/// The `moving` foot comes down while the torso leans this much more than on flat floor.
StabilizerInput lowering(Side moving, double roll_rad, double pitch_rad) {
  StabilizerInput input = coming_down(moving, 1.0e-3);
  input.nominal.torso_roll_rad = 0.02;
  input.measured.torso_roll_rad = 0.02 + roll_rad;
  input.measured.torso_pitch_rad = pitch_rad;
  return input;
}

Adjustment after(TiltLandingPositionState& state, const StabilizerInput& input, int ticks, bool is_active = true) {
  Adjustment adjustment;
  for (int k = 0; k < ticks; ++k) adjustment = step(kConfig, state, input, is_active);
  return adjustment;
}

TEST(TiltLandingPosition, PutsTheFootToWhereTheTorsoFalls) {
  TiltLandingPositionState left;
  StabilizerInput input = lowering(Side::kLeft, -0.03, 0.04);
  input.measured.torso_roll_rate_rad_s = -0.05;
  const Adjustment adjustment = after(left, input, 1000);
  EXPECT_NEAR(adjustment.landing_y_m, 0.3 * 0.03 + 0.08 * 0.05 - kConfig.band_m, 1e-9);
  EXPECT_NEAR(adjustment.landing_x_m, 0.3 * 0.04 - kConfig.band_m, 1e-9);
  TiltLandingPositionState right;
  const Adjustment backwards = after(right, lowering(Side::kRight, 0.03, -0.04), 1000);
  EXPECT_NEAR(backwards.landing_y_m, -0.3 * 0.03 + kConfig.band_m, 1e-9);
  EXPECT_NEAR(backwards.landing_x_m, -0.3 * 0.04 + kConfig.band_m, 1e-9);
}

TEST(TiltLandingPosition, MovesThirtyMillimetresAtTheMostAndNeverOntoTheOtherFoot) {
  for (const Side moving : kSides) {
    TiltLandingPositionState state;
    const double outwards = -lateral_sign(moving);  // the roll towards the moving foot
    const Adjustment far = after(state, lowering(moving, outwards, 1.0), 1000);
    EXPECT_NEAR(far.landing_y_m, lateral_sign(moving) * 0.03, 1e-9);
    EXPECT_NEAR(far.landing_x_m, 0.03, 1e-9);
    TiltLandingPositionState inwards;
    EXPECT_EQ(after(inwards, lowering(moving, -outwards, 0.0), 1000).landing_y_m, 0.0);
  }
}

TEST(TiltLandingPosition, SettlesBeforeTheLandingStaysThroughItAndFadesWithTheNextLift) {
  TiltLandingPositionState state;
  StabilizerInput input = lowering(Side::kLeft, -0.05, 0.0);
  const double settled_m = after(state, input, 400).landing_y_m;
  EXPECT_GT(settled_m, 0.005);
  input.walk.swing_share = 0.96;
  input.measured.torso_roll_rad = 0.5;
  EXPECT_EQ(after(state, input, 50).landing_y_m, settled_m);
  input.walk.is_double_support = true;
  input.walk.has_landed = true;
  EXPECT_EQ(after(state, input, 50).landing_y_m, settled_m);
  EXPECT_NEAR(after(state, standing_on(Side::kLeft, 1.0e-3), 500, false).landing_y_m, 0.0, 1e-5);
}

TEST(TiltLandingPosition, StaysFromAnEarlyLandingOn) {
  TiltLandingPositionState state;
  StabilizerInput input = lowering(Side::kRight, 0.05, 0.05);
  const Adjustment before = after(state, input, 50);
  input.walk.has_landed = true;
  const Adjustment landed = after(state, input, 50);
  EXPECT_EQ(landed.landing_x_m, before.landing_x_m);
  EXPECT_EQ(landed.landing_y_m, before.landing_y_m);
}

}  // namespace
}  // namespace surefoot::stabilizer
