#pragma once

#include "firmware/core/foot_reference.hpp"
#include "firmware/core/geometry/robot_geometry.hpp"
#include "firmware/core/joints.hpp"

namespace surefoot::kinematics {

/// Pose of a foot frame in the body frame.
struct FootPose {
  geometry::Vector3 position_body_m = geometry::Vector3::Zero();
  geometry::Matrix3 rotation_body_from_foot = geometry::Matrix3::Identity();
};

/// Pose of the foot frame for given joint angles. About 50 floating-point sines and products.
[[nodiscard]] FootPose forward(const geometry::RobotGeometry&, Side, const LegVector& angle_rad) noexcept;

/// Joint angles for a foot pose, closed form (three intersecting hip axes, two ankle axes).
/// Hip and ankle roll stay within a quarter turn, the knee within [0, pi].
struct InverseResult {
  LegVector angle_rad{};
  bool is_reachable = true;  ///< false: the ankle was pulled onto the reachable sphere; angles stay finite
};

/// Knee bends backwards (angle >= 0). Exact inverse of `forward` for every reachable pose with
/// the knee bent: |forward(inverse(p)) - p| < 1e-12 m. A target beyond reach keeps its foot
/// rotation and the direction from hip to ankle. NaN in, NaN out: the output gate answers to it.
[[nodiscard]] InverseResult inverse(const geometry::RobotGeometry&, Side, const FootPose&) noexcept;

/// Joint rates, alike for both legs, that move the foot frame with the given velocity and no rotation against the body,
/// at the given angles; by the leg's geometric Jacobian. Near a straight knee the rates are
/// bounded by damping rather than infinite; with sin(knee) above 0.05 they are exact.
[[nodiscard]] LegVector inverse_rates(const geometry::RobotGeometry&, const LegVector& angle_rad,
                                      const geometry::Vector3& velocity_body_m_s) noexcept;

/// Both legs: angles for a foot reference, and rates as if its soles did not turn, which those parallel to the body's
/// floor do not.
[[nodiscard]] JointReference inverse(const geometry::RobotGeometry&, const FootReference&) noexcept;

}  // namespace surefoot::kinematics
