#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "tests/unit/sim_hw/held_robot.hpp"

namespace surefoot::sim_hw {
namespace {

/// A robot with inertial legs, held standing by the servos of its own leg boards at 100 Hz.
struct ServoedRobot {
  explicit ServoedRobot(SimConfig wanted = {})
      : config(prepared(std::move(wanted))),
        pose(testing::stance(config.geometry)),
        robot(config, pose),
        puppeteer(robot) {}

  static SimConfig prepared(SimConfig config) {
    config.control_period_s = 0.01;
    config.command_latency_s = 0.0;
    config.watchdog_s = 0.05;
    config.sensor.has_inertial_legs = true;
    return config;
  }

  void tick() {
    puppeteer.sync();
    puppeteer.aim(pose);
  }
  void stand(double duration_s) {
    for (double t = 0.0; t < duration_s; t += config.control_period_s) tick();
  }

  SimConfig config;
  PerSide<LegVector> pose;
  SimulatedRobot robot;
  testing::Puppeteer puppeteer;
};

TEST(SimulatedRobotByAngles, StandsOnItsBoardsOwnServosForOnePeriodATick) {
  ServoedRobot held;
  held.stand(2.0);
  const GroundTruth& truth = held.robot.truth();
  EXPECT_FALSE(truth.has_fallen);
  EXPECT_NEAR(truth.pitch_rad, 0.0, 0.05);
  EXPECT_NEAR(truth.roll_rad, 0.0, 1e-3);
  EXPECT_EQ(held.robot.periods(), 200);
  EXPECT_EQ(held.robot.counters().rejected, (decltype(NodeCounters::rejected){}));
  EXPECT_FALSE(held.puppeteer.status[0].is_damping);
}

TEST(SimulatedRobotByAngles, AdvancesWhenOneLegHasAnglesAndTheOtherTorques) {
  ServoedRobot held;
  held.puppeteer.sync();
  held.puppeteer.wire.to_robot.push_back(
      held.puppeteer.command_frame(Side::kRight, {.mode = LegMode::kPosition, .angle_rad = held.pose[0]}));
  held.robot.serve(held.puppeteer.wire);
  EXPECT_EQ(held.robot.periods(), 0);
  held.puppeteer.wire.to_robot.push_back(held.puppeteer.command_frame(Side::kLeft, {.mode = LegMode::kTorque}));
  held.robot.serve(held.puppeteer.wire);
  EXPECT_EQ(held.robot.periods(), 1);
}

TEST(SimulatedRobotByAngles, DampsForTwoMastersOfWhomOneWantsAnglesAndOneTorques) {
  ServoedRobot held;
  held.stand(0.1);
  held.puppeteer.sync();
  auto& frames = held.puppeteer.wire.to_robot;
  frames.push_back(held.puppeteer.command_frame(Side::kRight, {.mode = LegMode::kPosition, .angle_rad = held.pose[0]}));
  frames.push_back(held.puppeteer.command_frame(Side::kRight, {.mode = LegMode::kTorque}));
  held.robot.serve(held.puppeteer.wire);
  held.puppeteer.read_answers();
  EXPECT_EQ(held.puppeteer.last_emergency[index(Side::kRight)], 0x8150);
  EXPECT_EQ(held.puppeteer.emergencies[index(Side::kLeft)], 0);
}

TEST(InertialLegs, TellOfALevelFloorAndOfRest) {
  ServoedRobot held;
  held.stand(2.0);
  held.puppeteer.sync();
  for (const std::size_t side : {0U, 1U}) {
    EXPECT_NEAR(held.puppeteer.leg_inertial[side].hip_roll_rate_rad_s, 0.0, 2e-3);
    EXPECT_NEAR(held.puppeteer.foot_inertial[side].roll_rad, 0.0, 1e-3);
    EXPECT_NEAR(held.puppeteer.foot_inertial[side].pitch_rad, 0.0, 2e-3);
    EXPECT_NEAR(held.puppeteer.foot_inertial[side].specific_force_x_foot_m_s2, 0.0, 0.05);
    EXPECT_NEAR(held.puppeteer.foot_inertial[side].specific_force_y_foot_m_s2, 0.0, 0.05);
  }
}

TEST(InertialLegs, TellOfTheFloorsSlopeFromTheFirstTickOn) {
  constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;
  SimConfig config;
  config.contact.slope_pitch_deg = -4.0;
  config.contact.slope_roll_deg = 3.0;
  ServoedRobot held(config);
  held.puppeteer.sync();
  for (const FootInertialSensors& foot : held.puppeteer.foot_inertial) {
    EXPECT_NEAR(foot.roll_rad, 3.0 * kRadiansPerDegree, 3e-5);
    EXPECT_NEAR(foot.pitch_rad, -4.0 * kRadiansPerDegree, 3e-5);
    EXPECT_NEAR(foot.specific_force_x_foot_m_s2, kGravityM_S2 * std::sin(4.0 * kRadiansPerDegree), 3e-3);
  }
}

TEST(InertialLegs, SendNothingOnARobotWithoutThem) {
  testing::HeldRobot held({});
  held.puppeteer.wire.to_robot.push_back(can::encode_sync({.tick = 1}));
  held.robot.serve(held.puppeteer.wire);
  EXPECT_EQ(held.puppeteer.wire.from_robot.size(), 6U) << "five states and the right board's heartbeat of tick 1";
  EXPECT_TRUE(held.robot.has_answered_fully());
}

TEST(InertialLegs, AreAnnouncedByTheHeartbeatsOfLegsAndFeet) {
  for (const bool has_them : {true, false}) {
    SimConfig config;
    config.sensor.has_inertial_legs = has_them;
    SimulatedRobot robot(config, testing::stance(config.geometry));
    testing::Wire wire;
    robot.announce(wire);
    int announced = 0;
    for (const can::CanFrame& frame : wire.from_robot) {
      can::FrameStamp stamp;
      can::Heartbeat heartbeat;
      if (can::decode_heartbeat(frame, stamp, heartbeat) != can::Rejection::kNone) continue;
      if (heartbeat.has_inertial_sensors) ++announced;
    }
    EXPECT_EQ(announced, has_them ? 4 : 0);
  }
}

// In lockstep the master must be told when a sensor's frame will not come.
TEST(InertialLegs, AreMissedWhenTheirFramesAreLost) {
  SimConfig config;
  config.faults = {{.kind = FaultKind::kDrop, .target = FaultTarget::kFootLeft, .at_s = 0.0, .for_s = 0.05}};
  ServoedRobot held(config);
  held.puppeteer.sync();
  EXPECT_FALSE(held.robot.has_answered_fully());
  for (int i = 0; i < 10; ++i) held.tick();
  held.puppeteer.sync();
  EXPECT_TRUE(held.robot.has_answered_fully());
}

TEST(InertialLegs, MustBeThereForAFaultOfTheirs) {
  SimConfig config;
  config.faults = {{.kind = FaultKind::kStuck, .target = FaultTarget::kLegLeft, .signal = FaultSignal::kHipGyro}};
  const PerSide<LegVector> pose = testing::stance(config.geometry);
  EXPECT_THROW(SimulatedRobot(config, pose), std::invalid_argument);
  config.sensor.has_inertial_legs = true;
  EXPECT_NO_THROW(SimulatedRobot(config, pose));
}

}  // namespace
}  // namespace surefoot::sim_hw
