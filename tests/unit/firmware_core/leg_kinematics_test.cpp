#include "firmware/core/kinematics/leg_kinematics.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "tests/unit/firmware_core/leg_poses_from_mujoco.hpp"

namespace surefoot::kinematics {
namespace {

using geometry::Matrix3;
using geometry::RobotGeometry;
using geometry::Vector3;

bool all_finite(const LegVector& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

TEST(LegForwardKinematics, AgreesWithMujocoForFiftyRandomPoses) {
  for (const LegPoseFromMujoco& row : kLegPosesFromMujoco) {
    const FootPose pose = forward(RobotGeometry{}, row.side, row.angle_rad);
    const Matrix3 rotation =
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(row.rotation_body_from_foot.data());
    EXPECT_LT((pose.position_body_m - Vector3(row.position_body_m.data())).norm(), 1e-14);
    EXPECT_LT((pose.rotation_body_from_foot - rotation).norm(), 1e-14);
  }
}

// The sum of all lengths below the hip: 0.27 + 0.22 + 0.10 m.
TEST(LegForwardKinematics, PutsTheFootOfTheZeroPoseStraightBelowTheHip) {
  for (const Side side : kSides) {
    const FootPose pose = forward(RobotGeometry{}, side, {});
    EXPECT_LT((pose.position_body_m - Vector3(-0.0245, lateral_sign(side) * 0.11, -0.59)).norm(), 1e-15);
    EXPECT_TRUE(pose.rotation_body_from_foot.isIdentity(0.0));
  }
}

// Each axis alone, by hand: what a swapped or reversed axis would move elsewhere.
TEST(LegForwardKinematics, TurnsEachJointRightHandedAboutItsOwnAxis) {
  const RobotGeometry geometry;
  const double quarter = std::numbers::pi / 2.0;
  const Vector3 hip = geometry.hip_body_m(Side::kLeft);
  struct Row {
    LegJoint joint;
    Vector3 foot_from_hip_m;
    Vector3 sole_up;
  };
  const std::array<Row, kJointsPerLeg> rows{
      Row{LegJoint::kHipYaw, {0.0, 0.0, -0.59}, Vector3::UnitZ()},
      Row{LegJoint::kHipRoll, {0.0, 0.59, 0.0}, -Vector3::UnitY()},
      Row{LegJoint::kHipPitch, {-0.59, 0.0, 0.0}, Vector3::UnitX()},
      Row{LegJoint::kKneePitch, {-0.32, 0.0, -0.27}, Vector3::UnitX()},
      Row{LegJoint::kAnklePitch, {-0.10, 0.0, -0.49}, Vector3::UnitX()},
      Row{LegJoint::kAnkleRoll, {0.0, 0.10, -0.49}, -Vector3::UnitY()},
  };
  for (const Row& row : rows) {
    LegVector angle_rad{};
    angle_rad[index(row.joint)] = quarter;
    const FootPose pose = forward(geometry, Side::kLeft, angle_rad);
    EXPECT_LT((pose.position_body_m - hip - row.foot_from_hip_m).norm(), 1e-15) << kLegJointNames[index(row.joint)];
    EXPECT_LT((pose.rotation_body_from_foot.col(2) - row.sole_up).norm(), 1e-15) << kLegJointNames[index(row.joint)];
  }
  EXPECT_LT((forward(geometry, Side::kLeft, {quarter}).rotation_body_from_foot.col(0) - Vector3::UnitY()).norm(),
            1e-15);
}

// Law of cosines for hip over ankle at 0.444 m (walking height 0.544 m less the ankle's 0.10 m):
// cos(knee) = (l^2 - t^2 - c^2) / (2 t c); the law of sines splits the knee between hip and ankle.
TEST(LegInverseKinematics, BendsTheKneeOfAStandingLegByTheLawOfCosines) {
  const double thigh = 0.27, calf = 0.22, length = 0.444;
  const double knee = std::acos((length * length - thigh * thigh - calf * calf) / (2.0 * thigh * calf));
  const double at_hip = std::asin(calf * std::sin(knee) / length);
  const double at_ankle = std::asin(thigh * std::sin(knee) / length);
  for (const Side side : kSides) {
    FootPose pose;
    pose.position_body_m = RobotGeometry{}.hip_body_m(side) - Vector3(0.0, 0.0, 0.544);
    const InverseResult result = inverse(RobotGeometry{}, side, pose);
    const LegVector expected{0.0, 0.0, -at_hip, knee, -at_ankle, 0.0};
    EXPECT_TRUE(result.is_reachable);
    for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
      EXPECT_NEAR(result.angle_rad[joint], expected[joint], 1e-14) << kLegJointNames[joint];
    }
  }
}

TEST(LegInverseKinematics, ReachesTheStraightLegItself) {
  FootPose pose;
  pose.position_body_m = RobotGeometry{}.hip_body_m(Side::kRight) - Vector3(0.0, 0.0, 0.59);
  const InverseResult result = inverse(RobotGeometry{}, Side::kRight, pose);
  EXPECT_TRUE(result.is_reachable);
  for (const double angle : result.angle_rad) EXPECT_NEAR(angle, 0.0, 1e-7);
}

TEST(LegInverseKinematics, PullsATargetBeyondReachBackAlongTheLineFromTheHip) {
  const RobotGeometry geometry;
  const Vector3 hip = geometry.hip_body_m(Side::kLeft);
  const Vector3 ankle_over_sole(0.0, 0.0, geometry.ankle_height_m);
  const Vector3 direction = Vector3(0.3, 0.2, -0.8).normalized();
  for (const auto& [asked_m, given_m] : {std::pair{2.0, 0.49}, std::pair{0.5, 0.49}, std::pair{0.01, 0.05}}) {
    FootPose pose;
    pose.position_body_m = hip + asked_m * direction - ankle_over_sole;
    const InverseResult result = inverse(geometry, Side::kLeft, pose);
    const FootPose reached = forward(geometry, Side::kLeft, result.angle_rad);
    EXPECT_FALSE(result.is_reachable);
    EXPECT_LT((reached.position_body_m + ankle_over_sole - hip - given_m * direction).norm(), 1e-9) << asked_m;
    EXPECT_TRUE(reached.rotation_body_from_foot.isIdentity(1e-12));
  }
}

TEST(LegInverseKinematics, StaysFiniteForAbsurdTargets) {
  const RobotGeometry geometry;
  const double huge = std::numeric_limits<double>::max();
  const double infinity = std::numeric_limits<double>::infinity();
  const double tiny = std::numeric_limits<double>::denorm_min();
  const Vector3 hip = geometry.hip_body_m(Side::kRight);
  const Vector3 over_sole(0.0, 0.0, geometry.ankle_height_m);
  const std::vector<Vector3> targets{Vector3::Zero(),         hip,
                                     hip - over_sole,         hip - over_sole + Vector3::Constant(tiny),
                                     Vector3::Constant(huge), Vector3(-huge, huge, -huge),
                                     Vector3(0.0, 0.0, 1e9),  Vector3::Constant(infinity),
                                     Vector3(tiny, 0.0, 0.0), Vector3(-infinity, 0.0, 1e-300)};
  for (const Vector3& target : targets) {
    for (const Matrix3& rotation :
         {Matrix3(Matrix3::Identity()), Matrix3(Matrix3::Zero()), Matrix3(Eigen::AngleAxisd(3.0, Vector3::UnitX()))}) {
      const InverseResult result = inverse(geometry, Side::kRight, {target, rotation});
      EXPECT_TRUE(all_finite(result.angle_rad)) << target.transpose();
      EXPECT_TRUE(all_finite(inverse_rates(geometry, result.angle_rad, Vector3(1.0, -1.0, 1.0))));
    }
    FootReference feet;
    for (FootPath& foot : feet) foot = {target, Vector3::Ones(), Vector3::Zero()};
    const JointReference joints = inverse(geometry, feet);
    for (const Side side : kSides) {
      EXPECT_TRUE(all_finite(joints.angle_rad[index(side)])) << target.transpose();
      EXPECT_TRUE(all_finite(joints.rate_rad_s[index(side)])) << target.transpose();
    }
  }
}

// A leg of equal segments can fold its ankle into the hip centre: both lengths vanish.
TEST(LegInverseKinematics, StaysFiniteWhenEqualSegmentsFoldOntoTheHip) {
  RobotGeometry geometry;
  geometry.calf_m = geometry.thigh_m;
  FootReference feet;
  for (const Side side : kSides) {
    feet[index(side)].position_body_m = geometry.hip_body_m(side) - Vector3(0.0, 0.0, geometry.ankle_height_m);
    feet[index(side)].velocity_body_m_s = Vector3::Ones();
  }
  const JointReference joints = inverse(geometry, feet);
  EXPECT_TRUE(joints.is_reachable);
  for (const Side side : kSides) {
    EXPECT_TRUE(all_finite(joints.angle_rad[index(side)]));
    EXPECT_TRUE(all_finite(joints.rate_rad_s[index(side)]));
    EXPECT_NEAR(joints.angle_rad[index(side)][index(LegJoint::kKneePitch)], std::numbers::pi, 1e-12);
  }
}

TEST(LegInverseKinematics, SaysUnreachableWhenOnlyOneFootIs) {
  const RobotGeometry geometry;
  for (const Side far : kSides) {
    FootReference feet;
    for (const Side side : kSides) {
      feet[index(side)].position_body_m = geometry.hip_body_m(side) - Vector3(0.0, 0.0, side == far ? 0.7 : 0.544);
    }
    EXPECT_FALSE(inverse(geometry, feet).is_reachable);
  }
}

// A NaN must come out as NaN, for the output gate to find; a finite pose in its place would be a guess.
TEST(LegInverseKinematics, DoesNotTurnNanIntoAPose) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    FootReference feet;
    for (const Side side : kSides) {
      feet[index(side)].position_body_m = RobotGeometry{}.hip_body_m(side) - Vector3(0.0, 0.0, 0.544);
    }
    feet[index(Side::kLeft)].position_body_m[axis] = nan;
    const JointReference joints = inverse(RobotGeometry{}, feet);
    EXPECT_FALSE(joints.is_reachable);
    EXPECT_FALSE(all_finite(joints.angle_rad[index(Side::kLeft)]));
    EXPECT_TRUE(all_finite(joints.angle_rad[index(Side::kRight)]));
  }
}

// Vertical motion over the ankle: l^2 = t^2 + c^2 + 2 t c cos(knee), so knee rate = -l v / (t c sin(knee)).
TEST(LegRates, StretchTheKneeByTheDerivativeOfTheLawOfCosines) {
  FootPose pose;
  pose.position_body_m = RobotGeometry{}.hip_body_m(Side::kLeft) - Vector3(0.0, 0.0, 0.544);
  const LegVector angle_rad = inverse(RobotGeometry{}, Side::kLeft, pose).angle_rad;
  const LegVector rate = inverse_rates(RobotGeometry{}, angle_rad, {0.0, 0.0, -0.2});
  const double knee_rad = angle_rad[index(LegJoint::kKneePitch)];
  EXPECT_NEAR(rate[index(LegJoint::kKneePitch)], -0.444 * 0.2 / (0.27 * 0.22 * std::sin(knee_rad)), 1e-12);
  EXPECT_EQ(rate[index(LegJoint::kHipYaw)], 0.0);
  EXPECT_EQ(rate[index(LegJoint::kHipRoll)], 0.0);
  EXPECT_EQ(rate[index(LegJoint::kAnkleRoll)], 0.0);
}

// Damped least squares (Nakamura, Hanafusa 1986): the rate grows to its bound and falls to zero
// where the joint can do nothing, without a jump.
TEST(LegRates, AreBoundedAndContinuousThroughAStraightKnee) {
  const double bound_rad_s = 0.49 / (0.27 * 0.22 * 0.05);  // |ankle from hip| |v| / (t c 0.05)
  double previous = 0.0;
  for (int step = 0; step <= 20'000; ++step) {
    const double knee_rad = 1e-5 * step;
    const LegVector angle_rad{0.0, 0.0, -0.5 * knee_rad, knee_rad, -0.5 * knee_rad, 0.0};
    const double rate = inverse_rates(RobotGeometry{}, angle_rad, -Vector3::UnitZ())[index(LegJoint::kKneePitch)];
    EXPECT_LE(std::abs(rate), bound_rad_s * (1.0 + 1e-12));
    EXPECT_LT(std::abs(rate - previous), 0.05);
    previous = rate;
  }
}

}  // namespace
}  // namespace surefoot::kinematics
