#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "firmware/host/firmware_node.hpp"
#include "firmware/host/memory_bus.hpp"
#include "sim_hw/simulated_robot.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::bench {

/// The frames of one tick in their order.
struct TickFrames {
  std::vector<can::CanFrame> sync;      ///< from the controller
  std::vector<can::CanFrame> answers;   ///< from the nodes
  std::vector<can::CanFrame> commands;  ///< from the controller
  std::vector<can::CanFrame> later;     ///< from the nodes, after the torques
};

/// Firmware and robot, each on a bus of its own, with somebody between them who keeps what passes: so that each can be
/// run again alone on the same frames.
class RelayedLoop {
 public:
  /// @param scenario  one that can be branched (`sim_hw::SimulatedRobot`), without payloads and pushes
  explicit RelayedLoop(const scenario::Scenario& scenario);
  RelayedLoop(const RelayedLoop&) = delete;
  RelayedLoop& operator=(const RelayedLoop&) = delete;
  ~RelayedLoop() = default;

  /// Runs until a tick without keeping anything.
  void run_to(std::int64_t tick);

  /// Goes on for so many ticks and keeps their frames.
  void keep_ticks(std::int64_t count);

  /// Microseconds that the firmware, or the robot, needs for all ticks that were kept.
  [[nodiscard]] double firmware_us() const;
  [[nodiscard]] double robot_us() const;

  [[nodiscard]] const std::vector<TickFrames>& kept() const noexcept { return kept_; }
  /// Of the last tick.
  [[nodiscard]] const TickOutput& output() const noexcept { return *output_; }
  [[nodiscard]] const SensorSnapshot& sensors() const noexcept { return firmware_.snapshot(); }
  [[nodiscard]] const sim_hw::GroundTruth& truth() const noexcept { return robot_.truth(); }

 private:
  TickFrames cycle();

  sim_hw::SimConfig sim_;
  host::MemoryBus firmware_bus_;
  host::MemoryBus robot_bus_;
  host::FirmwareNode firmware_;
  sim_hw::SimulatedRobot robot_;
  const TickOutput* output_ = nullptr;
  std::vector<TickFrames> kept_;
  std::unique_ptr<host::FirmwareNode> firmware_before_;   ///< the kept ticks
  std::unique_ptr<sim_hw::SimulatedRobot> robot_before_;  ///< the same
  std::unique_ptr<host::MemoryBus> firmware_bus_before_;  ///< the same
};

}  // namespace surefoot::bench
