// A hundred thousand frames of every shape among those of a walking robot, on their way to either side.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <span>
#include <vector>

#include "firmware/can/end_to_end.hpp"
#include "firmware/can/messages.hpp"
#include "firmware/host/firmware_node.hpp"
#include "firmware/host/memory_bus.hpp"
#include "sim_hw/simulated_robot.hpp"
#include "tools/run/standing_pose.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot {
namespace {

using can::CanFrame;

constexpr std::uint32_t kWalking = 12'000;  ///< tick of the first scored gait cycle
constexpr std::uint32_t kTicks = 10'000;
constexpr int kFramesATickAndSide = 5;

/// Frames that no participant of this robot sends, or has sent long ago.
class Strangers {
 public:
  explicit Strangers(std::uint32_t seed) : random_(seed) {}

  CanFrame next(std::uint32_t tick) {
    switch (below(5)) {
      case 0:
        return rubbish(static_cast<std::uint16_t>(below(0x800)));
      case 1:  // a known identifier, maybe of the right length
        return rubbish(replay(tick).identifier);
      case 2:
        return cut(replay(tick));
      case 3:
        return foreigner();
      default:
        return replay(tick);
    }
  }

 private:
  static constexpr std::array<std::uint8_t, 16> kLengths{0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 16, 20, 24, 32, 48, 64};

  unsigned below(unsigned bound) { return static_cast<unsigned>(random_() % bound); }

  CanFrame rubbish(std::uint16_t identifier) {
    CanFrame frame{.identifier = identifier, .length = kLengths[below(kLengths.size())], .payload = {}};
    for (std::uint8_t& byte : frame.payload) byte = static_cast<std::uint8_t>(random_());
    return frame;
  }

  CanFrame cut(CanFrame frame) {
    const std::uint8_t length = frame.length;
    while (frame.length == length) frame.length = kLengths[below(kLengths.size())];
    return frame;
  }

  /// Intact, under an identifier that is not in the contract.
  CanFrame foreigner() {
    constexpr std::array<std::uint16_t, 6> kForeign{0x000, 0x100, 0x186, 0x1FF, 0x203, 0x6FF};
    CanFrame frame = rubbish(kForeign[below(kForeign.size())]);
    frame.length = 48;
    can::protect(frame, 0);
    return frame;
  }

  /// Intact and of this robot, but of a tick gone by.
  CanFrame replay(std::uint32_t tick) {
    const can::FrameStamp stamp{.tick = tick - 1 - below(kWalking - 2),
                                .counter = static_cast<std::uint8_t>(random_())};
    const Side side = kSides[below(2)];
    const can::Node node = can::kNodes[below(5)];
    LegVector six{};
    for (double& value : six) value = 1e-2 * below(20'000) - 100.0;
    LegSensors leg;
    leg.angle_rad = leg.rate_rad_s = leg.torque_nm = six;
    FootSensors foot;
    foot.corner_force_n = {six[0], six[1], six[2], six[3]};
    switch (below(8)) {
      case 0:
        return can::encode_sync(stamp);
      case 1:
        return can::encode_leg_command(side, stamp, {.mode = LegMode::kTorque, .torque_nm = six});
      case 2:
        return can::encode_leg_state(side, stamp, leg, {.watchdog_expired = true, .is_damping = true});
      case 3:
        return can::encode_foot_force(side, stamp, foot);
      case 4:
        return can::encode_imu(stamp, {});
      case 5:
        return can::encode_heartbeat(can::Node::kController, stamp, {.state = can::NodeState::kStopped});
      case 6:
        return can::encode_heartbeat(node, stamp, {.state = can::NodeState::kOperational});
      default:
        return can::encode_emergency(node, stamp, {.code = 0x0000});
    }
  }

  std::mt19937 random_;
};

/// One end of a bus on which strangers send, in between the frames of those who belong there.
class CrowdedEnd final : public can::CanBus {
 public:
  CrowdedEnd(can::CanBus& inner, std::uint32_t seed) : inner_(inner), strangers_(seed), random_(seed + 1) {}

  void begin_tick(std::uint32_t tick, int count) {
    for (; count > 0; --count) waiting_.push_back(strangers_.next(tick));
    injected += waiting_.size();
  }

  std::size_t send(std::span<const CanFrame> frames) noexcept override { return inner_.send(frames); }

  std::size_t receive(std::span<CanFrame> frames) noexcept override {
    CanFrame frame;
    std::size_t from = 0;  // those who belong there keep their order
    while (inner_.receive({&frame, 1}) == 1) {
      from += random_() % (waiting_.size() - from + 1);
      waiting_.insert(waiting_.begin() + static_cast<std::ptrdiff_t>(from++), frame);
    }
    const std::size_t count = std::min(frames.size(), waiting_.size());
    const auto end = waiting_.begin() + static_cast<std::ptrdiff_t>(count);
    std::copy(waiting_.begin(), end, frames.begin());
    waiting_.erase(waiting_.begin(), end);
    return count;
  }

  std::size_t injected = 0;

 private:
  can::CanBus& inner_;
  Strangers strangers_;
  std::mt19937 random_;
  std::vector<CanFrame> waiting_;
};

class CrowdedLoop {
 public:
  explicit CrowdedLoop(std::uint32_t seed)
      : controller_end_(bus_.controller_end(), seed), robot_end_(bus_.robot_end(), seed + 1000) {}

  void run_to(std::uint32_t tick, int strangers) {
    for (; tick_ < tick; ++tick_) {
      robot_end_.begin_tick(tick_, strangers);
      controller_end_.begin_tick(tick_, strangers);
      firmware_.begin_tick(controller_end_);
      robot_.serve(robot_end_);
      static_cast<void>(firmware_.collect(controller_end_));
      output_ = firmware_.finish_tick(controller_end_);
      robot_.serve(robot_end_);
    }
  }

  [[nodiscard]] std::size_t injected() const { return controller_end_.injected + robot_end_.injected; }
  [[nodiscard]] const TickOutput& output() const { return output_; }
  [[nodiscard]] const sim_hw::GroundTruth& truth() const { return robot_.truth(); }

 private:
  static scenario::Scenario walk() {
    scenario::Scenario scenario = scenario::load_default(std::vector<std::string>{"payload=[]"});
    scenario.sim.time_zero_s = 1e-3 * kWalking;
    return scenario;
  }

  scenario::Scenario scenario_ = walk();
  host::MemoryBus bus_;
  CrowdedEnd controller_end_;
  CrowdedEnd robot_end_;
  host::FirmwareNode firmware_{scenario_.firmware};
  sim_hw::SimulatedRobot robot_{scenario_.sim, run::standing_pose(scenario_.firmware)};
  TickOutput output_{};
  std::uint32_t tick_ = 0;
};

class RandomFrames : public ::testing::TestWithParam<std::uint32_t> {};

// Not only does it walk on: not one bit of its walk is another.
TEST_P(RandomFrames, AHundredThousandOfThemChangeNothing) {
  CrowdedLoop crowded(GetParam());
  crowded.run_to(kWalking, 0);
  crowded.run_to(kWalking + kTicks, kFramesATickAndSide);
  EXPECT_GE(crowded.injected(), 100'000U);
  EXPECT_EQ(crowded.output().fault, safety::Fault::kNone) << safety::name(crowded.output().fault);
  EXPECT_EQ(crowded.output().decision.phase, decision::ReflexPhase::kWalking);
  EXPECT_FALSE(crowded.truth().has_fallen);

  CrowdedLoop alone(GetParam());
  alone.run_to(kWalking + kTicks, 0);
  EXPECT_EQ(crowded.truth().time_s, alone.truth().time_s);
  EXPECT_EQ(crowded.truth().body_position_world_m, alone.truth().body_position_world_m);
  EXPECT_EQ(crowded.truth().torque_nm, alone.truth().torque_nm);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomFrames, ::testing::Values(1U, 2U, 3U));

}  // namespace
}  // namespace surefoot
