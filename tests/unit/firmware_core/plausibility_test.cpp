#include "firmware/core/safety/plausibility.hpp"

#include <gtest/gtest.h>

namespace surefoot::safety {
namespace {

constexpr double kPeriodS = 1.0e-3;

SensorSnapshot fresh_sensors() {
  SensorSnapshot sensors;
  for (std::size_t i = 0; i < 2; ++i) {
    sensors.leg[i].freshness.age_ticks = sensors.foot[i].freshness.age_ticks = 0;
    sensors.foot[i].corner_force_n.fill(98.1);
  }
  sensors.torso.specific_force_body_m_s2 = {0.0, 0.0, 9.81};
  sensors.torso.freshness.age_ticks = 0;
  return sensors;
}

/// The finding after so many ticks of the same sensors.
Finding after(int ticks, const SensorSnapshot& sensors, bool is_moving) {
  PlausibilityState state;
  Finding found;
  static_cast<void>(check_sensors({}, state, fresh_sensors(), is_moving, 784.8, kPeriodS));
  for (int i = 0; i < ticks; ++i) found = check_sensors({}, state, sensors, is_moving, 784.8, kPeriodS);
  return found;
}

TEST(Plausibility, FindsNothingInARobotThatStands) {
  EXPECT_EQ(after(20'000, fresh_sensors(), false).fault, Fault::kNone);
  EXPECT_EQ(after(20'000, fresh_sensors(), false).needs, SafeState::kNone);
}

TEST(Plausibility, HoldsTheStanceForAFootOrTheImuAndDampsForAnEncoder) {
  SensorSnapshot foot = fresh_sensors();
  foot.foot[0].corner_force_n.fill(0.0);
  foot.foot[1].corner_force_n.fill(0.0);
  EXPECT_EQ(after(500, foot, false).fault, Fault::kSensorImplausible);
  EXPECT_EQ(after(500, foot, false).needs, SafeState::kStanceHold);

  SensorSnapshot imu = fresh_sensors();
  imu.torso.angular_rate_body_rad_s = {0.1, 0.0, 0.0};
  for (FootSensors& each : imu.foot) each.freshness.age_ticks = 1;  // whose frozen cells would be found as well
  EXPECT_EQ(after(600, imu, true).fault, Fault::kSensorImplausible);
  EXPECT_EQ(after(600, imu, true).needs, SafeState::kStanceHold);

  SensorSnapshot encoder = foot;  // the worse of two counts
  encoder.leg[1].rate_rad_s[0] = 1.0;
  EXPECT_EQ(after(500, encoder, false).fault, Fault::kSensorImplausible);
  EXPECT_EQ(after(500, encoder, false).needs, SafeState::kDamp);
}

}  // namespace
}  // namespace surefoot::safety
