// Inertial sensors of a leg or a foot fall silent while their node goes on to answer: a fault, and a stance.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "firmware/can/identifiers.hpp"
#include "firmware/host/firmware_node.hpp"
#include "firmware/host/memory_bus.hpp"
#include "sim_hw/simulated_robot.hpp"
#include "tools/run/schedule.hpp"
#include "tools/run/standing_pose.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot {
namespace {

/// The controller's end of a memory bus that loses the frames of one identifier.
class LosingBus final : public can::CanBus {
 public:
  std::size_t send(std::span<const can::CanFrame> frames) noexcept override {
    return bus_.controller_end().send(frames);
  }

  std::size_t receive(std::span<can::CanFrame> frames) noexcept override {
    const std::size_t heard = bus_.controller_end().receive(frames);
    const auto heard_frames = frames.first(heard);
    const auto kept = std::remove_if(heard_frames.begin(), heard_frames.end(),
                                     [this](const can::CanFrame& frame) { return frame.identifier == lost; });
    return static_cast<std::size_t>(kept - heard_frames.begin());
  }

  [[nodiscard]] can::CanBus& robot_end() noexcept { return bus_.robot_end(); }

  std::uint16_t lost = 0;  ///< 0: none

 private:
  host::MemoryBus bus_;
};

/// KHR-2 on the spot, on the flat.
class SilentInertial : public ::testing::TestWithParam<can::Node> {
 protected:
  void run_to(std::uint32_t tick) {
    for (; tick_ < tick; ++tick_) {
      firmware_.begin_tick(bus_);
      robot_.serve(bus_.robot_end());
      static_cast<void>(firmware_.collect(bus_));
      output_ = firmware_.finish_tick(bus_);
      robot_.serve(bus_.robot_end());
      if (output_.fault != safety::Fault::kNone && fault_tick_ == 0) fault_tick_ = tick_;
    }
  }

  static scenario::Scenario flat() {
    return run::scheduled(
        scenario::load(SUREFOOT_SCENARIOS "/khr2_flat.toml", std::vector<std::string>{"pattern.standing_s=2"}));
  }

  scenario::Scenario scenario_ = flat();
  LosingBus bus_;
  host::FirmwareNode firmware_{scenario_.firmware};
  sim_hw::SimulatedRobot robot_{scenario_.sim, run::standing_pose(scenario_.firmware)};
  TickOutput output_{};
  std::uint32_t tick_ = 0;
  std::uint32_t fault_tick_ = 0;  ///< 0: none
};

TEST_P(SilentInertial, IsRiddenThroughForTenTicksAndThenLatchesSensorSilentAndStands) {
  const std::uint32_t walking = static_cast<std::uint32_t>(std::lround(scenario_.sim.time_zero_s * 1e3)) + 1'500;
  const std::uint16_t inertial = can::inertial_identifier(GetParam());
  run_to(walking);
  bus_.lost = inertial;
  run_to(walking + 10);
  bus_.lost = 0;
  run_to(walking + 100);
  EXPECT_EQ(output_.fault, safety::Fault::kNone);
  bus_.lost = inertial;
  run_to(walking + 3'100);
  EXPECT_EQ(fault_tick_, walking + 110);
  EXPECT_EQ(output_.fault, safety::Fault::kSensorSilent);
  EXPECT_EQ(output_.safe_state, safety::SafeState::kStanceHold);
  EXPECT_EQ(output_.decision.phase, decision::ReflexPhase::kStopped);
  EXPECT_EQ(output_.command[0].mode, LegMode::kPosition);
  constexpr double kUpright_rad = 2.0 * std::numbers::pi / 180.0;
  EXPECT_LT(std::abs(robot_.truth().roll_rad), kUpright_rad);
  EXPECT_LT(std::abs(robot_.truth().pitch_rad), kUpright_rad);
}

INSTANTIATE_TEST_SUITE_P(Nodes, SilentInertial,
                         ::testing::Values(can::Node::kLegRight, can::Node::kLegLeft, can::Node::kFootRight,
                                           can::Node::kFootLeft));

}  // namespace
}  // namespace surefoot
