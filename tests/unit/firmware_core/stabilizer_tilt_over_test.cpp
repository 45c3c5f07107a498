#include <gtest/gtest.h>

#include "firmware/core/stabilizer/tilt_over.hpp"
#include "tests/unit/firmware_core/compliant_ankle.hpp"
#include "tests/unit/firmware_core/flat_walk.hpp"

namespace surefoot::stabilizer {
namespace {

const TiltOverConfig kConfig{};

Adjustment settled(StabilizerInput input, bool is_active = true) {
  TiltOverState state;
  Adjustment adjustment;
  for (int k = 0; k < 1000; ++k) adjustment = step(kConfig, state, input, is_active);
  return adjustment;
}

TEST(TiltOver, SleepsWithinTheBandAboutTheNominalRoll) {
  StabilizerInput input = standing_on(Side::kLeft, 1.0e-3);
  input.nominal.torso_roll_rad = 0.05;
  input.measured.torso_roll_rad = 0.05 + 0.99 * kConfig.band_rad;
  input.measured.torso_roll_rate_rad_s = -0.99 * kConfig.rate_band_rad_s;
  EXPECT_EQ(settled(input).ankle_roll_rad, (PerSide<double>{}));
}

TEST(TiltOver, TurnsTheStanceAnkleByWhatIsBeyondTheBand) {
  for (const Side side : kSides) {
    StabilizerInput input = standing_on(side, 1.0e-3);
    input.measured.torso_roll_rad = -kConfig.band_rad - 0.01;
    input.measured.torso_roll_rate_rad_s = -kConfig.rate_band_rad_s - 0.1;
    const Adjustment adjustment = settled(input);
    EXPECT_NEAR(adjustment.ankle_roll_rad[index(side)], -(1.0 * 0.01 + 0.05 * 0.1), 1e-9);
    EXPECT_EQ(adjustment.ankle_roll_rad[index(opposite(side))], 0.0);
  }
}

TEST(TiltOver, IsLimitedAndNeedsAFootThatCarries) {
  StabilizerInput input = standing_on(Side::kRight, 1.0e-3);
  input.measured.torso_roll_rad = 1.0;
  EXPECT_NEAR(settled(input).ankle_roll_rad[0], kConfig.max_angle_rad, 1e-9);
  input.ankle[0].normal_force_n = 48.0;
  EXPECT_EQ(settled(input).ankle_roll_rad[0], 0.0);
}

// A body pushed to the left on its right foot swings out of the band; with the controller it swings less far.
TEST(TiltOver, LessensTheSwingOfABodyThatIsPushed) {
  for (const double rate_rad_s : {0.5, -0.5}) {
    PerSide<double> farthest_rad{};
    for (const bool is_active : {false, true}) {
      CompliantAnkle plant{.rate_rad_s = rate_rad_s};
      TiltOverState state;
      for (int k = 0; k < 1000; ++k) {
        StabilizerInput input = standing_on(Side::kRight, 1.0e-3);
        lean_left(input, plant, state.added_roll_rad[0]);
        plant.advance(step(kConfig, state, input, is_active).ankle_roll_rad[0], 1.0e-3);
        double& farthest = farthest_rad[is_active ? 1 : 0];
        farthest = std::max(farthest, std::abs(plant.lean_rad));
      }
    }
    EXPECT_LT(farthest_rad[1], 0.85 * farthest_rad[0]);
  }
}

}  // namespace
}  // namespace surefoot::stabilizer
