// The closed loop on a bus that loses, repeats, shuffles and damages frames.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <numbers>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "firmware/can/messages.hpp"
#include "firmware/core/gait/stance.hpp"
#include "firmware/core/kinematics/leg_kinematics.hpp"
#include "firmware/host/firmware_node.hpp"
#include "firmware/host/memory_bus.hpp"
#include "sim_hw/simulated_robot.hpp"
#include "tools/run/verdict.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot {
namespace {

using can::CanFrame;
using Frames = std::vector<CanFrame>;
using Disturbance = std::function<void(Frames&)>;  ///< what the bus makes of a batch on its way

constexpr std::uint32_t kWalking = 12'000;  ///< tick of the first scored gait cycle
constexpr std::uint32_t kSecond = 1'000;    ///< in ticks
constexpr std::uint32_t kNever = 0xFFFF'FFFFU;

const std::vector<std::string> kNoPayload{"payload=[]"};
const std::vector<std::string> kMainJob{};  ///< 5 kg at 1.2 s

/// The controller's end of a memory bus, behind a disturbance in either direction.
class DisturbedBus final : public can::CanBus {
 public:
  std::size_t send(std::span<const CanFrame> frames) noexcept override {
    Frames batch(frames.begin(), frames.end());
    if (to_robot) to_robot(batch);
    static_cast<void>(bus_.controller_end().send(batch));
    return frames.size();
  }

  std::size_t receive(std::span<CanFrame> frames) noexcept override {
    if (waiting_.empty()) {
      CanFrame frame;
      while (bus_.controller_end().receive({&frame, 1}) == 1) waiting_.push_back(frame);
      if (to_controller) to_controller(waiting_);
    }
    const std::size_t count = std::min(frames.size(), waiting_.size());
    const auto end = waiting_.begin() + static_cast<std::ptrdiff_t>(count);
    std::copy(waiting_.begin(), end, frames.begin());
    waiting_.erase(waiting_.begin(), end);
    return count;
  }

  [[nodiscard]] can::CanBus& robot_end() noexcept { return bus_.robot_end(); }

  Disturbance to_robot;
  Disturbance to_controller;

 private:
  host::MemoryBus bus_;
  Frames waiting_;
};

scenario::Scenario scenario_with(const std::vector<std::string>& overrides) {
  scenario::Scenario scenario = scenario::load_default(overrides);
  scenario.sim.time_zero_s = 1e-3 * kWalking;
  return scenario;
}

PerSide<LegVector> standing_angles(const ControllerConfig& firmware) {
  const double reference_x_m = firmware.walk.reference_x_body_m;
  return kinematics::inverse(firmware.geometry, gait::stance(firmware.walk, {reference_x_m, reference_x_m})).angle_rad;
}

/// Firmware and robot, from power-up on.
class ClosedLoop {
 public:
  explicit ClosedLoop(const std::vector<std::string>& overrides = kNoPayload) : scenario_(scenario_with(overrides)) {}

  void run_to(std::uint32_t tick) {
    while (tick_ < tick) cycle();
  }

  void cycle() {
    firmware_.begin_tick(bus);
    robot_.serve(bus.robot_end());
    static_cast<void>(firmware_.collect(bus));
    output_ = firmware_.finish_tick(bus);
    robot_.serve(bus.robot_end());
    pitch_deg.include(truth().pitch_rad * 180.0 / std::numbers::pi);
    if (output_.fault != safety::Fault::kNone && fault_tick == kNever) fault_tick = tick_;
    torques_nm.push_back(truth().torque_nm);
    ++tick_;
  }

  [[nodiscard]] bool is_walking() const {
    return !truth().has_fallen && output_.fault == safety::Fault::kNone &&
           output_.decision.phase == decision::ReflexPhase::kWalking;
  }
  [[nodiscard]] std::uint32_t tick() const { return tick_; }  ///< the one that comes next, or runs
  [[nodiscard]] const TickOutput& output() const { return output_; }
  [[nodiscard]] const sim_hw::GroundTruth& truth() const { return robot_.truth(); }
  [[nodiscard]] const SensorSnapshot& snapshot() const { return firmware_.snapshot(); }
  [[nodiscard]] const can::FrameCounters& counters() const { return firmware_.counters(); }
  [[nodiscard]] sim_hw::NodeCounters robot_counters() const { return robot_.counters(); }

  DisturbedBus bus;
  run::Range pitch_deg;
  std::uint32_t fault_tick = kNever;
  std::vector<PerSide<LegVector>> torques_nm;  ///< applied, by tick

 private:
  scenario::Scenario scenario_;
  host::FirmwareNode firmware_{scenario_.firmware};
  sim_hw::SimulatedRobot robot_{scenario_.sim, standing_angles(scenario_.firmware)};
  TickOutput output_{};
  std::uint32_t tick_ = 0;
};

/// Loses the frames of one identifier in ticks [from, to).
Disturbance loses(const ClosedLoop& loop, std::uint16_t identifier, std::uint32_t from, std::uint32_t to = kNever) {
  return [&loop, identifier, from, to](Frames& frames) {
    if (loop.tick() < from || loop.tick() >= to) return;
    std::erase_if(frames, [identifier](const CanFrame& frame) { return frame.identifier == identifier; });
  };
}

std::uint64_t count(const std::array<std::uint64_t, can::kRejectionCauses>& rejected, can::Rejection cause) {
  return rejected[static_cast<std::size_t>(cause)];
}

class OneLegUncommanded : public ::testing::TestWithParam<Side> {};

// The board's watchdog, the firmware's ride-through, and a tick each to report and to latch.
TEST_P(OneLegUncommanded, LatchesBoardDampingInTimeAndDampsBothLegs) {
  ClosedLoop loop;
  const std::uint32_t lost_at = kWalking + kSecond;
  loop.bus.to_robot = loses(loop, can::command_identifier(can::leg_node(GetParam())), lost_at);
  loop.run_to(lost_at + 500);
  EXPECT_EQ(loop.output().fault, safety::Fault::kBoardDamping);
  ASSERT_NE(loop.fault_tick, kNever);
  EXPECT_GT(loop.fault_tick - lost_at, 20U + 10U - 2U);
  EXPECT_LE(loop.fault_tick - lost_at, 20U + 10U + 2U);
}

TEST_P(OneLegUncommanded, SendsNoTorqueAfterTheFault) {
  ClosedLoop loop;
  const std::uint32_t lost_at = kWalking + kSecond;
  const Disturbance loss = loses(loop, can::command_identifier(can::leg_node(GetParam())), lost_at);
  int torque_frames_late = 0;
  int damping_frames = 0;
  loop.bus.to_robot = [&](Frames& frames) {
    for (const CanFrame& frame : frames) {
      for (const Side side : kSides) {
        can::FrameStamp stamp;
        LegCommand command;
        if (frame.identifier != can::command_identifier(can::leg_node(side))) continue;
        ASSERT_EQ(can::decode_leg_command(frame, stamp, command), can::Rejection::kNone);
        if (loop.tick() < lost_at + 32) continue;
        const bool is_damping = command.mode == LegMode::kDamp && command.torque_nm == LegVector{};
        ++(is_damping ? damping_frames : torque_frames_late);
      }
    }
    loss(frames);
  };
  loop.run_to(lost_at + 200);
  EXPECT_EQ(torque_frames_late, 0);
  EXPECT_EQ(damping_frames, 2 * (200 - 32));
  for (const Side side : kSides) EXPECT_TRUE(loop.snapshot().leg[index(side)].is_damping);
}

INSTANTIATE_TEST_SUITE_P(EitherLeg, OneLegUncommanded, ::testing::ValuesIn(kSides),
                         [](const auto& side) { return side.param == Side::kRight ? "right" : "left"; });

class SilentNode : public ::testing::TestWithParam<can::Node> {};

// Double support, left swing, touch-down, right swing.
TEST_P(SilentNode, ForFiveTicksIsRiddenThroughInEveryPartOfTheStep) {
  ClosedLoop loop;
  std::vector<Disturbance> outages;
  for (const std::uint32_t into_cycle : {200U, 1'200U, 1'890U, 3'600U}) {
    const std::uint32_t from = kWalking + into_cycle;
    outages.push_back(loses(loop, can::state_identifier(GetParam()), from, from + 5));
  }
  loop.bus.to_controller = [&](Frames& frames) {
    for (const Disturbance& outage : outages) outage(frames);
  };
  loop.run_to(kWalking);
  loop.pitch_deg = {};
  loop.run_to(kWalking + 3'600 + 5 * kSecond);
  EXPECT_TRUE(loop.is_walking()) << "fault " << safety::name(loop.output().fault);
  EXPECT_LT(loop.pitch_deg.largest_magnitude(), 2.5);
  EXPECT_EQ(loop.counters().lost, 4U * 5U);
}

TEST_P(SilentNode, ForFiftyTicksLatchesOneTickAfterTheRideThrough) {
  ClosedLoop loop;
  const std::uint32_t from = kWalking + kSecond;
  loop.bus.to_controller = loses(loop, can::state_identifier(GetParam()), from, from + 50);
  loop.run_to(from + 100);
  EXPECT_EQ(loop.output().fault, safety::Fault::kSensorSilent);
  EXPECT_EQ(loop.fault_tick, from + 10);
}

INSTANTIATE_TEST_SUITE_P(EveryNode, SilentNode,
                         ::testing::Values(can::Node::kLegRight, can::Node::kLegLeft, can::Node::kFootRight,
                                           can::Node::kFootLeft, can::Node::kTorsoImu),
                         [](const auto& node) { return "node" + std::to_string(static_cast<int>(node.param)); });

struct Loss {
  unsigned frames_in_10000;
  std::uint32_t seed;
};

class RandomLoss : public ::testing::TestWithParam<Loss> {};

// One frame in a thousand to one in ten, either way, SYNC included; nothing is taken for a payload. At one in
// five a node is silent beyond the ride-through within some seconds, and that latches.
TEST_P(RandomLoss, IsWalkedThroughWithoutAFalseAlarm) {
  ClosedLoop loop;
  std::mt19937 random(GetParam().seed);
  std::uint64_t lost = 0;
  const Disturbance loss = [&](Frames& frames) {
    if (loop.tick() < kWalking) return;
    lost += std::erase_if(frames, [&](const CanFrame&) { return random() % 10'000 < GetParam().frames_in_10000; });
  };
  loop.bus.to_robot = loop.bus.to_controller = loss;
  loop.run_to(kWalking);
  loop.pitch_deg = {};
  loop.run_to(kWalking + 20 * kSecond);
  EXPECT_TRUE(loop.is_walking()) << "fault " << safety::name(loop.output().fault) << " at " << loop.fault_tick;
  EXPECT_FALSE(loop.output().decision.trigger_time_s);
  EXPECT_LT(loop.pitch_deg.largest_magnitude(), 2.5);
  EXPECT_GT(lost, 100U);
}

INSTANTIATE_TEST_SUITE_P(Rates, RandomLoss,
                         ::testing::Values(Loss{10, 1}, Loss{10, 2}, Loss{10, 3}, Loss{100, 1}, Loss{100, 2},
                                           Loss{500, 1}, Loss{500, 2}, Loss{1000, 1}, Loss{1000, 2}, Loss{1000, 3}),
                         [](const auto& loss) {
                           return std::to_string(loss.param.frames_in_10000) + "_in_10000_seed_" +
                                  std::to_string(loss.param.seed);
                         });

/// Reflex and recovery included: eight seconds after the main job's time zero.
const std::vector<PerSide<LegVector>>& undisturbed_torques_nm() {
  static const std::vector<PerSide<LegVector>> torques_nm = [] {
    ClosedLoop loop(kMainJob);
    loop.run_to(kWalking + 8 * kSecond);
    return loop.torques_nm;
  }();
  return torques_nm;
}

TEST(DisorderedFrames, InAnyOrderWithinATickGiveTheSameBits) {
  ClosedLoop loop(kMainJob);
  std::mt19937 random(11);
  loop.bus.to_controller = [&](Frames& frames) {
    for (std::size_t i = frames.size(); i > 1; --i) std::swap(frames[i - 1], frames[random() % i]);
  };
  loop.run_to(kWalking + 8 * kSecond);
  EXPECT_EQ(loop.torques_nm, undisturbed_torques_nm());
  for (const std::uint64_t rejected : loop.counters().rejected) EXPECT_EQ(rejected, 0U);
}

TEST(DuplicatedFrames, AreCountedAndChangeNoBit) {
  ClosedLoop loop(kMainJob);
  std::uint64_t seen = 0;
  std::uint64_t duplicates = 0;
  loop.bus.to_controller = [&](Frames& frames) {
    for (std::size_t i = 0; i < frames.size(); ++i) {
      if (++seen % 97 != 0) continue;
      frames.insert(frames.begin() + static_cast<std::ptrdiff_t>(i), CanFrame{frames[i]});
      ++i;
      ++duplicates;
    }
  };
  loop.run_to(kWalking + 8 * kSecond);
  EXPECT_EQ(loop.torques_nm, undisturbed_torques_nm());
  EXPECT_GT(duplicates, 1'000U);
  EXPECT_EQ(count(loop.counters().rejected, can::Rejection::kRepeated), duplicates);
  EXPECT_EQ(loop.counters().lost, 0U);
}

TEST(DuplicatedFrames, OfTheControllerAreCountedByTheRobotAndChangeNoBit) {
  ClosedLoop loop(kMainJob);
  std::uint64_t duplicates = 0;
  loop.bus.to_robot = [&](Frames& frames) {
    if (loop.tick() % 97 != 0 || frames.front().identifier == can::kSyncIdentifier) return;
    frames.insert(frames.begin(), frames.front());
    ++duplicates;
  };
  loop.run_to(kWalking + 8 * kSecond);
  EXPECT_EQ(loop.torques_nm, undisturbed_torques_nm());
  EXPECT_GT(duplicates, 100U);
  EXPECT_EQ(count(loop.robot_counters().rejected, can::Rejection::kRepeated), duplicates);
}

/// Damage within what the CRC finds for certain: one byte, or three single bits.
void damage(CanFrame& frame, std::mt19937& random) {
  if (random() % 2 == 0) {
    frame.payload[random() % frame.length] ^= static_cast<std::uint8_t>(1 + random() % 255);
    return;
  }
  const std::uint32_t bits = 8U * frame.length;
  const std::uint32_t first = static_cast<std::uint32_t>(random()) % bits;
  for (const std::uint32_t bit : {first, (first + 1 + bits / 5) % bits, (first + 2 + bits / 2) % bits}) {
    frame.payload[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
  }
}

/// Frames of the control loop: the robot does not look into the controller's heartbeat.
bool is_in_control_loop(const CanFrame& frame) { return frame.identifier < 0x300; }

struct HitFrames {
  std::uint64_t to_robot = 0;
  std::uint64_t to_controller = 0;
};

/// Every so many frames one is hit: damaged, or lost, by the same draw.
HitFrames hit_frames(ClosedLoop& loop, bool is_damaged) {
  HitFrames hits;
  std::mt19937 chance(21);
  std::mt19937 bits(22);
  const auto hit = [&](Frames& frames, std::uint64_t& counter) {
    if (loop.tick() < kWalking) return;
    Frames kept;
    for (CanFrame& frame : frames) {
      const bool is_hit = is_in_control_loop(frame) && chance() % 1'000 == 0;
      if (is_hit) ++counter;
      if (is_hit && is_damaged) damage(frame, bits);
      if (!is_hit || is_damaged) kept.push_back(frame);
    }
    frames = kept;
  };
  loop.bus.to_robot = [&](Frames& frames) { hit(frames, hits.to_robot); };
  loop.bus.to_controller = [&](Frames& frames) { hit(frames, hits.to_controller); };
  loop.run_to(kWalking + 8 * kSecond);
  return hits;
}

TEST(DamagedFrames, CountAsWrongCrcAndActLikeLostOnesToTheBit) {
  ClosedLoop damaged(kMainJob);
  const HitFrames hits = hit_frames(damaged, true);
  ClosedLoop deprived(kMainJob);
  const HitFrames losses = hit_frames(deprived, false);
  EXPECT_GT(hits.to_robot, 10U);
  EXPECT_GT(hits.to_controller, 20U);
  EXPECT_EQ(count(damaged.robot_counters().rejected, can::Rejection::kWrongCrc), hits.to_robot);
  EXPECT_EQ(count(damaged.counters().rejected, can::Rejection::kWrongCrc), hits.to_controller);
  EXPECT_EQ(losses.to_robot, hits.to_robot);
  EXPECT_EQ(damaged.torques_nm, deprived.torques_nm);
  EXPECT_NE(damaged.torques_nm, undisturbed_torques_nm()) << "losses must have been felt, or this proves nothing";
}

}  // namespace
}  // namespace surefoot
