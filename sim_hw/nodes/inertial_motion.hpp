#pragma once

#include "firmware/core/geometry/robot_geometry.hpp"
#include "firmware/core/joints.hpp"

namespace surefoot::sim_hw {

/// What the inertial sensors in one leg and its foot feel.
struct LegInertialMotion {
  double hip_roll_rate_rad_s = 0.0;  ///< of the link behind the hip roll joint, about its own forward axis
  double sole_roll_rad = 0.0;        ///< of the foot frame against the vertical, rotation z-y-x
  double sole_pitch_rad = 0.0;
  /// At the ankle's projection on the sole, foot frame, mean over the last period.
  geometry::Vector3 specific_force_foot_m_s2 = geometry::Vector3::Zero();
};

}  // namespace surefoot::sim_hw
