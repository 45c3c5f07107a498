#pragma once

#include <array>
#include <cstdint>

#include "firmware/core/geometry/robot_geometry.hpp"
#include "firmware/core/joints.hpp"

namespace surefoot {

/// Age of one node's values. A node that has never been heard is at `kNeverHeard`.
struct Freshness {
  static constexpr std::uint32_t kNeverHeard = 0xFFFF'FFFFU;

  std::uint32_t age_ticks = kNeverHeard;  ///< 0: the values answer this tick's SYNC

  [[nodiscard]] bool is_fresh() const noexcept { return age_ticks == 0; }
  [[nodiscard]] bool was_heard() const noexcept { return age_ticks != kNeverHeard; }
};

/// What one leg board reports of its six joints.
struct LegSensors {
  LegVector angle_rad{};
  LegVector rate_rad_s{};
  LegVector torque_nm{};    ///< applied by the motors, after the board's own limits
  bool is_damping = false;  ///< the board ignores torques and damps its joints, by command or by its own watchdog
  Freshness freshness;
};

/// What one foot node reports: the normal force at each corner, compressive positive, foot frame.
struct FootSensors {
  std::array<double, geometry::kCornersPerFoot> corner_force_n{};
  Freshness freshness;
};

/// What the torso IMU reports, body frame.
struct ImuSensors {
  geometry::Vector3 angular_rate_body_rad_s = geometry::Vector3::Zero();
  geometry::Vector3 specific_force_body_m_s2 = geometry::Vector3::Zero();  ///< +g on z at rest
  Freshness freshness;
};

/// What the inertial sensors of one leg report; a robot without them leaves this as it is, never heard. A node that
/// announces them counts as heard from then on, of values 0.
struct LegInertialSensors {
  double hip_roll_rate_rad_s = 0.0;  ///< gyro behind the hip roll joint: how fast the leg leans, about x
  Freshness freshness;
};

/// The same of one foot, foot frame.
struct FootInertialSensors {
  double roll_rad = 0.0;  ///< inclinometer: of the sole against the vertical, signs as torso angles
  double pitch_rad = 0.0;
  double specific_force_x_foot_m_s2 = 0.0;  ///< accelerometer at the ankle's projection on the sole
  double specific_force_y_foot_m_s2 = 0.0;
  Freshness freshness;
};

/// Everything the controller may know of the robot in one tick. Each value has passed the
/// end-to-end check and the physical range check; a node that did not answer keeps its last
/// values and ages.
struct SensorSnapshot {
  std::uint32_t tick = 0;
  PerSide<LegSensors> leg{};
  PerSide<FootSensors> foot{};
  ImuSensors torso{};
  PerSide<LegInertialSensors> leg_inertial{};
  PerSide<FootInertialSensors> foot_inertial{};
};

}  // namespace surefoot
