#include "firmware/core/estimation/ankle_load.hpp"

#include <gtest/gtest.h>

namespace surefoot::estimation {
namespace {

const geometry::RobotGeometry kRobot{.sole_heel_m = 0.1, .sole_toe_m = 0.13, .sole_width_m = 0.14};

TEST(AnkleLoad, FormsForceMomentsAndPressureCentreFromTheFourCells) {
  FootSensors foot;
  foot.corner_force_n = {200.0, 100.0, 60.0, 40.0};  // front left, front right, rear left, rear right
  const AnkleLoad load = ankle_load(kRobot, foot);
  EXPECT_DOUBLE_EQ(load.normal_force_n, 400.0);
  EXPECT_NEAR(load.roll_moment_nm, 0.07 * (200.0 - 100.0 + 60.0 - 40.0), 1e-12);
  EXPECT_NEAR(load.pitch_moment_nm, -(0.13 * 300.0 - 0.1 * 100.0), 1e-12);
  EXPECT_NEAR(load.zmp_x_foot_m(), (0.13 * 300.0 - 0.1 * 100.0) / 400.0, 1e-12);
  EXPECT_NEAR(load.zmp_y_foot_m(), 0.07 * 120.0 / 400.0, 1e-12);
}

// 5 kgf (Kim, Park, Oh 2007): a foot that hardly touches has no pressure centre.
TEST(AnkleLoad, HasNoPressureCentreBelowTheContactForce) {
  FootSensors foot;
  foot.corner_force_n = {48.0, 0.0, 0.0, 0.0};
  EXPECT_FALSE(ankle_load(kRobot, foot).carries());
  EXPECT_EQ(ankle_load(kRobot, foot).zmp_x_foot_m(), 0.0);
  foot.corner_force_n = {49.5, 0.0, 0.0, 0.0};
  EXPECT_TRUE(ankle_load(kRobot, foot).carries());
  EXPECT_NEAR(ankle_load(kRobot, foot).zmp_x_foot_m(), 0.13, 1e-12);
}

// Table 2: 1,000 N and 60 N m.
TEST(AnkleLoad, IsClippedToTheSensorsRange) {
  FootSensors foot;
  foot.corner_force_n = {900.0, 900.0, 0.0, 0.0};
  const AnkleLoad load = ankle_load(kRobot, foot);
  EXPECT_EQ(load.normal_force_n, 1000.0);
  EXPECT_EQ(load.pitch_moment_nm, -60.0);
}

}  // namespace
}  // namespace surefoot::estimation
