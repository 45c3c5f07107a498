// The loop and the start-up of the firmware's process, against a robot in the same thread.
#include "firmware/host/loop/firmware_loop.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>

#include "firmware/host/loop/start_up.hpp"
#include "sim_hw/simulated_robot.hpp"
#include "tests/closed_loop/inline_bus.hpp"
#include "tests/closed_loop/run_scenario.hpp"
#include "tools/run/schedule.hpp"
#include "tools/run/standing_pose.hpp"

namespace surefoot {
namespace {

using host::await_robot;
using testing::InlineBus;

const std::atomic<bool> kNeverStop{false};

class Silent final : public host::TickObserver {
 public:
  void before_tick(std::int64_t) noexcept override { ++ticks; }
  void after_tick(const host::FirmwareNode&, const TickOutput& output) noexcept override { last = output; }
  void between_ticks(const host::LoopReport*) noexcept override {}

  std::int64_t ticks = 0;
  TickOutput last{};
};

scenario::Scenario main_job() { return run::scheduled(scenario::load_default()); }

/// A robot that announces itself while nobody drives it, as the service does.
struct InlineRobot {
  explicit InlineRobot(const scenario::Scenario& scenario)
      : robot(scenario.sim, run::standing_pose(scenario.firmware)) {}

  void operator()(InlineBus::FarEnd& bus) {
    if (is_dead) return bus.from_firmware.clear();
    do {
      robot.serve(bus);  // up to the end of a period: SYNC of the next tick waits behind the torques of this one
    } while (!bus.from_firmware.empty());
    if (!robot.has_master()) robot.announce(bus);
  }

  sim_hw::SimulatedRobot robot;
  bool is_dead = false;
};

host::StartUpConfig short_start_up() { return {.listen_ns = 1'000'000, .patience_ns = 300'000'000}; }

bool start(host::FirmwareNode& node, InlineBus& bus, const host::StartUpConfig& config = short_start_up()) {
  return await_robot(node, bus, config, kNeverStop, [](const std::string&) {});
}

class FirmwareProcess : public ::testing::Test {
 protected:
  scenario::Scenario scenario = main_job();
  InlineRobot robot{scenario};
  InlineBus bus{std::ref(robot)};
  host::FirmwareNode node{scenario.firmware};
  Silent observer;
};

TEST_F(FirmwareProcess, StartsOnceAllNodesHaveAnnouncedThemselves) {
  EXPECT_TRUE(start(node, bus));
  for (const can::CanFrame& frame : bus.sent) {
    EXPECT_EQ(frame.identifier, can::heartbeat_identifier(can::Node::kController))
        << "no SYNC, no torque before tick 0";
  }
}

TEST_F(FirmwareProcess, DoesNotStartWithoutARobotAndNamesTheNodesThatAreMissing) {
  robot.is_dead = true;
  try {
    (void)start(node, bus);
    FAIL() << "started without a robot";
  } catch (const host::StartUpError& error) {
    EXPECT_NE(std::string(error.what()).find("left foot"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("remedy"), std::string::npos);
  }
}

TEST_F(FirmwareProcess, DoesNotStartBesideAnotherMaster) {
  bus.far().to_firmware.push_back(can::encode_sync({.tick = 4711, .counter = 9}));
  EXPECT_THROW((void)start(node, bus), host::StartUpError);
  EXPECT_TRUE(bus.sent.empty()) << "it must not send a single frame into another one's traffic";
}

TEST_F(FirmwareProcess, DoesNotStartWithANodeOfAnotherProtocolVersion) {
  InlineBus mixed([](InlineBus::FarEnd& far) {
    far.from_firmware.clear();
    for (const can::Node each : can::kSensorNodes) {
      const auto version = static_cast<std::uint8_t>(can::kProtocolVersion + (each == can::Node::kFootRight ? 1 : 0));
      const can::CanFrame frame =
          can::encode_heartbeat(each, {}, {.state = can::NodeState::kPreOperational, .protocol_version = version});
      far.to_firmware.push_back(frame);
    }
  });
  try {
    (void)start(node, mixed);
    FAIL() << "started with a foreign node";
  } catch (const host::StartUpError& error) {
    EXPECT_NE(std::string(error.what()).find("right foot speaks protocol version 2"), std::string::npos)
        << error.what();
  }
}

TEST_F(FirmwareProcess, DoesNotStartOnTheWallClockWithARobotThatWaitsForEachTick) {
  host::StartUpConfig wall = short_start_up();
  wall.clock = host::LoopClock::kWall;
  EXPECT_THROW((void)start(node, bus, wall), host::StartUpError);
}

// In lockstep a robot with a clock of its own would be driven twenty times too fast.
TEST_F(FirmwareProcess, DoesNotStartInLockstepWithARobotOnItsOwnClock) {
  sim_hw::SimulatedRobot free(scenario.sim, run::standing_pose(scenario.firmware), sim_hw::WorldClock::kFreeRunning);
  InlineBus free_bus([&free](InlineBus::FarEnd& far) {
    free.serve(far);
    if (!free.has_master()) free.announce(far);
  });
  EXPECT_THROW((void)start(node, free_bus), host::StartUpError);
}

TEST_F(FirmwareProcess, WalksInLockstepAsInOneProcess) {
  ASSERT_TRUE(start(node, bus));
  host::FirmwareLoopConfig config;
  config.ticks = run::schedule_of(scenario).zero_tick + 5000;
  const host::FirmwareLoopResult result = host::run_firmware_loop(node, bus, config, observer, kNeverStop);
  EXPECT_EQ(result.ticks, config.ticks);
  EXPECT_EQ(result.fault, safety::Fault::kNone);
  EXPECT_EQ(result.silent_ticks, 0U);
  EXPECT_FALSE(robot.robot.truth().has_fallen);
  EXPECT_NE(observer.last.decision.phase, decision::ReflexPhase::kStanding);
  EXPECT_EQ(robot.robot.tick() + 1, config.ticks);
}

TEST_F(FirmwareProcess, LatchesAFaultWhenTheRobotDiesAndGoesOnInItsSafeState) {
  ASSERT_TRUE(start(node, bus));
  host::FirmwareLoopConfig config;
  config.silence_ns = 20'000'000;
  config.silent_period_ns = 1'000'000;
  config.ticks = 100;
  (void)host::run_firmware_loop(node, bus, config, observer, kNeverStop);
  robot.is_dead = true;
  bus.sent.clear();
  const host::FirmwareLoopResult result = host::run_firmware_loop(node, bus, config, observer, kNeverStop);
  EXPECT_EQ(result.fault, safety::Fault::kSensorSilent);
  EXPECT_EQ(result.silent_ticks, 100U);
  for (auto frame = bus.sent.rbegin(); frame != bus.sent.rbegin() + 20; ++frame) {
    can::FrameStamp stamp;
    LegCommand command;
    if (can::decode_leg_command(*frame, stamp, command) != can::Rejection::kNone) continue;
    EXPECT_EQ(command.mode, LegMode::kDamp);
  }
}

TEST_F(FirmwareProcess, EndsWithItsFaultIfAskedTo) {
  ASSERT_TRUE(start(node, bus));
  robot.is_dead = true;
  host::FirmwareLoopConfig config;
  config.silence_ns = 2'000'000;
  config.silent_period_ns = 500'000;
  config.ends_at_fault = true;
  const host::FirmwareLoopResult result = host::run_firmware_loop(node, bus, config, observer, kNeverStop);
  EXPECT_NE(result.fault, safety::Fault::kNone);
  EXPECT_LT(result.ticks, 30);
}

TEST_F(FirmwareProcess, StopsWhenItIsAskedTo) {
  ASSERT_TRUE(start(node, bus));
  const std::atomic<bool> stop{true};
  EXPECT_EQ(host::run_firmware_loop(node, bus, {}, observer, stop).ticks, 0);
}

// The wall clock's figures depend on the machine; what must hold is its bookkeeping.
TEST_F(FirmwareProcess, CountsEveryTickOfTheWallClockAsRunOrMissed) {
  ASSERT_TRUE(start(node, bus));
  host::FirmwareLoopConfig config;
  config.clock = host::LoopClock::kWall;
  config.ticks = 200;
  const host::FirmwareLoopResult result = host::run_firmware_loop(node, bus, config, observer, kNeverStop);
  EXPECT_GE(result.ticks, config.ticks);
  EXPECT_EQ(result.report.ticks + result.report.missed_ticks, result.ticks);
  EXPECT_GE(result.report.wake_up.count, static_cast<std::uint64_t>(result.report.ticks));
}

// The boards have damped by then: the robot is not where the references are.
TEST_F(FirmwareProcess, DampsAfterAGapThatTheBoardsDoNotHoldThrough) {
  ASSERT_TRUE(start(node, bus));
  int waits = 0;
  InlineBus stalled([&](InlineBus::FarEnd& far) {
    if (++waits == 30) {
      const std::int64_t until_ns = host::MonotonicClock::now_ns() + 60'000'000;
      while (host::MonotonicClock::now_ns() < until_ns) {
      }
    }
    robot(far);
  });
  host::FirmwareLoopConfig config;
  config.clock = host::LoopClock::kWall;
  config.ticks = 400;
  config.ends_at_fault = true;
  config.overruns.degrade_after_missed_ticks = 0;
  const host::FirmwareLoopResult result = host::run_firmware_loop(node, stalled, config, observer, kNeverStop);
  EXPECT_NE(result.fault, safety::Fault::kNone);  // on a busy machine the boards' own word may come first
  EXPECT_EQ(observer.last.safe_state, safety::SafeState::kDamp);
}

TEST_F(FirmwareProcess, AFloodedBusDoesNotKeepItFromStopping) {
  ASSERT_TRUE(start(node, bus));
  std::atomic<bool> stop{false};
  int waits = 0;
  InlineBus flooded([&](InlineBus::FarEnd& far) {
    far.from_firmware.clear();
    far.to_firmware.assign(1, can::encode_sync({}));
    if (++waits == 100) stop.store(true);
  });
  host::FirmwareLoopConfig config;
  config.clock = host::LoopClock::kWall;
  (void)host::run_firmware_loop(node, flooded, config, observer, stop);
  SUCCEED() << "it came back";
}

TEST_F(FirmwareProcess, AsksForASafeStopWhenItCannotKeepItsPeriod) {
  ASSERT_TRUE(start(node, bus));
  InlineBus slow([this](InlineBus::FarEnd& far) {
    const std::int64_t until_ns = host::MonotonicClock::now_ns() + 3'000'000;
    while (host::MonotonicClock::now_ns() < until_ns) {
    }
    robot(far);
  });
  host::FirmwareLoopConfig config;
  config.clock = host::LoopClock::kWall;
  config.ticks = 200;
  config.overruns = {.degrade_after_missed_ticks = 4, .window_ticks = 100};
  const host::FirmwareLoopResult result = host::run_firmware_loop(node, slow, config, observer, kNeverStop);
  EXPECT_NE(result.fault, safety::Fault::kNone);  // on a busy machine the boards' own word may come first
  EXPECT_TRUE(result.report.is_degraded);
}

}  // namespace
}  // namespace surefoot
