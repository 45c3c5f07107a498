// What becomes of the walking robot after a fault: it stops and stands while its legs obey, else it is lowered.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "firmware/can/messages.hpp"
#include "firmware/core/gait/stance.hpp"
#include "firmware/core/kinematics/leg_kinematics.hpp"
#include "firmware/host/firmware_node.hpp"
#include "firmware/host/memory_bus.hpp"
#include "sim_hw/simulated_robot.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot {
namespace {

using can::CanFrame;
using can::Node;
using decision::ReflexPhase;
using safety::Fault;
using safety::SafeState;
using Frames = std::vector<CanFrame>;
/// What becomes of the robot's answers to the tick that runs.
using Filter = std::function<void(std::uint32_t tick, Frames& answers)>;

constexpr std::uint32_t kWalking = 12'000;  ///< tick of the first scored gait cycle
constexpr std::uint32_t kInstants = 24;
constexpr std::uint32_t kCycle = 4'800;
constexpr std::uint32_t kThreeSeconds = 3'000;
constexpr double kUprightDeg = 10.0;

/// The controller's end of a memory bus, behind a filter.
class FilteredBus final : public can::CanBus {
 public:
  std::size_t send(std::span<const CanFrame> frames) noexcept override { return bus_.controller_end().send(frames); }

  std::size_t receive(std::span<CanFrame> frames) noexcept override {
    if (waiting_.empty()) {
      CanFrame frame;
      while (bus_.controller_end().receive({&frame, 1}) == 1) waiting_.push_back(frame);
      if (filter) filter(tick, waiting_);
    }
    const std::size_t count = std::min(frames.size(), waiting_.size());
    const auto end = waiting_.begin() + static_cast<std::ptrdiff_t>(count);
    std::copy(waiting_.begin(), end, frames.begin());
    waiting_.erase(waiting_.begin(), end);
    return count;
  }

  [[nodiscard]] can::CanBus& robot_end() noexcept { return bus_.robot_end(); }

  Filter filter;
  std::uint32_t tick = 0;

 private:
  host::MemoryBus bus_;
  Frames waiting_;
};

scenario::Scenario walking_scenario(std::vector<std::string> overrides) {
  scenario::Scenario scenario = scenario::load_default(overrides);
  scenario.sim.time_zero_s = 1e-3 * kWalking;
  return scenario;
}

PerSide<LegVector> standing_angles(const ControllerConfig& firmware) {
  const double reference_x_m = firmware.walk.reference_x_body_m;
  return kinematics::inverse(firmware.geometry, gait::stance(firmware.walk, {reference_x_m, reference_x_m})).angle_rad;
}

/// Firmware and robot, from power-up on.
class WalkingRobot {
 public:
  explicit WalkingRobot(const Filter& filter = {}, const std::vector<std::string>& overrides = {"payload=[]"})
      : scenario_(walking_scenario(overrides)) {
    bus.filter = filter;
  }

  void run_to(std::uint32_t tick) {
    while (bus.tick < tick) {
      firmware.begin_tick(bus);
      robot_.serve(bus.robot_end());
      static_cast<void>(firmware.collect(bus));
      output_ = firmware.finish_tick(bus);
      robot_.serve(bus.robot_end());
      const double tilt_rad = std::max(std::abs(truth().pitch_rad), std::abs(truth().roll_rad));
      tilt_deg = std::max(tilt_deg, tilt_rad * 180.0 / std::numbers::pi);
      if (output_.fault != Fault::kNone && fault_tick == 0) fault_tick = bus.tick;
      ++bus.tick;
    }
  }

  [[nodiscard]] bool stands() const {
    return !truth().has_fallen && output_.decision.phase == ReflexPhase::kStopped && tilt_deg < kUprightDeg &&
           output_.command[0].mode == LegMode::kTorque;
  }
  [[nodiscard]] const TickOutput& output() const { return output_; }
  [[nodiscard]] const sim_hw::GroundTruth& truth() const { return robot_.truth(); }

  FilteredBus bus;
  double tilt_deg = 0.0;         ///< largest pitch or roll so far
  std::uint32_t fault_tick = 0;  ///< 0: none

 private:
  scenario::Scenario scenario_;

 public:
  host::FirmwareNode firmware{scenario_.firmware};

 private:
  sim_hw::SimulatedRobot robot_{scenario_.sim, standing_angles(scenario_.firmware)};
  TickOutput output_{};
};

void lose(Frames& frames, std::uint16_t identifier) {
  std::erase_if(frames, [identifier](const CanFrame& frame) { return frame.identifier == identifier; });
}

Filter dead_from(std::uint32_t from, Node node) {
  return [=](std::uint32_t tick, Frames& frames) {
    if (tick >= from) lose(frames, can::state_identifier(node));
  };
}

struct Plant {
  const char* name;
  std::vector<std::string> overrides;
};

class SafeStop : public ::testing::TestWithParam<Plant> {};

// 24 instants of the gait cycle, either foot dead or both at once; the fault, the stop, and three seconds of standing.
TEST_P(SafeStop, StandsUpThroughADeadFootNodeAtEveryInstantOfTheCycle) {
  const std::vector<std::vector<Node>> kinds{
      {Node::kFootRight}, {Node::kFootLeft}, {Node::kFootRight, Node::kFootLeft}};
  std::uint32_t stood = 0;
  for (std::uint32_t instant = 0; instant < kInstants; ++instant) {
    for (const std::vector<Node>& dead : kinds) {
      const std::uint32_t from = kWalking + instant * (kCycle / kInstants);
      WalkingRobot robot(
          [&](std::uint32_t tick, Frames& frames) {
            for (const Node node : dead) dead_from(from, node)(tick, frames);
          },
          GetParam().overrides);
      robot.run_to(from + 10 + kThreeSeconds);
      EXPECT_EQ(robot.fault_tick, from + 10);
      EXPECT_EQ(robot.output().fault, Fault::kSensorSilent);
      EXPECT_EQ(robot.output().safe_state, SafeState::kStanceHold);
      EXPECT_TRUE(robot.stands()) << "instant " << instant << ", tilt " << robot.tilt_deg;
      if (robot.stands()) ++stood;
    }
  }
  EXPECT_EQ(stood, kInstants * 3);
}

TEST_P(SafeStop, StandsUpThroughADeadImu) {
  const std::uint32_t from = kWalking + 1'000;
  WalkingRobot robot(dead_from(from, Node::kTorsoImu), GetParam().overrides);
  robot.run_to(from + 10 + kThreeSeconds);
  EXPECT_EQ(robot.output().safe_state, SafeState::kStanceHold);
  EXPECT_TRUE(robot.stands());
}

INSTANTIATE_TEST_SUITE_P(Plants, SafeStop,
                         ::testing::Values(Plant{"thesis", {"payload=[]"}},
                                           Plant{"nominal", {"payload=[]", "plant=\"nominal\""}}),
                         [](const auto& plant) { return std::string(plant.param.name); });

// The main job's load at 1.2 s: reflex, settling, shift, step, rest, walk; a stop in each of them.
TEST(SafeStopOfALoadedRobot, StandsUpInEveryPhaseOfTheReflex) {
  std::vector<ReflexPhase> seen;
  for (const std::uint32_t after_ms : {1'250U, 1'290U, 1'320U, 1'400U, 2'500U, 3'500U, 4'200U, 5'500U, 7'000U}) {
    WalkingRobot robot({}, {});
    robot.run_to(kWalking + after_ms);
    seen.push_back(robot.output().decision.phase);
    robot.firmware.request_stop(safety::finding_of(Fault::kLoopOverrun));
    robot.run_to(kWalking + after_ms + kThreeSeconds);
    EXPECT_EQ(robot.output().fault, Fault::kLoopOverrun);
    EXPECT_TRUE(robot.stands()) << after_ms << " ms, tilt " << robot.tilt_deg;
  }
  for (const ReflexPhase phase : {ReflexPhase::kWalking, ReflexPhase::kReflex, ReflexPhase::kSettling,
                                  ReflexPhase::kShifting, ReflexPhase::kRestoring, ReflexPhase::kResting}) {
    EXPECT_NE(std::find(seen.begin(), seen.end(), phase), seen.end()) << name(phase);
  }
}

TEST(SafeState, OfADeadLegBoardLowersTheRobotByDampingBothLegs) {
  const std::uint32_t from = kWalking + 1'000;
  WalkingRobot robot(dead_from(from, Node::kLegLeft));
  robot.run_to(from + 11);
  EXPECT_EQ(robot.output().fault, Fault::kSensorSilent);
  EXPECT_EQ(robot.output().safe_state, SafeState::kDamp);
  for (const LegCommand& leg : robot.output().command) EXPECT_EQ(leg.mode, LegMode::kDamp);
}

TEST(SafeState, GoesFromTheStanceToDampingWhenALegBoardDiesAfterAFoot) {
  const std::uint32_t from = kWalking + 1'000;
  WalkingRobot robot([&](std::uint32_t tick, Frames& frames) {
    dead_from(from, Node::kFootLeft)(tick, frames);
    dead_from(from + 2'000, Node::kLegRight)(tick, frames);
  });
  robot.run_to(from + 2'000);
  EXPECT_TRUE(robot.stands());
  robot.run_to(from + 2'011);
  EXPECT_EQ(robot.output().fault, Fault::kSensorSilent);
  EXPECT_EQ(robot.output().safe_state, SafeState::kDamp);
  EXPECT_EQ(robot.output().command[1].mode, LegMode::kDamp);
}

/// Rewrites the answers of one node from a tick on; its counters and CRC stay right.
template <typename Sensors, typename Decode, typename Encode, typename Lie>
Filter lying_from(std::uint32_t from, std::uint16_t identifier, Decode decode, Encode encode, Lie lie) {
  return [=, held = Sensors{}](std::uint32_t tick, Frames& frames) mutable {
    for (CanFrame& frame : frames) {
      if (frame.identifier != identifier) continue;
      can::FrameStamp stamp;
      Sensors sensors;
      ASSERT_EQ(decode(frame, stamp, sensors), can::Rejection::kNone);
      if (tick < from) held = sensors;
      if (tick >= from) lie(sensors, held);
      stamp.tick = tick;
      frame = encode(stamp, sensors);
    }
  };
}

template <typename Lie>
Filter lying_leg(std::uint32_t from, Side side, Lie lie) {
  return lying_from<LegSensors>(
      from, can::state_identifier(can::leg_node(side)),
      [](const CanFrame& frame, can::FrameStamp& stamp, LegSensors& leg) {
        can::LegStatus status;
        return can::decode_leg_state(frame, stamp, leg, status);
      },
      [side](can::FrameStamp stamp, const LegSensors& leg) { return can::encode_leg_state(side, stamp, leg, {}); },
      lie);
}

template <typename Lie>
Filter lying_foot(std::uint32_t from, Side side, Lie lie) {
  return lying_from<FootSensors>(
      from, can::state_identifier(can::foot_node(side)), can::decode_foot_force,
      [side](can::FrameStamp stamp, const FootSensors& foot) { return can::encode_foot_force(side, stamp, foot); },
      lie);
}

struct Liar {
  const char* name;
  Filter filter;
  SafeState needs;
  std::uint32_t within_ticks;  ///< of the fault
};

class LyingSensor : public ::testing::TestWithParam<Liar> {};

constexpr std::uint32_t kLiesFrom = kWalking + 1'000;  // the left foot is in the air

TEST_P(LyingSensor, LatchesSensorImplausibleInTimeAndTakesItsSafeState) {
  WalkingRobot robot(GetParam().filter);
  robot.run_to(kLiesFrom + GetParam().within_ticks);
  ASSERT_EQ(robot.output().fault, Fault::kSensorImplausible) << name(robot.output().fault);
  EXPECT_EQ(robot.output().safe_state, GetParam().needs);
  if (GetParam().needs != SafeState::kStanceHold) return;
  robot.run_to(robot.fault_tick + kThreeSeconds);
  EXPECT_TRUE(robot.stands()) << "tilt " << robot.tilt_deg;
}

constexpr std::size_t kKnee = index(LegJoint::kKneePitch);

INSTANTIATE_TEST_SUITE_P(
    Kinds, LyingSensor,
    ::testing::Values(
        Liar{"stuck_encoder",
             lying_leg(kLiesFrom, Side::kLeft,
                       [](LegSensors& leg, const LegSensors& held) { leg.angle_rad[kKnee] = held.angle_rad[kKnee]; }),
             SafeState::kDamp, 60},
        Liar{"jumping_encoder",
             lying_leg(kLiesFrom, Side::kRight,
                       [](LegSensors& leg, const LegSensors&) { leg.angle_rad[kKnee] += 0.05; }),
             SafeState::kDamp, 1},
        Liar{"stuck_rate",
             lying_leg(kLiesFrom, Side::kLeft,
                       [](LegSensors& leg, const LegSensors& held) { leg.rate_rad_s[kKnee] = held.rate_rad_s[kKnee]; }),
             SafeState::kDamp, 400},
        Liar{"stuck_imu",
             lying_from<ImuSensors>(kLiesFrom, can::state_identifier(Node::kTorsoImu), can::decode_imu, can::encode_imu,
                                    [](ImuSensors& imu, const ImuSensors& held) { imu = held; }),
             SafeState::kStanceHold, 510},
        Liar{"stuck_foot",
             lying_foot(kLiesFrom, Side::kRight, [](FootSensors& foot, const FootSensors& held) { foot = held; }),
             SafeState::kStanceHold, 510},
        Liar{"foot_reads_zero",
             lying_foot(kLiesFrom, Side::kRight,
                        [](FootSensors& foot, const FootSensors&) { foot.corner_force_n = {}; }),
             SafeState::kStanceHold, 410},
        Liar{"saturated_corner",
             lying_foot(kLiesFrom, Side::kRight,
                        [](FootSensors& foot, const FootSensors&) { foot.corner_force_n[1] = 3'200.0; }),
             SafeState::kStanceHold, 410}),
    [](const auto& liar) { return std::string(liar.param.name); });

// A second controller on the bus: its SYNC of this tick is enough. A log of ours played back is not.
TEST(SecondMaster, StopsTheRobotInItsStanceAndAReplayDoesNot) {
  Frames old;
  WalkingRobot robot([&](std::uint32_t tick, Frames& frames) {
    const CanFrame sync = can::encode_sync({.tick = tick, .counter = static_cast<std::uint8_t>(tick)});
    if (tick < kWalking) old.push_back(sync);
    if (tick >= kWalking && tick < kWalking + 2'000) frames.push_back(old[tick - kWalking]);
    if (tick == kWalking + 3'000) frames.push_back(sync);
  });
  robot.run_to(kWalking + 3'000);
  EXPECT_EQ(robot.output().fault, Fault::kNone);
  robot.run_to(kWalking + 3'000 + kThreeSeconds);
  EXPECT_EQ(robot.fault_tick, kWalking + 3'000);
  EXPECT_EQ(robot.output().fault, Fault::kSecondMaster);
  EXPECT_TRUE(robot.stands());
}

TEST(ForeignVersion, OfAFootThatComesBackWithOtherSoftwareStopsTheRobotInItsStance) {
  WalkingRobot robot([](std::uint32_t tick, Frames& frames) {
    if (tick != kLiesFrom) return;
    frames.push_back(can::encode_heartbeat(Node::kFootRight, {.tick = tick, .counter = 200},
                                           {.state = can::NodeState::kBootUp, .protocol_version = 2}));
  });
  robot.run_to(kLiesFrom + 50);
  EXPECT_EQ(robot.fault_tick, kLiesFrom);
  EXPECT_EQ(robot.output().fault, Fault::kForeignVersion);
  robot.run_to(kLiesFrom + kThreeSeconds);
  EXPECT_TRUE(robot.stands());
}

}  // namespace
}  // namespace surefoot
