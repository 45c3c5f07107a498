#include "firmware/core/kinematics/leg_kinematics.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>

namespace surefoot::kinematics {
namespace {

using geometry::Matrix3;
using geometry::RobotGeometry;
using geometry::Vector3;

double uniform(double low, double high) { return low + (high - low) * (*rc::gen::inRange(0, 1'000'001)) * 1e-6; }

Side any_side() { return *rc::gen::element(Side::kRight, Side::kLeft); }

Vector3 vector_in_cube(double half_edge) {
  const double x = uniform(-half_edge, half_edge);
  const double y = uniform(-half_edge, half_edge);
  const double z = uniform(-half_edge, half_edge);
  return {x, y, z};
}

/// Inside the gate's angle range, knee bent by at least 6 degrees.
LegVector any_bent_leg() {
  const double yaw = uniform(-0.8, 0.8);
  const double roll = uniform(-0.8, 0.8);
  const double pitch = uniform(-2.0, 1.0);
  const double knee = uniform(0.1, 2.6);
  const double ankle_pitch = uniform(-1.5, 1.5);
  const double ankle_roll = uniform(-0.8, 0.8);
  return {yaw, roll, pitch, knee, ankle_pitch, ankle_roll};
}

/// A reachable pose that owes nothing to `forward`: ankle in the shell round the hip, any foot rotation.
FootPose any_reachable_pose(const RobotGeometry& geometry, Side side) {
  FootPose pose;
  pose.rotation_body_from_foot = (Eigen::AngleAxisd(uniform(-3.1, 3.1), Vector3::UnitZ()) *
                                  Eigen::AngleAxisd(uniform(-3.1, 3.1), Vector3::UnitX()) *
                                  Eigen::AngleAxisd(uniform(-3.1, 3.1), Vector3::UnitY()))
                                     .toRotationMatrix();
  Vector3 direction = vector_in_cube(1.0);
  if (direction.norm() < 1e-3) direction = -Vector3::UnitZ();
  const Vector3 ankle = geometry.hip_body_m(side) + uniform(0.0501, 0.4899) * direction.normalized();
  pose.position_body_m = ankle - geometry.ankle_height_m * pose.rotation_body_from_foot.col(2);
  return pose;
}

RC_GTEST_PROP(LegInverseKinematics, ReachesEveryReachablePose, ()) {
  const RobotGeometry geometry;
  const Side side = any_side();
  const FootPose wanted = any_reachable_pose(geometry, side);
  const InverseResult result = inverse(geometry, side, wanted);
  const FootPose reached = forward(geometry, side, result.angle_rad);
  RC_ASSERT(result.is_reachable);
  RC_ASSERT((reached.position_body_m - wanted.position_body_m).norm() < 1e-12);
  RC_ASSERT((reached.rotation_body_from_foot - wanted.rotation_body_from_foot).norm() < 1e-12);
  RC_ASSERT(result.angle_rad[index(LegJoint::kKneePitch)] >= 0.0);
}

RC_GTEST_PROP(LegInverseKinematics, FindsTheAnglesThatMadeThePose, ()) {
  const RobotGeometry geometry;
  const Side side = any_side();
  const LegVector angle_rad = any_bent_leg();
  // Hip level with the ankle in the foot's eyes: the roll has no direction there, and loses digits near it.
  const double hip_above_ankle_m =
      geometry.calf_m * std::cos(angle_rad[index(LegJoint::kAnklePitch)]) +
      geometry.thigh_m * std::cos(angle_rad[index(LegJoint::kAnklePitch)] + angle_rad[index(LegJoint::kKneePitch)]);
  RC_PRE(std::abs(hip_above_ankle_m) > 0.01);
  const InverseResult result = inverse(geometry, side, forward(geometry, side, angle_rad));
  RC_ASSERT(result.is_reachable);
  for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
    RC_ASSERT(std::abs(result.angle_rad[joint] - angle_rad[joint]) < 1e-11);
  }
}

RC_GTEST_PROP(LegInverseKinematics, GivesMirroredLegsMirroredAngles, ()) {
  const RobotGeometry geometry;
  const FootPose left = any_reachable_pose(geometry, Side::kLeft);
  const Matrix3 mirror = Vector3(1.0, -1.0, 1.0).asDiagonal();
  const FootPose right{mirror * left.position_body_m, mirror * left.rotation_body_from_foot * mirror};
  const LegVector left_rad = inverse(geometry, Side::kLeft, left).angle_rad;
  const LegVector right_rad = inverse(geometry, Side::kRight, right).angle_rad;
  const LegVector sign{-1.0, -1.0, 1.0, 1.0, 1.0, -1.0};  // yaw and roll change sides
  for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
    // Compared as directions: half a turn is the same angle on both sides.
    RC_ASSERT(std::abs(std::remainder(right_rad[joint] - sign[joint] * left_rad[joint], 2.0 * std::numbers::pi)) <
              1e-9);
  }
}

// The 6x6 geometric Jacobian by its textbook columns (axis x arm; axis), an oracle of its own: the rates
// must give the asked velocity and no rotation.
RC_GTEST_PROP(LegRates, MoveTheFootAsAskedAndDoNotTurnIt, ()) {
  const RobotGeometry geometry;
  const Side side = any_side();
  const LegVector q = any_bent_leg();
  const double ankle_to_hip_m = geometry.calf_m * std::cos(q[4]) + geometry.thigh_m * std::cos(q[4] + q[3]);
  RC_PRE(std::abs(ankle_to_hip_m) > 0.03);  // above the damping's threshold
  const Vector3 velocity = vector_in_cube(2.0);

  const Matrix3 yaw = Eigen::AngleAxisd(q[0], Vector3::UnitZ()).toRotationMatrix();
  const Matrix3 roll = yaw * Eigen::AngleAxisd(q[1], Vector3::UnitX()).toRotationMatrix();
  const Matrix3 thigh = roll * Eigen::AngleAxisd(q[2], Vector3::UnitY()).toRotationMatrix();
  const Matrix3 calf = thigh * Eigen::AngleAxisd(q[3], Vector3::UnitY()).toRotationMatrix();
  const Matrix3 ankle = calf * Eigen::AngleAxisd(q[4], Vector3::UnitY()).toRotationMatrix();
  const Vector3 hip = geometry.hip_body_m(side);
  const Vector3 knee_m = hip - geometry.thigh_m * thigh.col(2);
  const Vector3 ankle_m = knee_m - geometry.calf_m * calf.col(2);
  const Vector3 foot_m = forward(geometry, side, q).position_body_m;
  const std::array<Vector3, kJointsPerLeg> axis{Vector3::UnitZ(), yaw.col(0),  roll.col(1),
                                                thigh.col(1),     calf.col(1), ankle.col(0)};
  const std::array<Vector3, kJointsPerLeg> origin_m{hip, hip, hip, knee_m, ankle_m, ankle_m};

  const LegVector rate = inverse_rates(geometry, q, velocity);
  Vector3 linear = Vector3::Zero();
  Vector3 angular = Vector3::Zero();
  for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
    linear += rate[joint] * axis[joint].cross(foot_m - origin_m[joint]);
    angular += rate[joint] * axis[joint];
  }
  RC_ASSERT((linear - velocity).norm() < 1e-9);
  RC_ASSERT(angular.norm() < 1e-9);
}

/// Feet as in a walk: below and before the hips, soles level.
FootReference any_walking_feet(const RobotGeometry& geometry) {
  FootReference feet;
  for (const Side side : kSides) {
    const double x = uniform(-0.12, 0.12);
    const double y = uniform(-0.08, 0.08);
    const double z = uniform(-0.56, -0.35);
    feet[index(side)].position_body_m = geometry.hip_body_m(side) + Vector3(x, y, z);
    feet[index(side)].velocity_body_m_s = vector_in_cube(1.0);
  }
  return feet;
}

RC_GTEST_PROP(LegRates, AreTheDerivativeOfTheInverse, ()) {
  const RobotGeometry geometry;
  const FootReference feet = any_walking_feet(geometry);
  const double step_s = 2e-7;
  FootReference before = feet;
  FootReference after = feet;
  for (const Side side : kSides) {
    before[index(side)].position_body_m -= step_s * feet[index(side)].velocity_body_m_s;
    after[index(side)].position_body_m += step_s * feet[index(side)].velocity_body_m_s;
  }
  const JointReference rates = inverse(geometry, feet);
  const JointReference earlier = inverse(geometry, before);
  const JointReference later = inverse(geometry, after);
  for (std::size_t leg = 0; leg < 2; ++leg) {
    for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
      const double difference = (later.angle_rad[leg][joint] - earlier.angle_rad[leg][joint]) / (2.0 * step_s);
      RC_ASSERT(std::abs(rates.rate_rad_s[leg][joint] - difference) < 1e-7);
    }
  }
}

RC_GTEST_PROP(BothLegs, GetWhatEachLegAloneWouldGet, ()) {
  const RobotGeometry geometry;
  const FootReference feet = any_walking_feet(geometry);
  const JointReference both = inverse(geometry, feet);
  RC_ASSERT(both.is_reachable);
  for (const Side side : kSides) {
    const FootPath& foot = feet[index(side)];
    const InverseResult alone = inverse(geometry, side, {foot.position_body_m, Matrix3::Identity()});
    const LegVector rates = inverse_rates(geometry, alone.angle_rad, foot.velocity_body_m_s);
    for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
      RC_ASSERT(std::abs(both.angle_rad[index(side)][joint] - alone.angle_rad[joint]) < 1e-13);
      RC_ASSERT(std::abs(both.rate_rad_s[index(side)][joint] - rates[joint]) < 1e-10);
    }
  }
}

}  // namespace
}  // namespace surefoot::kinematics
