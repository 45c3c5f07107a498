#include "firmware/can/physical_range.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "firmware/can/generated/surefoot.h"

namespace surefoot::can {
namespace {

// Converting NaN to an integer is undefined; x86-64 happens to give raw bits that also read as zero, so
// that no frame shows the difference.
TEST(PhysicalRange, GivesZeroForNanBeforeAnythingIsConverted) {
  EXPECT_EQ(kJointAngleRad.clamp(std::numeric_limits<double>::quiet_NaN()), 0.0);
  EXPECT_EQ(kJointAngleRad.clamp(-std::numeric_limits<double>::quiet_NaN()), 0.0);
}

TEST(PhysicalRange, LeavesWhatIsInsideAndTakesTheNearerEndForTheRest) {
  EXPECT_EQ(kCornerForceN.clamp(123.4), 123.4);
  EXPECT_EQ(kCornerForceN.clamp(-501.0), -500.0);
  EXPECT_EQ(kCornerForceN.clamp(std::numeric_limits<double>::infinity()), 3200.0);
}

void expect_the_dbcs(PhysicalRange range, bool (*is_in_phys_range)(double)) {
  constexpr double kBeyond = 1e-9;
  EXPECT_TRUE(is_in_phys_range(range.lowest));
  EXPECT_TRUE(is_in_phys_range(range.highest));
  EXPECT_FALSE(is_in_phys_range(range.lowest - kBeyond));
  EXPECT_FALSE(is_in_phys_range(range.highest + kBeyond));
}

TEST(PhysicalRange, IsTheOneInTheDbc) {
  expect_the_dbcs(kJointAngleRad, surefoot_leg_state_left_knee_pitch_angle_rad_is_in_phys_range);
  expect_the_dbcs(kJointRateRadS, surefoot_leg_state_left_knee_pitch_rate_rad_s_is_in_phys_range);
  expect_the_dbcs(kJointTorqueNm, surefoot_leg_state_left_knee_pitch_torque_nm_is_in_phys_range);
  expect_the_dbcs(kJointTorqueNm, surefoot_leg_command_left_knee_pitch_torque_nm_is_in_phys_range);
  expect_the_dbcs(kCornerForceN, surefoot_foot_force_left_rear_left_force_n_is_in_phys_range);
  expect_the_dbcs(kAngularRateRadS, surefoot_imu_angular_rate_y_body_rad_s_is_in_phys_range);
  expect_the_dbcs(kSpecificForceMS2, surefoot_imu_specific_force_y_body_m_s2_is_in_phys_range);
  expect_the_dbcs(kJointAngleRad, surefoot_leg_position_left_knee_pitch_angle_rad_is_in_phys_range);
  expect_the_dbcs(kAngularRateRadS, surefoot_leg_inertial_left_hip_roll_rate_rad_s_is_in_phys_range);
  expect_the_dbcs(kSoleTiltRad, surefoot_foot_inertial_left_sole_pitch_rad_is_in_phys_range);
  expect_the_dbcs(kSpecificForceMS2, surefoot_foot_inertial_left_specific_force_y_foot_m_s2_is_in_phys_range);
}

}  // namespace
}  // namespace surefoot::can
