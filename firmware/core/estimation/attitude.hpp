#pragma once

#include "firmware/core/sensor_snapshot.hpp"

namespace surefoot::estimation {

struct AttitudeConfig {
  /// The gyro is trusted for times shorter than this, the accelerometer for longer ones: a walking torso's
  /// accelerations cancel out over a cycle.
  double time_constant_s = 3.0;
};

/// Direction of up in the body frame, unit length; zero before the first value.
struct AttitudeState {
  geometry::Vector3 up_body = geometry::Vector3::Zero();
};

/// Inclination of the torso against gravity, signs and order as torso angles (rotation z-y-x).
struct Attitude {
  double roll_rad = 0.0;
  double pitch_rad = 0.0;
  double roll_rate_rad_s = 0.0;   ///< gyro's x
  double pitch_rate_rad_s = 0.0;  ///< gyro's y
};

/// One tick of a complementary filter on the direction of gravity: it turns with the gyro and creeps to the
/// accelerometer. Starts at the accelerometer's first value. A tick without a fresh IMU, or one in free fall, moves it
/// by the last known rates only.
///
/// @param period_s  time since the last call, > 0
[[nodiscard]] Attitude step(const AttitudeConfig&, AttitudeState&, const ImuSensors&, double period_s) noexcept;

}  // namespace surefoot::estimation
