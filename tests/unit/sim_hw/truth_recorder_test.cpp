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

}  // namespace
}  // namespace surefoot::sim_hw
