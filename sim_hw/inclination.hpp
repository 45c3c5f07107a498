#pragma once

#include <algorithm>
#include <cmath>

#include "sim_hw/ground_truth.hpp"
#include "sim_hw/world/slope.hpp"

namespace surefoot::sim_hw {

/// Torso angles against the vertical, of the same kind as those of `GroundTruth` against the floor's normal.
struct Inclination {
  double roll_rad = 0.0;
  double pitch_rad = 0.0;
};

/// On a level floor the angles of the truth themselves, to the bit.
[[nodiscard]] inline Inclination inclination(const GroundTruth& truth, const ContactConfig& floor) noexcept {
  if (floor.slope_pitch_deg == 0.0 && floor.slope_roll_deg == 0.0) return {truth.roll_rad, truth.pitch_rad};
  const geometry::Vector3 up = -gravity_floor_m_s2(floor) / kGravityM_S2;
  // Up in the body frame: Rx(-roll) Ry(-pitch) Rz(-yaw) up.
  const double cy = std::cos(truth.yaw_rad);
  const double sy = std::sin(truth.yaw_rad);
  const double cp = std::cos(truth.pitch_rad);
  const double sp = std::sin(truth.pitch_rad);
  const double cr = std::cos(truth.roll_rad);
  const double sr = std::sin(truth.roll_rad);
  const double x1 = cy * up.x() + sy * up.y();
  const double y1 = -sy * up.x() + cy * up.y();
  const double x = cp * x1 - sp * up.z();
  const double z2 = sp * x1 + cp * up.z();
  const double y = cr * y1 + sr * z2;
  const double z = -sr * y1 + cr * z2;
  return {std::atan2(y, z), -std::asin(std::clamp(x, -1.0, 1.0))};
}

}  // namespace surefoot::sim_hw
