#include "firmware/core/kinematics/leg_kinematics.hpp"

#include <algorithm>
#include <cmath>

#include "firmware/core/kinematics/leg_rates.hpp"
#include "firmware/core/kinematics/turn.hpp"

namespace surefoot::kinematics {
namespace {

using geometry::Matrix3;
using geometry::RobotGeometry;
using geometry::Vector3;

/// Targets farther away than this are unreachable whatever they are; keeps squares finite.
constexpr double kFarthestTargetM = 1.0e6;
/// A target this little outside the reachable shell is rounding, not a mistake of the planner.
constexpr double kReachToleranceM = 1.0e-9;

/// The joints that the hip's place above the sole decides; the hip axes then turn the foot.
struct LowerLeg {
  Turn knee;
  Turn ankle_pitch;
  Turn ankle_roll;
  Turn pitch_from_thigh;  ///< knee and ankle pitch together
  bool is_reachable = true;
};

/// Knee by the law of cosines, ankle by the direction in which the foot sees the hip.
LowerLeg solve_lower_leg(const RobotGeometry& geometry, Vector3 hip_from_ankle_foot_m) noexcept {
  LowerLeg leg;
  const double longest_m = geometry.thigh_m + geometry.calf_m;
  const double shortest_m = std::abs(geometry.thigh_m - geometry.calf_m);
  const double wanted_m = hip_from_ankle_foot_m.norm();
  const double length_m = std::clamp(wanted_m, shortest_m, longest_m);
  leg.is_reachable = std::abs(wanted_m - length_m) <= kReachToleranceM;
  if (wanted_m != length_m) {  // a zero vector has no direction: the hip goes above the ankle
    hip_from_ankle_foot_m =
        wanted_m > 0.0 ? Vector3(hip_from_ankle_foot_m * (length_m / wanted_m)) : Vector3(0.0, 0.0, length_m);
  }

  // Factored, so that a nearly straight knee keeps its digits: 4 t^2 c^2 sin^2 = (l^2 - (t-c)^2) ((t+c)^2 - l^2).
  const double sine_squared =
      (length_m - shortest_m) * (length_m + shortest_m) * (longest_m - length_m) * (longest_m + length_m);
  const double squares = length_m * length_m - geometry.thigh_m * geometry.thigh_m - geometry.calf_m * geometry.calf_m;
  leg.knee = Turn::along(squares, std::sqrt(sine_squared));

  // The hip lies in the plane that the ankle roll turns; the roll stays within a quarter turn.
  const double side = hip_from_ankle_foot_m.z() < 0.0 ? -1.0 : 1.0;
  leg.ankle_roll = Turn::along(side * hip_from_ankle_foot_m.z(), side * hip_from_ankle_foot_m.y());
  const double hip_x_m = hip_from_ankle_foot_m.x();
  const double hip_z_m =
      leg.ankle_roll.cos * hip_from_ankle_foot_m.z() + leg.ankle_roll.sin * hip_from_ankle_foot_m.y();
  // The same vector seen along the calf; the ankle pitch is the angle between the two.
  const double calf_x_m = -geometry.thigh_m * leg.knee.sin;
  const double calf_z_m = geometry.calf_m + geometry.thigh_m * leg.knee.cos;
  leg.ankle_pitch = Turn::along(calf_x_m * hip_x_m + calf_z_m * hip_z_m, calf_x_m * hip_z_m - calf_z_m * hip_x_m);
  leg.pitch_from_thigh = leg.knee.then(leg.ankle_pitch);
  return leg;
}

/// Hip seen from the ankle, body axes; far targets come near enough to be squared.
Vector3 hip_from_ankle_body_m(const RobotGeometry& geometry, Side side, const Vector3& position_body_m,
                              const Vector3& sole_up_body) noexcept {
  const auto bounded = [](double metres) { return std::clamp(metres, -kFarthestTargetM, kFarthestTargetM); };
  return geometry.hip_body_m(side) - position_body_m.unaryExpr(bounded) - geometry.ankle_height_m * sole_up_body;
}

FootPose pitched(const FootPath& foot) noexcept {
  const Turn pitch = Turn::of(foot.pitch_rad);
  FootPose pose;
  pose.position_body_m = foot.position_body_m;
  pose.rotation_body_from_foot.col(0) = about_y(pitch, Vector3::UnitX());
  pose.rotation_body_from_foot.col(2) = about_y(pitch, Vector3::UnitZ());
  return pose;
}

}  // namespace

FootPose forward(const RobotGeometry& geometry, Side side, const LegVector& angle_rad) noexcept {
  const auto turn = [&angle_rad](LegJoint joint) { return Turn::of(angle_rad[index(joint)]); };
  const Turn yaw = turn(LegJoint::kHipYaw);
  const Turn roll = turn(LegJoint::kHipRoll);
  const Turn pitch = turn(LegJoint::kHipPitch);
  const Turn knee = turn(LegJoint::kKneePitch);
  const Turn ankle_roll = turn(LegJoint::kAnkleRoll);
  const Turn foot_pitch = pitch.then(knee).then(turn(LegJoint::kAnklePitch));
  const auto from_hip = [&](const Vector3& v) { return about_z(yaw, about_x(roll, v)); };
  const auto from_foot = [&](const Vector3& v) { return from_hip(about_y(foot_pitch, about_x(ankle_roll, v))); };

  FootPose pose;
  pose.rotation_body_from_foot.col(0) = from_foot(Vector3::UnitX());
  pose.rotation_body_from_foot.col(1) = from_foot(Vector3::UnitY());
  pose.rotation_body_from_foot.col(2) = from_foot(Vector3::UnitZ());
  const Vector3 ankle =
      about_y(pitch, {0.0, 0.0, -geometry.thigh_m}) + about_y(pitch.then(knee), {0.0, 0.0, -geometry.calf_m});
  pose.position_body_m =
      geometry.hip_body_m(side) + from_hip(ankle) - geometry.ankle_height_m * pose.rotation_body_from_foot.col(2);
  return pose;
}

InverseResult inverse(const RobotGeometry& geometry, Side side, const FootPose& pose) noexcept {
  const Matrix3& rotation = pose.rotation_body_from_foot;
  const LowerLeg leg = solve_lower_leg(
      geometry, rotation.transpose() * hip_from_ankle_body_m(geometry, side, pose.position_body_m, rotation.col(2)));

  // Rz(yaw) Rx(roll) Ry(pitch) = rotation Rx(-ankle roll) Ry(-pitch from thigh): its y column and bottom row.
  const auto hip_axis = [&](const Vector3& v) {
    return Vector3(rotation * about_x(leg.ankle_roll.reversed(), about_y(leg.pitch_from_thigh.reversed(), v)));
  };
  const double x_z = hip_axis(Vector3::UnitX()).z();
  const Vector3 y = hip_axis(Vector3::UnitY());
  const double z_z = hip_axis(Vector3::UnitZ()).z();
  return {{std::atan2(-y.x(), y.y()), std::atan2(y.z(), std::sqrt(x_z * x_z + z_z * z_z)), std::atan2(-x_z, z_z),
           leg.knee.angle_rad(), leg.ankle_pitch.angle_rad(), leg.ankle_roll.angle_rad()},
          leg.is_reachable};
}

JointReference inverse(const RobotGeometry& geometry, const FootReference& feet) noexcept {
  JointReference joints;
  for (const Side side : kSides) {
    const FootPath& foot = feet[index(side)];
    if (foot.pitch_rad != 0.0) {
      const InverseResult leg = inverse(geometry, side, pitched(foot));
      joints.angle_rad[index(side)] = leg.angle_rad;
      joints.rate_rad_s[index(side)] = inverse_rates(geometry, leg.angle_rad, foot.velocity_body_m_s);
      joints.is_reachable = joints.is_reachable && leg.is_reachable;
      continue;
    }
    const LowerLeg leg =
        solve_lower_leg(geometry, hip_from_ankle_body_m(geometry, side, foot.position_body_m, Vector3::UnitZ()));
    // A sole parallel to the body's floor: no yaw, and the hip undoes roll and pitch of what hangs below it.
    const double roll_rad = leg.ankle_roll.angle_rad();
    joints.angle_rad[index(side)] = {0.0,
                                     -roll_rad,
                                     leg.pitch_from_thigh.reversed().angle_rad(),
                                     leg.knee.angle_rad(),
                                     leg.ankle_pitch.angle_rad(),
                                     roll_rad};
    joints.rate_rad_s[index(side)] = rates_without_rotation(
        geometry, {Turn{}, leg.ankle_roll.reversed(), leg.pitch_from_thigh.reversed(), leg.knee, leg.pitch_from_thigh},
        foot.velocity_body_m_s);
    joints.is_reachable = joints.is_reachable && leg.is_reachable;
  }
  return joints;
}

}  // namespace surefoot::kinematics
