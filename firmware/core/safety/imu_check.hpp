#pragma once

#include "firmware/core/sensor_snapshot.hpp"

namespace surefoot::safety {

/// A torso IMU that answers but does not feel.
struct ImuCheckConfig {
  double frozen_s = 0.5;               ///< of walking in which all six values may keep their very bits
  double max_force_m_s2 = 40.0;        ///< specific force, filtered: four times gravity
  double force_time_constant_s = 0.1;  ///< the shock of a landing is shorter
};

/// Everything that lives between two ticks.
struct ImuCheckState {
  geometry::Vector3 last_rate_rad_s = geometry::Vector3::Zero();
  geometry::Vector3 last_force_m_s2 = geometry::Vector3::Zero();
  geometry::Vector3 filtered_force_m_s2 = geometry::Vector3::Zero();
  std::uint32_t frozen_ticks = 0;
};

/// One tick; a tick without the node's word changes nothing.
///
/// @param is_moving  the robot walks, or has just ceased to: the frozen time is counted while true, and forgotten when
/// not
/// @param period_s    time since the last call, > 0, and less than the time constant
[[nodiscard]] bool is_imu_plausible(const ImuCheckConfig&, ImuCheckState&, const ImuSensors&, bool is_moving,
                                    double period_s) noexcept;

}  // namespace surefoot::safety
