#pragma once

#include "firmware/core/geometry/robot_geometry.hpp"
#include "firmware/core/joints.hpp"

namespace surefoot {

/// Where a foot frame shall be, seen from the body.
struct FootPath {
  geometry::Vector3 position_body_m = geometry::Vector3::Zero();
  geometry::Vector3 velocity_body_m_s = geometry::Vector3::Zero();
  geometry::Vector3 acceleration_body_m_s2 = geometry::Vector3::Zero();
  double pitch_rad = 0.0;  ///< of the sole against the body's floor, positive with the heel up; 0: parallel
};

/// Reference for both feet at one instant (X, Y, Z with index r or l in El-Kahlout 2003).
using FootReference = PerSide<FootPath>;

/// Reference for the twelve joints at one instant.
struct JointReference {
  PerSide<LegVector> angle_rad{};
  PerSide<LegVector> rate_rad_s{};
  bool is_reachable = true;  ///< false: at least one foot was beyond the leg's reach and was pulled in
};

}  // namespace surefoot
