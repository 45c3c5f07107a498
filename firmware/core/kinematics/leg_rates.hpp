#pragma once

#include "firmware/core/geometry/robot_geometry.hpp"
#include "firmware/core/joints.hpp"
#include "firmware/core/kinematics/turn.hpp"

namespace surefoot::kinematics {

/// A leg's pose as far as its rates depend on it; the ankle roll drops out.
struct LegTurns {
  Turn yaw;
  Turn roll;
  Turn pitch;
  Turn knee;
  Turn pitch_from_thigh;  ///< knee and ankle pitch together
};

/// Joint rates (rad/s) that move the foot with `velocity_body_m_s` and do not turn it: the six
/// equations of the geometric Jacobian, solved in closed form. About 100 products, no sines.
/// Exact while the sines of knee, hip roll against 90 degrees and leg plane against the ankle
/// roll axis stay above 0.05; damped least squares below.
[[nodiscard]] LegVector rates_without_rotation(const geometry::RobotGeometry&, const LegTurns&,
                                               const geometry::Vector3& velocity_body_m_s) noexcept;

}  // namespace surefoot::kinematics
