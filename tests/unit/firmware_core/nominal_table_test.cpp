#include "firmware/core/stabilizer/nominal_table.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace surefoot::stabilizer {
namespace {

TEST(NominalTable, IsLinearBetweenItsPlacesAndEndsAtItsLast) {
  NominalTable table;
  for (std::size_t i = 0; i < NominalTable::kPlaces; ++i) {
    table.of_left_step[i].torso_pitch_rad = static_cast<double>(i);
  }
  const double place = 1.0 / NominalTable::kPlaces;
  EXPECT_NEAR(table.at(Side::kLeft, 0.0).torso_pitch_rad, 0.0, 1e-12);
  EXPECT_NEAR(table.at(Side::kLeft, 2.25 * place).torso_pitch_rad, 2.25, 1e-9);
  EXPECT_NEAR(table.at(Side::kLeft, 1.0).torso_pitch_rad, NominalTable::kPlaces - 1.0, 1e-9);
  EXPECT_NEAR(table.at(Side::kLeft, 7.0).torso_pitch_rad, NominalTable::kPlaces - 1.0, 1e-9);
}

TEST(NominalTable, MirrorsWhatPointsSidewaysForTheRightFootsStep) {
  NominalTable table;
  table.of_left_step.fill({.torso_roll_rad = 1.0,
                           .torso_pitch_rad = 2.0,
                           .torso_roll_rate_rad_s = 3.0,
                           .torso_pitch_rate_rad_s = 4.0,
                           .zmp_x_foot_m = 5.0,
                           .zmp_y_foot_m = 6.0,
                           .support_roll_rate_rad_s = 7.0});
  const PhaseSample right = table.at(Side::kRight, 0.3);
  EXPECT_EQ(right.torso_roll_rad, -1.0);
  EXPECT_EQ(right.torso_pitch_rad, 2.0);
  EXPECT_EQ(right.torso_roll_rate_rad_s, -3.0);
  EXPECT_EQ(right.torso_pitch_rate_rad_s, 4.0);
  EXPECT_EQ(right.zmp_x_foot_m, 5.0);
  EXPECT_EQ(right.zmp_y_foot_m, -6.0);
  EXPECT_EQ(right.support_roll_rate_rad_s, -7.0);
}

// A table that was lost, or of another robot, would not look like this: the body leans towards the swing foot by about
// a degree and the pressure centre lies inside the sole.
TEST(NominalTable, RecordedOnesAreThoseOfAWalk) {
  for (const gait::SwayProfile sway : {gait::SwayProfile::kSine, gait::SwayProfile::kPendulum}) {
    for (const double length_m : {0.0, 0.2}) {
      const NominalTable table = recorded_table(sway, length_m);
      double largest_roll_rad = 0.0;
      for (const PhaseSample& sample : table.of_left_step) {
        largest_roll_rad = std::max(largest_roll_rad, std::abs(sample.torso_roll_rad));
        EXPECT_LE(std::abs(sample.zmp_y_foot_m), 0.07);
        EXPECT_LE(sample.zmp_x_foot_m, 0.128);
        EXPECT_GE(sample.zmp_x_foot_m, -0.105);
      }
      EXPECT_GT(largest_roll_rad, 0.004);
      EXPECT_LT(largest_roll_rad, 0.035);
    }
  }
}

// By a pendulum's sway the pressure centre rests under the foot in the middle of the step; by a sine it swings through.
TEST(NominalTable, TheSwaysDifferInWhereThePressureCentreIs) {
  const auto swing_m = [](gait::SwayProfile sway) {
    const NominalTable table = recorded_table(sway, 0.0);
    double least_m = 1.0;
    double most_m = -1.0;
    for (std::size_t i = NominalTable::kPlaces / 4; i < 3 * NominalTable::kPlaces / 4; ++i) {
      least_m = std::min(least_m, table.of_left_step[i].zmp_y_foot_m);
      most_m = std::max(most_m, table.of_left_step[i].zmp_y_foot_m);
    }
    return most_m - least_m;
  };
  EXPECT_LT(swing_m(gait::SwayProfile::kPendulum), 0.5 * swing_m(gait::SwayProfile::kSine));
}

}  // namespace
}  // namespace surefoot::stabilizer
