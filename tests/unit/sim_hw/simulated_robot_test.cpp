#include "sim_hw/simulated_robot.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <stdexcept>
#include <string>

#include "sim_hw/world/bullet_math.hpp"
#include "tests/unit/sim_hw/held_robot.hpp"

namespace surefoot::sim_hw {
namespace {

using testing::HeldRobot;
using testing::Puppeteer;
using testing::stance;

double sum(const FootSensors& foot) {
  double total = 0.0;
  for (const double force : foot.corner_force_n) total += force;
  return total;
}

TEST(SimulatedRobot, StandsStillOverTheBusAtOneMillisecondOfLatency) {
  HeldRobot held({});
  held.stand(2.0);
  const GroundTruth& truth = held.robot.truth();
  EXPECT_FALSE(truth.has_fallen);
  EXPECT_NEAR(truth.pitch_rad, 0.0, 2e-3);
  EXPECT_NEAR(truth.zmp_x_body_m, -0.035, 0.003);
  held.puppeteer.sync();
  EXPECT_NEAR(sum(held.puppeteer.foot[0]) + sum(held.puppeteer.foot[1]), 80.0 * kGravityM_S2, 5.0);
  EXPECT_NEAR(held.puppeteer.imu.specific_force_body_m_s2.z(), kGravityM_S2, 0.05);
  EXPECT_NEAR(held.puppeteer.imu.specific_force_body_m_s2.x(), 0.0, 0.05);
  EXPECT_NEAR(held.puppeteer.imu.angular_rate_body_rad_s.norm(), 0.0, 5e-3);
  EXPECT_NEAR(truth.time_s, 2.0, 0.0015);
}

TEST(SimulatedRobot, FeelsItsWeightBeforeTheFirstPeriod) {
  HeldRobot held({});
  held.puppeteer.sync();
  EXPECT_NEAR(sum(held.puppeteer.foot[0]), 40.0 * kGravityM_S2, 0.5);
  EXPECT_NEAR(sum(held.puppeteer.foot[1]), 40.0 * kGravityM_S2, 0.5);
  EXPECT_NEAR(held.puppeteer.imu.specific_force_body_m_s2.z(), kGravityM_S2, 0.01);
  EXPECT_EQ(held.robot.truth().time_s, 0.0);
}

TEST(SimulatedRobot, GivesTheSameBitsForTheSameInputs) {
  SimConfig config;
  config.sensor.encoder_noise_rad = 1.0e-4;
  config.sensor.force_noise_n = 2.0;
  config.payloads.push_back({.mass_kg = 5.0, .at_s = 0.05});
  HeldRobot one(config);
  HeldRobot two(config);
  for (int i = 0; i < 300; ++i) {
    one.puppeteer.sync();
    two.puppeteer.sync();
    ASSERT_EQ(one.puppeteer.leg[0].angle_rad, two.puppeteer.leg[0].angle_rad) << i;
    ASSERT_EQ(one.puppeteer.foot[1].corner_force_n, two.puppeteer.foot[1].corner_force_n) << i;
    one.puppeteer.command(one.wanted());
    two.puppeteer.command(two.wanted());
    ASSERT_EQ(one.robot.truth().body_position_world_m, two.robot.truth().body_position_world_m) << i;
    ASSERT_EQ(one.robot.truth().slip_m, two.robot.truth().slip_m) << i;
  }
}

TEST(SimulatedRobot, SeesOtherNoiseWithAnotherSeed) {
  SimConfig config;
  config.sensor.encoder_noise_rad = 1.0e-4;
  HeldRobot one(config);
  config.seed = 2;
  HeldRobot two(config);
  one.puppeteer.sync();
  two.puppeteer.sync();
  EXPECT_NE(one.puppeteer.leg[0].angle_rad, two.puppeteer.leg[0].angle_rad);
  EXPECT_NE(one.puppeteer.leg[0].angle_rad, one.puppeteer.leg[1].angle_rad) << "each node has noise of its own";
}

TEST(SimulatedRobot, HangsItsPayloadsAtTheirTimesOnTheScenariosClock) {
  SimConfig config;
  config.time_zero_s = 0.1;
  config.payloads = {{.mass_kg = 3.0, .at_s = 0.05}, {.mass_kg = 2.0, .at_s = -0.05}};  // in any order
  HeldRobot held(config);
  EXPECT_DOUBLE_EQ(held.robot.truth().time_s, -0.1);
  const auto at_end_of_tick = [&](int ticks) {
    while (static_cast<int>(held.puppeteer.tick) < ticks) held.tick();
    return held.robot.truth().payload_kg;
  };
  EXPECT_EQ(at_end_of_tick(50), 0.0);  // ends at -0.05 s: the load comes with the step that begins there
  EXPECT_EQ(at_end_of_tick(51), 2.0);
  EXPECT_EQ(at_end_of_tick(150), 2.0);
  EXPECT_EQ(at_end_of_tick(151), 5.0);
}

// 0.1 + 0.2 is a hair above 300 steps of 1 ms.
TEST(SimulatedRobot, IsNotAStepLateForALoadBecauseOfRounding) {
  SimConfig config;
  config.physics_step_s = config.control_period_s;
  config.payloads = {{.mass_kg = 1.0, .at_s = 0.1 + 0.2}};
  HeldRobot held(config);
  while (held.puppeteer.tick < 300) held.tick();
  EXPECT_EQ(held.robot.truth().payload_kg, 0.0);
  held.tick();
  EXPECT_EQ(held.robot.truth().payload_kg, 1.0);
}

TEST(SimulatedRobot, WaitsForBothTorqueFrames) {
  HeldRobot held({});
  held.puppeteer.sync();
  held.puppeteer.wire.to_robot.push_back(held.puppeteer.command_frame(Side::kRight, {LegMode::kTorque, {}}));
  held.robot.serve(held.puppeteer.wire);
  EXPECT_EQ(held.robot.truth().time_s, 0.0);
  held.puppeteer.wire.to_robot.push_back(held.puppeteer.command_frame(Side::kLeft, {LegMode::kTorque, {}}));
  held.robot.serve(held.puppeteer.wire);
  EXPECT_NEAR(held.robot.truth().time_s, 1.0e-3, 1e-12);
}

// As a client's last tick and its goodbye reach a slow simulator: all at once.
TEST(SimulatedRobot, ShowsEachPeriodOfAMasterThatDoesNotWaitForItsAnswers) {
  HeldRobot held({});
  held.stand(0.01);
  auto& waiting = held.puppeteer.wire.to_robot;
  const std::int64_t before = held.robot.periods();
  for (std::uint8_t i = 0; i < 2; ++i) {
    ++held.puppeteer.tick;
    waiting.push_back(can::encode_sync({.tick = held.puppeteer.tick, .counter = static_cast<std::uint8_t>(10 + i)}));
    for (const Side side : kSides) waiting.push_back(held.puppeteer.command_frame(side, {LegMode::kDamp, {}}));
  }
  held.robot.serve(held.puppeteer.wire);
  EXPECT_EQ(held.robot.periods(), before + 1);
  EXPECT_EQ(held.robot.truth_tick(), held.puppeteer.tick - 1);
  held.robot.serve(held.puppeteer.wire);
  EXPECT_EQ(held.robot.periods(), before + 2);
  EXPECT_EQ(held.robot.truth_tick(), held.puppeteer.tick);
}

TEST(SimulatedRobot, KeepsTheControllersCountWhenFramesAreLost) {
  HeldRobot held({});
  held.stand(0.01);
  held.puppeteer.sync();     // torques of this tick never come
  held.puppeteer.tick += 2;  // and two SYNCs are lost
  held.puppeteer.sync();
  EXPECT_NEAR(held.robot.truth().time_s, 1.0e-3 * (held.puppeteer.tick - 1), 1e-9);
  EXPECT_FALSE(held.robot.truth().has_fallen);
}

TEST(SimulatedRobot, DampsAndRaisesAnEmergencyWhenTheControllerFallsSilent) {
  HeldRobot held({});
  held.stand(0.1);
  for (int i = 0; i < 19; ++i) held.puppeteer.sync();
  EXPECT_EQ(held.puppeteer.emergencies[0] + held.puppeteer.emergencies[1], 0);
  EXPECT_FALSE(held.puppeteer.status[0].is_damping);
  for (int i = 0; i < 5; ++i) held.puppeteer.sync();
  for (const Side side : kSides) {
    EXPECT_EQ(held.puppeteer.emergencies[index(side)], 1);
    EXPECT_EQ(held.puppeteer.last_emergency[index(side)], 0x8130);
    EXPECT_TRUE(held.puppeteer.status[index(side)].watchdog_expired);
    EXPECT_TRUE(held.puppeteer.status[index(side)].is_damping);
  }
}

TEST(SimulatedRobot, SinksDownWhenNobodyHoldsItAndSaysThatItFell) {
  HeldRobot held({});
  for (int i = 0; i < 5000; ++i) held.puppeteer.sync();
  EXPECT_TRUE(held.robot.truth().has_fallen);
  EXPECT_TRUE(std::isfinite(held.robot.truth().body_position_world_m[2]));
}

// Played back with a counter that moves on: only the tick gives it away.
TEST(SimulatedRobot, IsNotSetBackByAnOldSync) {
  HeldRobot held({});
  held.stand(0.05);
  const double time_s = held.robot.truth().time_s;
  const std::uint32_t tick = held.puppeteer.tick;
  for (const std::uint32_t age : {0U, 1U, 30U}) {
    held.puppeteer.wire.to_robot.push_back(can::encode_sync({.tick = tick - age, .counter = 200}));
    held.robot.serve(held.puppeteer.wire);
    EXPECT_TRUE(held.puppeteer.wire.from_robot.empty()) << age;
  }
  EXPECT_EQ(held.robot.counters().rejected[static_cast<std::size_t>(can::Rejection::kRepeated)], 1U);
  EXPECT_EQ(held.robot.counters().rejected[static_cast<std::size_t>(can::Rejection::kLate)], 2U);
  held.stand(0.01);
  EXPECT_NEAR(held.robot.truth().time_s, time_s + 0.01, 0.0015);
}

TEST(SimulatedRobot, ServesAControllerThatStartedAnewOnceTheOldOneIsGone) {
  HeldRobot held({});
  held.stand(0.05);
  const can::CanFrame anew = can::encode_sync({.tick = 0, .counter = 77});
  held.puppeteer.wire.to_robot.push_back(anew);
  held.robot.serve(held.puppeteer.wire);
  EXPECT_TRUE(held.puppeteer.wire.from_robot.empty()) << "a second master at tick 0, while the first one runs";
  held.robot.release_master();
  EXPECT_FALSE(held.robot.has_master());
  held.puppeteer.wire.to_robot.push_back(anew);
  held.robot.serve(held.puppeteer.wire);
  EXPECT_FALSE(held.puppeteer.wire.from_robot.empty());
  EXPECT_TRUE(held.robot.has_master());
}

TEST(SimulatedRobot, LeavesAMasterInTheMiddleOfItsRunAloneWhileOneIsToPowerUp) {
  HeldRobot held({});
  held.robot.expect_power_up(true);
  held.puppeteer.wire.to_robot.push_back(can::encode_sync({.tick = 812, .counter = 44}));
  held.robot.serve(held.puppeteer.wire);
  EXPECT_FALSE(held.robot.has_master());
  EXPECT_TRUE(held.puppeteer.wire.from_robot.empty());
  held.puppeteer.wire.to_robot.push_back(can::encode_sync({.tick = 0, .counter = 7}));
  held.robot.serve(held.puppeteer.wire);
  EXPECT_TRUE(held.robot.has_master());
  EXPECT_FALSE(held.puppeteer.wire.from_robot.empty());
}

TEST(SimulatedRobot, KnowsTheTickAtWhichItMetItsMaster) {
  HeldRobot held({});
  for (const std::uint32_t tick : {812U, 813U}) {
    held.puppeteer.wire.to_robot.push_back(
        can::encode_sync({.tick = tick, .counter = static_cast<std::uint8_t>(tick % 256)}));
    held.robot.serve(held.puppeteer.wire);
  }
  EXPECT_EQ(held.robot.tick(), 813U);
  EXPECT_EQ(held.robot.first_tick(), 812U);
}

TEST(SimulatedRobot, TakesNoTorqueFromAMasterThatIsNotOperational) {
  HeldRobot held({});
  held.stand(0.01);
  const double time_s = held.robot.truth().time_s;
  held.puppeteer.sync();
  held.puppeteer.wire.to_robot.push_back(held.puppeteer.heartbeat_frame(can::NodeState::kStopped));
  held.puppeteer.command(held.wanted());
  EXPECT_EQ(held.robot.truth().time_s, time_s) << "the torques did not count";
}

TEST(SimulatedRobot, TakesNoHeartbeatOfAnotherTickWhileItsMasterRuns) {
  HeldRobot held({});
  held.stand(0.01);
  held.puppeteer.sync();
  held.puppeteer.wire.to_robot.push_back(
      can::encode_heartbeat(can::Node::kController, {.tick = 3, .counter = 9}, {.state = can::NodeState::kStopped}));
  const double time_s = held.robot.truth().time_s;
  held.puppeteer.command(held.wanted());
  EXPECT_GT(held.robot.truth().time_s, time_s);
}

TEST(SimulatedRobot, TakesNoTorqueOnTheStrengthOfAnotherMastersHeartbeat) {
  HeldRobot held({});
  held.puppeteer.wire.to_robot.push_back(
      can::encode_heartbeat(can::Node::kController, {.tick = 777}, {.state = can::NodeState::kOperational}));
  held.puppeteer.wire.to_robot.push_back(can::encode_sync({.tick = 5}));
  held.robot.serve(held.puppeteer.wire);
  held.puppeteer.tick = 5;
  for (const Side side : kSides) {
    held.puppeteer.wire.to_robot.push_back(held.puppeteer.command_frame(side, {LegMode::kTorque, {}}));
  }
  held.robot.serve(held.puppeteer.wire);
  EXPECT_EQ(held.robot.truth().time_s, 0.0) << "the torques did not count";
}

TEST(SimulatedRobot, AnnouncesItsNodesWhileNoMasterRuns) {
  HeldRobot held({});
  for (const can::NodeState state : {can::NodeState::kBootUp, can::NodeState::kPreOperational}) {
    held.robot.announce(held.puppeteer.wire);
    ASSERT_EQ(held.puppeteer.wire.from_robot.size(), 6U);
    // First, or a firmware that has heard all nodes might take this robot's clock for the wrong one.
    EXPECT_EQ(held.puppeteer.wire.from_robot.front().identifier, can::kLockstepServedIdentifier);
    held.puppeteer.wire.from_robot.erase(held.puppeteer.wire.from_robot.begin());
    for (const can::CanFrame& frame : held.puppeteer.wire.from_robot) {
      can::FrameStamp stamp;
      can::Heartbeat heartbeat;
      ASSERT_EQ(can::decode_heartbeat(frame, stamp, heartbeat), can::Rejection::kNone);
      EXPECT_EQ(heartbeat.state, state);
    }
    held.puppeteer.wire.from_robot.clear();
  }
}

TEST(SimulatedRobot, RunsFreelyBesideItsMaster) {
  const SimConfig config;
  SimulatedRobot robot(config, stance(config.geometry), WorldClock::kFreeRunning);
  Puppeteer puppeteer(robot);
  robot.advance_to(0.0101, puppeteer.wire);  // nobody drives: damped
  EXPECT_EQ(robot.periods(), 10);
  puppeteer.tick = 99;
  puppeteer.sync();
  puppeteer.command({});
  EXPECT_EQ(robot.periods(), 10) << "torques alone move nothing on";
  robot.advance_to(0.0151, puppeteer.wire);
  EXPECT_EQ(robot.periods(), 15);
  EXPECT_EQ(robot.truth_tick(), 104U) << "ticks 100 to 104 have been simulated";
  EXPECT_TRUE(robot.has_master());
  robot.advance_to(0.04, puppeteer.wire);
  EXPECT_FALSE(robot.has_master()) << "silent for longer than the watchdog";
}

TEST(SimulatedRobot, FreeRunningTakesNoSyncThatIsAheadOfItsClock) {
  const SimConfig config;
  SimulatedRobot robot(config, stance(config.geometry), WorldClock::kFreeRunning);
  Puppeteer puppeteer(robot);
  puppeteer.sync();
  robot.advance_to(0.001, puppeteer.wire);
  puppeteer.wire.from_robot.clear();
  puppeteer.wire.to_robot.push_back(can::encode_sync({.tick = puppeteer.tick + 100, .counter = 1}));
  robot.serve(puppeteer.wire);
  EXPECT_TRUE(puppeteer.wire.from_robot.empty());
  puppeteer.sync();
  EXPECT_EQ(robot.tick(), puppeteer.tick);
}

TEST(SimulatedRobot, CountsWhatItRefuses) {
  HeldRobot held({});
  held.stand(0.005);
  const NodeCounters before = held.robot.counters();
  held.puppeteer.sync();
  can::CanFrame corrupt = held.puppeteer.command_frame(Side::kRight, {LegMode::kTorque, {}});
  corrupt.payload[10] ^= 0x40;
  can::CanFrame stranger;
  stranger.identifier = 0x555;
  stranger.length = 8;
  held.puppeteer.wire.to_robot = {corrupt, stranger};
  held.robot.serve(held.puppeteer.wire);
  const NodeCounters after = held.robot.counters();
  EXPECT_EQ(after.rejected[static_cast<std::size_t>(can::Rejection::kWrongCrc)],
            before.rejected[static_cast<std::size_t>(can::Rejection::kWrongCrc)] + 1);
  EXPECT_EQ(after.rejected[static_cast<std::size_t>(can::Rejection::kUnknownIdentifier)],
            before.rejected[static_cast<std::size_t>(can::Rejection::kUnknownIdentifier)] + 1);
  EXPECT_EQ(after.received, before.received + 1) << "the SYNC";
}

std::string complaint(const SimConfig& config) {
  try {
    const SimulatedRobot robot(config, stance({}));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

TEST(SimulatedRobot, RefusesImpossibleConfigurationsWithARemedy) {
  const auto expect_complaint = [](const auto& spoil, const std::string& field) {
    SimConfig config;
    spoil(config);
    const std::string text = complaint(config);
    EXPECT_NE(text.find(field), std::string::npos) << text;
    EXPECT_NE(text.find("remedy: "), std::string::npos) << text;
  };
  expect_complaint([](SimConfig& c) { c.physics_step_s = 3.0e-4; }, "physics_step_s is 0.0003");
  expect_complaint([](SimConfig& c) { c.physics_step_s = 0.0; }, "physics_step_s");
  expect_complaint([](SimConfig& c) { c.physics_step_s = std::nan(""); }, "physics_step_s");
  expect_complaint([](SimConfig& c) { c.mass.foot_kg = 0.0; }, "mass.foot_kg");
  expect_complaint([](SimConfig& c) { c.contact.friction = -0.1; }, "contact.friction");
  expect_complaint([](SimConfig& c) { c.payloads.push_back({.mass_kg = -5.0}); }, "payload.mass_kg is -5");
  expect_complaint([](SimConfig& c) { c.watchdog_s = 1.0e-4; }, "watchdog_s");
  expect_complaint([](SimConfig& c) { c.command_latency_s = 1.0; }, "command_latency_s");
  EXPECT_EQ(complaint({}), "");
}

}  // namespace
}  // namespace surefoot::sim_hw
