#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/unit/sim_hw/held_robot.hpp"

namespace surefoot::sim_hw {
namespace {

using testing::HeldRobot;
using testing::Puppeteer;
using testing::stance;
using enum FaultKind;

/// From the begin of tick 50 to the end of tick 99; ticks are counted from 1, the clock reads 0 in the first.
SimConfig with(std::vector<FaultConfig> faults) {
  SimConfig config;
  for (FaultConfig& fault : faults) {
    fault.at_s = 0.049;
    fault.for_s = 0.050;
  }
  config.faults = std::move(faults);
  return config;
}

bool has_sent(const std::vector<can::CanFrame>& frames, std::uint16_t identifier) {
  return std::ranges::any_of(frames, [=](const can::CanFrame& frame) { return frame.identifier == identifier; });
}

/// SYNC of the next tick, answers kept on the wire; torques follow.
std::vector<can::CanFrame> answers_of_next_tick(HeldRobot& held) {
  ++held.puppeteer.tick;
  const auto counter = static_cast<std::uint8_t>(held.puppeteer.tick - 1);
  held.puppeteer.wire.from_robot.clear();
  held.puppeteer.wire.to_robot.push_back(can::encode_sync({.tick = held.puppeteer.tick, .counter = counter}));
  if (held.puppeteer.tick == 1) {
    held.puppeteer.wire.to_robot.push_back(held.puppeteer.heartbeat_frame(can::NodeState::kOperational));
  }
  held.robot.serve(held.puppeteer.wire);
  const std::vector<can::CanFrame> answers = held.puppeteer.wire.from_robot;
  held.puppeteer.read_answers();
  held.puppeteer.command(held.wanted());
  return answers;
}

TEST(FaultyRobot, WithFaultsThatAreNeverOnIsTheRobotWithoutAnyBitByBit) {
  HeldRobot plain({});
  SimConfig config = with({{.kind = kLinkDown},
                           {.kind = kDeadNode, .target = FaultTarget::kLegLeft},
                           {.kind = kStuck, .target = FaultTarget::kTorso}});
  for (FaultConfig& fault : config.faults) fault.at_s = 3600.0;
  HeldRobot faulty(config);
  for (int i = 0; i < 300; ++i) {
    const std::vector<can::CanFrame> expected = answers_of_next_tick(plain);
    const std::vector<can::CanFrame> answers = answers_of_next_tick(faulty);
    ASSERT_EQ(answers.size(), expected.size());
    for (std::size_t k = 0; k < answers.size(); ++k) {
      ASSERT_EQ(answers[k].identifier, expected[k].identifier);
      ASSERT_EQ(answers[k].payload, expected[k].payload);
    }
    ASSERT_EQ(faulty.robot.truth().body_position_world_m, plain.robot.truth().body_position_world_m);
    ASSERT_TRUE(faulty.robot.has_answered_fully() && plain.robot.has_answered_fully());
  }
}

TEST(FaultyRobot, FaultBeginsAndEndsOnItsTick) {
  HeldRobot held(with({{.kind = kDrop, .target = FaultTarget::kTorso}}));
  for (int tick = 1; tick <= 120; ++tick) {
    const bool is_on = tick >= 50 && tick < 100;
    EXPECT_EQ(!has_sent(answers_of_next_tick(held), 0x185), is_on) << tick;
    EXPECT_EQ(held.robot.has_answered_fully(), !is_on) << tick;
    EXPECT_EQ(held.robot.truth().faults_active, is_on ? 1U : 0U) << tick;
  }
}

TEST(FaultyRobot, DeadLegBoardIsLimpAndTheWorldGoesOn) {
  HeldRobot held(with({{.kind = kDeadNode, .target = FaultTarget::kLegLeft}}));
  for (int tick = 1; tick <= 150; ++tick) {
    const std::vector<can::CanFrame> answers = answers_of_next_tick(held);
    EXPECT_EQ(has_sent(answers, 0x182), tick < 50) << tick;
    EXPECT_TRUE(has_sent(answers, 0x181));
    ASSERT_NEAR(held.robot.truth().time_s, 1e-3 * tick, 1e-9) << "the torques of the one leg are enough";
    if (tick >= 50) {
      ASSERT_EQ(held.robot.truth().torque_nm[1], LegVector{});
    }
  }
  EXPECT_NE(held.robot.truth().torque_nm[0], LegVector{});
}

TEST(FaultyRobot, BothLegBoardsDeadDoNotStopTheWorld) {
  HeldRobot held(with(
      {{.kind = kDeadNode, .target = FaultTarget::kLegLeft}, {.kind = kDeadNode, .target = FaultTarget::kLegRight}}));
  for (int tick = 1; tick <= 2000; ++tick) (void)answers_of_next_tick(held);
  EXPECT_NEAR(held.robot.truth().time_s, 2.0, 1.1e-3);
  EXPECT_TRUE(held.robot.truth().has_fallen);
}

TEST(FaultyRobot, RestartedLegBoardBootsCountsFromZeroAndWaitsForACommand) {
  HeldRobot held(with({{.kind = kRestart, .target = FaultTarget::kLegRight}}));
  for (int tick = 1; tick < 100; ++tick) (void)answers_of_next_tick(held);
  EXPECT_EQ(held.robot.truth().torque_nm[0], LegVector{});
  const std::vector<can::CanFrame> answers = answers_of_next_tick(held);
  ASSERT_TRUE(has_sent(answers, 0x701));
  can::FrameStamp stamp;
  for (const can::CanFrame& frame : answers) {
    can::Heartbeat heartbeat;
    LegSensors sensors;
    can::LegStatus status;
    if (frame.identifier == 0x701) {
      ASSERT_EQ(can::decode_heartbeat(frame, stamp, heartbeat), can::Rejection::kNone);
      EXPECT_EQ(heartbeat.state, can::NodeState::kBootUp);
      EXPECT_EQ(stamp.counter, 0);
    }
    if (frame.identifier == 0x181) {
      ASSERT_EQ(can::decode_leg_state(frame, stamp, sensors, status), can::Rejection::kNone);
      EXPECT_EQ(stamp.counter, 0);
      EXPECT_TRUE(status.is_damping);
      EXPECT_FALSE(status.watchdog_expired);
    }
  }
  for (int i = 0; i < 3; ++i) (void)answers_of_next_tick(held);
  EXPECT_FALSE(held.puppeteer.status[0].is_damping) << "a fresh command counts again";
}

TEST(FaultyRobot, RestartedFootCountsFromZero) {
  HeldRobot held(
      with({{.kind = kRestart, .target = FaultTarget::kFootLeft}, {.kind = kRestart, .target = FaultTarget::kTorso}}));
  for (int tick = 1; tick < 100; ++tick) (void)answers_of_next_tick(held);
  for (const can::CanFrame& frame : answers_of_next_tick(held)) {
    can::FrameStamp stamp;
    FootSensors foot;
    ImuSensors imu;
    if (can::decode_foot_force(frame, stamp, foot) == can::Rejection::kNone && frame.identifier == 0x184) {
      EXPECT_EQ(stamp.counter, 0);
    }
    if (can::decode_imu(frame, stamp, imu) == can::Rejection::kNone) {
      EXPECT_EQ(stamp.counter, 0);
    }
  }
}

TEST(FaultyRobot, LegBoardOffTheBusDampsByItsWatchdogAndReturnsWithoutBootUp) {
  HeldRobot held(with({{.kind = kBusOff, .target = FaultTarget::kLegRight}}));
  for (int tick = 1; tick < 100; ++tick) {
    EXPECT_EQ(has_sent(answers_of_next_tick(held), 0x181), tick < 50);
    if (tick == 60) {
      EXPECT_NE(held.robot.truth().torque_nm[0], LegVector{}) << "holds its last torques";
    }
  }
  const std::vector<can::CanFrame> answers = answers_of_next_tick(held);
  EXPECT_FALSE(has_sent(answers, 0x701));
  EXPECT_TRUE(held.puppeteer.status[0].watchdog_expired);
  EXPECT_TRUE(held.puppeteer.status[0].is_damping);
  (void)answers_of_next_tick(held);
  (void)answers_of_next_tick(held);
  EXPECT_FALSE(held.puppeteer.status[0].is_damping);
}

TEST(FaultyRobot, LinkDownKeepsTheScenariosTimeAndComesBack) {
  HeldRobot held(with({{.kind = kLinkDown}}));
  for (int tick = 1; tick <= 120; ++tick) {
    const bool is_down = tick >= 50 && tick < 100;
    EXPECT_EQ(answers_of_next_tick(held).empty(), is_down) << tick;
    EXPECT_EQ(held.robot.has_answered_fully(), !is_down) << tick;
    EXPECT_EQ(held.robot.wire_tick(), held.puppeteer.tick) << "the wire saw it";
  }
  EXPECT_NEAR(held.robot.truth().time_s, 0.120, 1e-9) << "made up for";
}

TEST(FaultyRobot, LinkThatIsDownFromTheStartDoesNotShiftTheScenario) {
  SimConfig config = with({{.kind = kLinkDown}, {.kind = kDrop, .target = FaultTarget::kTorso}});
  config.faults[0].at_s = -1.0;
  config.faults[0].for_s = 1.020;
  HeldRobot held(config);
  for (int tick = 1; tick <= 60; ++tick) {
    const std::vector<can::CanFrame> answers = answers_of_next_tick(held);
    EXPECT_EQ(answers.empty(), tick <= 20) << tick;
    EXPECT_EQ(has_sent(answers, 0x185), tick > 20 && tick < 50) << tick;
  }
}

TEST(FaultyRobot, SensorFaultReachesTheFrameAndNotTheWorld) {
  HeldRobot held(with({{.kind = kStuck, .target = FaultTarget::kFootLeft}}));
  for (int tick = 1; tick < 50; ++tick) (void)answers_of_next_tick(held);
  (void)answers_of_next_tick(held);
  const FootSensors first = held.puppeteer.foot[1];
  for (int tick = 51; tick < 60; ++tick) (void)answers_of_next_tick(held);
  EXPECT_EQ(held.puppeteer.foot[1].corner_force_n, first.corner_force_n);
  EXPECT_NE(held.robot.truth().corner_force_n[1], first.corner_force_n);
}

TEST(FaultyRobot, CountsWhatItsFaultsDid) {
  HeldRobot held(with({{.kind = kDrop, .target = FaultTarget::kTorso}}));
  for (int tick = 1; tick <= 120; ++tick) (void)answers_of_next_tick(held);
  EXPECT_EQ(held.robot.counters().faults.dropped, 50U);
}

TEST(FaultyRobot, AnswersInFullOnlyToASyncThatCame) {
  HeldRobot held({});
  EXPECT_FALSE(held.robot.has_answered_fully());
  held.puppeteer.sync();
  EXPECT_TRUE(held.robot.has_answered_fully());
}

TEST(FaultyRobot, RunningFreelyDelaysByPeriodsOfTheWorldsTime) {
  SimConfig config = with({{.kind = kDelay, .target = FaultTarget::kTorso, .value = 3.0}});
  config.faults[0].at_s = 0.0;
  SimulatedRobot robot(config, stance(config.geometry), WorldClock::kFreeRunning);
  Puppeteer puppeteer(robot);
  puppeteer.sync();  // the master has come: faults begin with the next period
  robot.advance_to(0.0006, puppeteer.wire);
  ++puppeteer.tick;
  puppeteer.wire.from_robot.clear();
  puppeteer.wire.to_robot.push_back(can::encode_sync({.tick = puppeteer.tick, .counter = 1}));
  robot.serve(puppeteer.wire);
  EXPECT_FALSE(has_sent(puppeteer.wire.from_robot, 0x185));
  robot.advance_to(0.0026, puppeteer.wire);
  EXPECT_FALSE(has_sent(puppeteer.wire.from_robot, 0x185));
  robot.advance_to(0.0036, puppeteer.wire);
  EXPECT_TRUE(has_sent(puppeteer.wire.from_robot, 0x185));
}

// Released for its silence, the master is known again by its tick: the scenario's clock, and the faults, go on.
TEST(FaultyRobot, RunningFreelyALinkThatWasDownDoesNotSetTheClockBack) {
  SimConfig config = with({{.kind = kLinkDown}});
  SimulatedRobot robot(config, stance(config.geometry), WorldClock::kFreeRunning);
  Puppeteer puppeteer(robot);
  int answered_late = 0;
  for (int tick = 1; tick <= 200; ++tick) {
    puppeteer.wire.from_robot.clear();
    puppeteer.wire.to_robot.push_back(
        can::encode_sync({.tick = static_cast<std::uint32_t>(tick), .counter = static_cast<std::uint8_t>(tick)}));
    robot.serve(puppeteer.wire);
    if (tick > 102 && has_sent(puppeteer.wire.from_robot, 0x185)) ++answered_late;
    if (tick == 90) {
      EXPECT_FALSE(robot.has_master());
    }
    robot.advance_to(1e-3 * tick + 1e-4, puppeteer.wire);
  }
  EXPECT_EQ(answered_late, 98);
  EXPECT_NEAR(robot.truth().time_s, 0.200, 1e-9);
  EXPECT_EQ(robot.truth().faults_active, 0U);
}

}  // namespace
}  // namespace surefoot::sim_hw
