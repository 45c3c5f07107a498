#include "firmware/core/estimation/attitude.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace surefoot::estimation {
namespace {

using geometry::Vector3;

ImuSensors at_rest(double roll_rad, double pitch_rad) {
  ImuSensors imu;
  const geometry::Matrix3 world_from_body =
      (Eigen::AngleAxisd(pitch_rad, Vector3::UnitY()) * Eigen::AngleAxisd(roll_rad, Vector3::UnitX()))
          .toRotationMatrix();
  imu.specific_force_body_m_s2 = world_from_body.transpose() * Vector3(0.0, 0.0, 9.81);
  imu.freshness.age_ticks = 0;
  return imu;
}

TEST(Attitude, BeginsWithWhatTheAccelerometerFeels) {
  AttitudeState state;
  const Attitude torso = step({}, state, at_rest(0.05, -0.08), 1e-3);
  EXPECT_NEAR(torso.roll_rad, 0.05, 1e-12);
  EXPECT_NEAR(torso.pitch_rad, -0.08, 1e-12);
}

// phi(t) = 0.1 sin(2 pi t) with the accelerometer of a torso that only turns: exact but for the steps of a tick.
TEST(Attitude, FollowsATorsoThatTurns) {
  AttitudeState state;
  constexpr double kTick_s = 1e-3;
  static_cast<void>(step({}, state, at_rest(0.0, 0.0), kTick_s));
  for (int i = 1; i <= 3000; ++i) {
    const double t = i * kTick_s;
    ImuSensors imu = at_rest(0.1 * std::sin(2.0 * std::numbers::pi * t), 0.0);
    imu.angular_rate_body_rad_s.x() = 0.2 * std::numbers::pi * std::cos(2.0 * std::numbers::pi * (t - 0.5 * kTick_s));
    const Attitude torso = step({}, state, imu, kTick_s);
    ASSERT_NEAR(torso.roll_rad, 0.1 * std::sin(2.0 * std::numbers::pi * t), 2e-4) << t;
    ASSERT_EQ(torso.roll_rate_rad_s, imu.angular_rate_body_rad_s.x());
  }
}

// A walking torso is shaken to and fro; over a cycle that cancels.
TEST(Attitude, IsHardlyMovedByAccelerationsThatCancelOut) {
  AttitudeState state;
  ImuSensors imu = at_rest(0.0, 0.0);
  static_cast<void>(step({}, state, imu, 1e-3));
  double largest_rad = 0.0;
  for (int i = 0; i < 20'000; ++i) {
    imu.specific_force_body_m_s2.y() = 0.65 * std::sin(3.3 * i * 1e-3);  // 60 mm of sway
    largest_rad = std::max(largest_rad, std::abs(step({}, state, imu, 1e-3).roll_rad));
  }
  EXPECT_LT(largest_rad, 0.0145);  // 2 x 0.066 / (3.3 x 3 s) at its first swing
}

TEST(Attitude, AGyroThatIsOffCostsItsOffsetTimesTheTimeConstant) {
  AttitudeState state;
  ImuSensors imu = at_rest(0.0, 0.0);
  imu.angular_rate_body_rad_s.x() = 0.002;
  Attitude torso;
  for (int i = 0; i < 30'000; ++i) torso = step({.time_constant_s = 3.0}, state, imu, 1e-3);
  EXPECT_NEAR(torso.roll_rad, 0.006, 1e-4);
}

TEST(Attitude, KnowsNoDirectionInFreeFallAndWithoutAFreshValue) {
  AttitudeState state;
  static_cast<void>(step({}, state, at_rest(0.02, 0.03), 1e-3));
  ImuSensors falling = at_rest(0.0, 0.0);
  falling.specific_force_body_m_s2.setZero();
  ImuSensors stale = at_rest(0.3, 0.3);
  stale.freshness.age_ticks = 3;
  for (int i = 0; i < 1000; ++i) {
    static_cast<void>(step({}, state, falling, 1e-3));
    const Attitude torso = step({}, state, stale, 1e-3);
    ASSERT_NEAR(torso.roll_rad, 0.02, 1e-9);
    ASSERT_NEAR(torso.pitch_rad, 0.03, 1e-9);
  }
}

}  // namespace
}  // namespace surefoot::estimation
