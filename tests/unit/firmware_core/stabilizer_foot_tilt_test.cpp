#include <gtest/gtest.h>

#include "firmware/core/stabilizer/foot_tilt.hpp"
#include "tests/unit/firmware_core/compliant_ankle.hpp"
#include "tests/unit/firmware_core/flat_walk.hpp"

namespace surefoot::stabilizer {
namespace {

const FootTiltConfig kConfig{.slope_time_constant_s = 1e9, .edge = {}};  // takes nothing for the floor's slope

Adjustment settled(const StabilizerInput& input) {
  FootTiltState state;
  Adjustment adjustment;
  for (int k = 0; k < 2000; ++k) adjustment = step(kConfig, state, input, true);
  return adjustment;
}

// A sole that rolls to the right leans the body by the same angle to the right (against the plant's sign); 70 % of it
// at the joint leans it back by 70 %.
TEST(FootTilt, LeavesThreeTenthsOfWhatATiltedTileLeansTheBody) {
  for (const double tile_rad : {0.03, -0.03}) {
    StabilizerInput input = standing_on(Side::kLeft, 1.0e-3);
    input.foot_roll_rad = {0.5, tile_rad};
    input.foot_pitch_rad = {0.5, -tile_rad};
    const Adjustment adjustment = settled(input);
    const auto lean_rad = [](double command_rad) {
      const CompliantAnkle plant;
      return plant.spring_per_s2() * command_rad / (plant.mode_rad_s() * plant.mode_rad_s());
    };
    EXPECT_NEAR(lean_rad(-tile_rad + adjustment.ankle_roll_rad[1]), 0.3 * lean_rad(-tile_rad), 1e-9);
    EXPECT_NEAR(lean_rad(tile_rad + adjustment.ankle_pitch_rad[1]), 0.3 * lean_rad(tile_rad), 1e-9);
    EXPECT_EQ(adjustment.ankle_roll_rad[0], 0.0) << "a foot in the air follows nothing";
  }
}

TEST(FootTilt, IsOffWhileStandingAndLimitedElsewhere) {
  StabilizerInput input = standing_on(Side::kLeft, 1.0e-3);
  input.foot_roll_rad = {0.0, 1.0};
  EXPECT_NEAR(settled(input).ankle_roll_rad[1], kConfig.max_angle_rad, 1e-9);
  input.walk = {};
  EXPECT_EQ(settled(input).ankle_roll_rad[1], 0.0);
}

// The whole floor's slope is the upright pose's to answer; a tile on it is ours.
TEST(FootTilt, IsSilentOnAFloorThatLeansAsAWholeAndAnswersATileOnIt) {
  FootTiltState state;
  StabilizerInput input = standing_on(Side::kLeft, 1.0e-3);
  input.foot_roll_rad = {0.05, 0.05};
  Adjustment adjustment;
  for (int k = 0; k < 40'000; ++k) adjustment = step(FootTiltConfig{}, state, input, true);
  EXPECT_NEAR(adjustment.ankle_roll_rad[1], 0.0, 1e-4);
  input.foot_roll_rad[1] = 0.07;
  for (int k = 0; k < 200; ++k) adjustment = step(FootTiltConfig{}, state, input, true);
  EXPECT_NEAR(adjustment.ankle_roll_rad[1], 0.7 * 0.02, 1.5e-3);
}

TEST(FootTilt, IsLowPassed) {
  FootTiltState state;
  StabilizerInput input = standing_on(Side::kLeft, 1.0e-3);
  input.foot_pitch_rad = {0.0, 0.02};
  Adjustment adjustment;
  for (int k = 0; k < 50; ++k) adjustment = step(kConfig, state, input, true);
  EXPECT_NEAR(adjustment.ankle_pitch_rad[1], 0.014 * (1.0 - std::exp(-1.0)), 1e-9);
}

}  // namespace
}  // namespace surefoot::stabilizer
