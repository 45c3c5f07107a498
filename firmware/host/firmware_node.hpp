#pragma once

#include <cstdint>

#include "firmware/can/can_bus.hpp"
#include "firmware/can/frame_exchange.hpp"
#include "firmware/core/controller.hpp"

namespace surefoot::host {

/// The firmware on a bus: one tick is `begin_tick`, time for the nodes to answer, `finish_tick`.
/// Lockstep, wall clock and replay all call these two, so there is no second path for the simulator.
class FirmwareNode {
 public:
  explicit FirmwareNode(const ControllerConfig& config) noexcept : controller_(config) {}

  /// Sends SYNC of the next tick.
  void begin_tick(can::CanBus& bus) noexcept { exchange_.begin_tick(bus, next_tick_); }

  /// Takes what has arrived; true once all nodes have answered.
  [[nodiscard]] bool collect(can::CanBus& bus) noexcept { return exchange_.collect(bus); }

  /// Runs the controller on what is there and sends the torques. Ends the tick.
  const TickOutput& finish_tick(can::CanBus& bus) noexcept {
    snapshot_ = &exchange_.finish_collecting();
    output_ = controller_.tick(*snapshot_);
    exchange_.send_commands(bus, output_.command);
    ++next_tick_;
    return output_;
  }

  /// Inputs of the last finished tick; only after the first `finish_tick`.
  [[nodiscard]] const SensorSnapshot& snapshot() const noexcept { return *snapshot_; }
  [[nodiscard]] const can::FrameCounters& counters() const noexcept { return exchange_.counters(); }

 private:
  can::FrameExchange exchange_{};
  Controller controller_;
  const SensorSnapshot* snapshot_ = nullptr;
  TickOutput output_{};
  std::uint32_t next_tick_ = 0;
};

}  // namespace surefoot::host
