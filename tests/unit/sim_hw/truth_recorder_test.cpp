#include "sim_hw/truth_recorder.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tests/unit/sim_hw/standing.hpp"

namespace surefoot::sim_hw {
namespace {

using geometry::Matrix3;
using geometry::Vector3;

Matrix3 rotation_zyx(double roll, double pitch, double yaw) {
  return (Eigen::AngleAxisd(yaw, Vector3::UnitZ()) * Eigen::AngleAxisd(pitch, Vector3::UnitY()) *
          Eigen::AngleAxisd(roll, Vector3::UnitX()))
      .toRotationMatrix();
}

class TruthRecorderTest : public ::testing::Test {
 protected:
  void place(const Vector3& position, const Matrix3& rotation, const Vector3& velocity, const Vector3& spin) {
    world.robot().place_body(position, rotation, velocity, spin);
    recorder.close_period(world, {}, 0.0, 1, 1.0e-3);
  }

  World world{SimConfig{}, testing::stance({})};
  TruthRecorder recorder{world, 0.0};
};

TEST_F(TruthRecorderTest, ReadsRollPitchAndYawOfTheBody) {
  place({1.0, 2.0, 0.5}, rotation_zyx(0.1, 0.2, -0.3), Vector3::Zero(), Vector3::Zero());
  EXPECT_NEAR(recorder.truth().roll_rad, 0.1, 1e-14);
  EXPECT_NEAR(recorder.truth().pitch_rad, 0.2, 1e-14);  // leaning forward
  EXPECT_NEAR(recorder.truth().yaw_rad, -0.3, 1e-14);
  EXPECT_NEAR(recorder.truth().body_position_world_m[1], 2.0, 1e-14);
}

TEST_F(TruthRecorderTest, RemembersAFall) {
  place({0.0, 0.0, 0.5}, rotation_zyx(0.0, 0.78, 0.0), Vector3::Zero(), Vector3::Zero());
  EXPECT_FALSE(recorder.truth().has_fallen) << "44.7 degrees";
  place({0.0, 0.0, 0.5}, rotation_zyx(0.0, -0.79, 0.0), Vector3::Zero(), Vector3::Zero());
  EXPECT_TRUE(recorder.truth().has_fallen) << "45.3 degrees";
  place({0.0, 0.0, 0.5}, Matrix3::Identity(), Vector3::Zero(), Vector3::Zero());
  EXPECT_TRUE(recorder.truth().has_fallen);
}

TEST_F(TruthRecorderTest, CallsHalfHeightAFall) {
  place({0.0, 0.0, 0.26}, Matrix3::Identity(), Vector3::Zero(), Vector3::Zero());
  EXPECT_FALSE(recorder.truth().has_fallen);
  place({0.0, 0.0, 0.24}, Matrix3::Identity(), Vector3::Zero(), Vector3::Zero());
  EXPECT_TRUE(recorder.truth().has_fallen);
}

TEST_F(TruthRecorderTest, FeelsGravityAndAccelerationInTheBodysOwnAxes) {
  const Matrix3 nose_down = rotation_zyx(0.0, 0.3, 0.0);
  place({0.0, 0.0, 0.5}, nose_down, Vector3::Zero(), Vector3::Zero());
  const Vector3 at_rest = recorder.torso().specific_force_body_m_s2;
  EXPECT_NEAR(at_rest.x(), -kGravityM_S2 * std::sin(0.3), 1e-12);
  EXPECT_NEAR(at_rest.z(), kGravityM_S2 * std::cos(0.3), 1e-12);

  place({0.0, 0.0, 0.5}, nose_down, {0.002, 0.0, 0.0}, {0.1, 0.2, 0.3});  // 2 m/s2 for 1 ms
  const Vector3 change = recorder.torso().specific_force_body_m_s2 - at_rest;
  EXPECT_LT((change - nose_down.transpose() * Vector3(2.0, 0.0, 0.0)).norm(), 1e-9);
  EXPECT_LT((recorder.torso().angular_rate_body_rad_s - nose_down.transpose() * Vector3(0.1, 0.2, 0.3)).norm(), 1e-14);
}

TEST_F(TruthRecorderTest, FeelsNoWeightInFreeFall) {
  world.robot().place_body({0.0, 0.0, 5.0}, Matrix3::Identity(), Vector3::Zero(), Vector3::Zero());
  recorder.close_period(world, {}, 0.0, 1, 1.0e-3);
  world.advance({}, 5.0e-4);
  world.advance({}, 5.0e-4);
  recorder.close_period(world, {}, 0.0, 2, 1.0e-3);
  EXPECT_LT(recorder.torso().specific_force_body_m_s2.norm(), 1e-9);
}

class LegInertialTruthTest : public ::testing::Test {
 protected:
  /// The robot as one rigid body, its joints at zero, for a period of 10 ms.
  void place(const Matrix3& rotation, const Vector3& velocity, const Vector3& spin) {
    world.robot().place_body({0.0, 0.0, 1.0}, rotation, velocity, spin);
    recorder.close_period(world, {}, 0.0, 1, 0.01);
  }
  const LegInertialMotion& leg(Side side) { return recorder.leg_inertial()[index(side)]; }

  World world{SimConfig{}, {}};
  TruthRecorder recorder{world, 0.0, true};
};

TEST_F(LegInertialTruthTest, FeelsAFlatSoleAtRestBeforeTheFirstPeriod) {
  for (const Side side : kSides) {
    EXPECT_EQ(leg(side).hip_roll_rate_rad_s, 0.0);
    EXPECT_EQ(leg(side).sole_roll_rad, 0.0);
    EXPECT_EQ(leg(side).sole_pitch_rad, 0.0);
    EXPECT_LT((leg(side).specific_force_foot_m_s2 - Vector3(0.0, 0.0, kGravityM_S2)).norm(), 1e-12);
  }
}

TEST_F(LegInertialTruthTest, ReadsTheSolesTiltAsThatOfATorsoWhateverItsYaw) {
  place(rotation_zyx(0.1, -0.2, 2.0), Vector3::Zero(), Vector3::Zero());
  for (const Side side : kSides) {
    EXPECT_NEAR(leg(side).sole_roll_rad, 0.1, 1e-14);
    EXPECT_NEAR(leg(side).sole_pitch_rad, -0.2, 1e-14);
  }
}

// Of links in a chain the rates add up, each about its own axis: yaw about z, roll about x, the trunk's on top.
TEST_F(LegInertialTruthTest, ReadsTheRateOfTheLinkBehindTheHipRollJointInItsOwnAxes) {
  PerSide<LegVector> angle{};
  PerSide<LegVector> rate{};
  angle[index(Side::kLeft)] = {0.3, -0.4, 0.5, 0.6, 0.0, 0.0};
  rate[index(Side::kLeft)] = {2.0, 0.7, 5.0, 5.0, 5.0, 5.0};
  world.robot().set_joints(angle, rate);
  const Matrix3 trunk = rotation_zyx(0.1, 0.2, 0.3);
  const Vector3 spin(0.5, -0.6, 0.8);
  place(trunk, Vector3::Zero(), spin);
  const Matrix3 yawed = trunk * rotation_zyx(0.0, 0.0, 0.3);
  const Matrix3 link = yawed * rotation_zyx(-0.4, 0.0, 0.0);
  const Vector3 total = spin + trunk * Vector3(0.0, 0.0, 2.0) + yawed * Vector3(0.7, 0.0, 0.0);
  EXPECT_NEAR(leg(Side::kLeft).hip_roll_rate_rad_s, (link.transpose() * total).x(), 1e-12);
  EXPECT_NEAR(leg(Side::kRight).hip_roll_rate_rad_s, (trunk.transpose() * spin).x(), 1e-12) << "its joints stand still";
}

TEST_F(LegInertialTruthTest, FeelsGravityAndTheMeanAccelerationOfTheSolesOwnPointInItsOwnAxes) {
  const Matrix3 leaning = rotation_zyx(0.2, 0.3, 0.0);
  place(leaning, Vector3::Zero(), Vector3::Zero());
  const PerSide<LegInertialMotion> at_rest = recorder.leg_inertial();
  EXPECT_NEAR(at_rest[0].specific_force_foot_m_s2.x(), -kGravityM_S2 * std::sin(0.3), 1e-12);
  EXPECT_NEAR(at_rest[0].specific_force_foot_m_s2.y(), kGravityM_S2 * std::sin(0.2) * std::cos(0.3), 1e-12);
  const Vector3 spin(0.0, 0.0, 0.4);
  const Vector3 velocity(0.05, -0.02, 0.0);
  place(leaning, velocity, spin);
  for (const Side side : kSides) {
    const Vector3 lever = from_bullet(world.robot().foot_motion(side).position_m) - Vector3(0.0, 0.0, 1.0);
    const Vector3 acceleration = (velocity + spin.cross(lever)) / 0.01;
    const Vector3 change = leg(side).specific_force_foot_m_s2 - at_rest[index(side)].specific_force_foot_m_s2;
    EXPECT_LT((change - leaning.transpose() * acceleration).norm(), 1e-9);
  }
}

TEST_F(LegInertialTruthTest, IsLeftAloneWhereNobodyWantsIt) {
  TruthRecorder plain(world, 0.0);
  world.robot().place_body({0.0, 0.0, 1.0}, rotation_zyx(0.1, 0.0, 0.0), Vector3::Zero(), Vector3::Zero());
  plain.close_period(world, {}, 0.0, 1, 0.01);
  EXPECT_EQ(plain.leg_inertial()[0].sole_roll_rad, 0.0);
}

}  // namespace
}  // namespace surefoot::sim_hw
