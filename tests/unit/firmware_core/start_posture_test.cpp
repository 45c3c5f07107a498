#include "firmware/core/safety/start_posture.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace surefoot::safety {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A robot that stands in the pose of `standing`, each foot loaded with 400 N.
struct Standing {
  StartPostureConfig config{};
  JointReference standing{};
  SensorSnapshot sensors{};

  Standing() {
    for (const Side side : kSides) {
      standing.angle_rad[index(side)].fill(0.3);
      sensors.leg[index(side)].angle_rad.fill(0.3);
      sensors.leg[index(side)].freshness.age_ticks = 0;
      sensors.foot[index(side)].corner_force_n.fill(100.0);
      sensors.foot[index(side)].freshness.age_ticks = 0;
    }
    sensors.torso.specific_force_body_m_s2 = {0.0, 0.0, 9.81};
    sensors.torso.freshness.age_ticks = 0;
  }
  bool is_ready() const { return is_ready_to_stand(config, sensors, standing); }
};

TEST(StartPosture, IsReadyWhenTheRobotStands) { EXPECT_TRUE(Standing().is_ready()); }

TEST(StartPosture, IsNotReadyWithAnyJointBeyondItsTolerance) {
  for (std::size_t leg = 0; leg < 2; ++leg) {
    for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
      for (const double error_rad : {0.149, -0.149, 0.151, -0.151, kNan}) {
        Standing robot;
        robot.sensors.leg[leg].angle_rad[joint] += error_rad;
        EXPECT_EQ(robot.is_ready(), std::abs(error_rad) < 0.15) << leg << ' ' << joint << ' ' << error_rad;
      }
    }
  }
}

TEST(StartPosture, IsNotReadyWhileTheTorsoLeansInWhateverDirection) {
  for (const double tilt_rad : {0.19, 0.21, 1.5, 3.0}) {
    for (double heading_rad = 0.0; heading_rad < 6.28; heading_rad += 0.5) {
      Standing robot;
      robot.sensors.torso.specific_force_body_m_s2 = {9.81 * std::sin(tilt_rad) * std::cos(heading_rad),
                                                      9.81 * std::sin(tilt_rad) * std::sin(heading_rad),
                                                      9.81 * std::cos(tilt_rad)};
      EXPECT_EQ(robot.is_ready(), tilt_rad < 0.2) << tilt_rad;
    }
  }
}

// An accelerometer that reads nothing, falls freely or is being struck does not say which way is up.
TEST(StartPosture, IsNotReadyWhenTheAccelerometerDoesNotFeelGravity) {
  for (const double force_m_s2 : {0.0, 4.0, 15.0, -9.81, kNan}) {
    Standing robot;
    robot.sensors.torso.specific_force_body_m_s2 = {0.0, 0.0, force_m_s2};
    EXPECT_FALSE(robot.is_ready()) << force_m_s2;
  }
}

TEST(StartPosture, IsNotReadyWhileAFootHangsInTheAir) {
  for (std::size_t foot = 0; foot < 2; ++foot) {
    Standing robot;
    robot.sensors.foot[foot].corner_force_n = {60.0, -10.0, 0.0, -0.1};
    EXPECT_FALSE(robot.is_ready());
    robot.sensors.foot[foot].corner_force_n = {60.0, -10.0, 0.0, 0.0};
    EXPECT_TRUE(robot.is_ready());
  }
}

TEST(StartPosture, IsNotReadyUntilEveryNodeSpeaks) {
  for (std::size_t node = 0; node < 5; ++node) {
    for (const std::uint32_t age : {1U, Freshness::kNeverHeard}) {
      Standing robot;
      Freshness* const nodes[] = {&robot.sensors.leg[0].freshness, &robot.sensors.leg[1].freshness,
                                  &robot.sensors.foot[0].freshness, &robot.sensors.foot[1].freshness,
                                  &robot.sensors.torso.freshness};
      nodes[node]->age_ticks = age;
      EXPECT_FALSE(robot.is_ready());
    }
  }
}

}  // namespace
}  // namespace surefoot::safety
