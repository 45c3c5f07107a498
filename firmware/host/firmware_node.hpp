#pragma once

#include <algorithm>
#include <array>
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

  /// Before tick 0: tells the nodes that a controller is there.
  void announce(can::CanBus& bus, can::NodeState state) noexcept { exchange_.announce(bus, state); }

  /// Before tick 0: takes what has arrived.
  void listen(can::CanBus& bus) noexcept { exchange_.listen(bus); }

  /// Before tick 0: all five nodes speak our protocol version, and did so lately.
  [[nodiscard]] bool is_everybody_ready() const noexcept { return exchange_.is_everybody_ready(); }

  /// Before tick 0: somebody else sends the controller's frames.
  [[nodiscard]] bool has_heard_second_master() const noexcept {
    return exchange_.finding().fault == safety::Fault::kSecondMaster;
  }

  /// Sends SYNC of the next tick.
  void begin_tick(can::CanBus& bus) noexcept { exchange_.begin_tick(bus, next_tick_); }

  /// Takes what has arrived; true once all nodes have answered.
  [[nodiscard]] bool collect(can::CanBus& bus) noexcept { return exchange_.collect(bus); }

  /// Runs the controller on what is there and sends the torques. Ends the tick.
  const TickOutput& finish_tick(can::CanBus& bus) noexcept {
    snapshot_ = exchange_.finish_collecting();
    const bool had_fault = output_.fault != safety::Fault::kNone;
    run_controller();
    exchange_.send_commands(bus, output_.command);
    if (!had_fault && output_.fault != safety::Fault::kNone) {
      exchange_.report(bus, output_.fault);
      for (const can::Node node : can::kSensorNodes) restarts_at_fault_[can::slot(node)] = node_status(node).restarts;
    }
    return output_;
  }

  /// A tick whose instant has passed while an earlier one was at work: nothing is sent, the controller's time
  /// goes on. No sensor is fresh, and none grows old either, for the nodes were not asked.
  void miss_tick() noexcept {
    snapshot_.tick = next_tick_;
    const auto make_stale = [](Freshness& freshness) {
      if (freshness.is_fresh()) freshness.age_ticks = 1;
    };
    for (const Side side : kSides) {
      make_stale(snapshot_.leg[index(side)].freshness);
      make_stale(snapshot_.foot[index(side)].freshness);
    }
    make_stale(snapshot_.torso.freshness);
    run_controller();
  }

  /// Ticks that were missed and shall not be made up for: after them the controller is in no state to walk on.
  /// To be used with `request_stop` alone.
  void skip_ticks(std::uint32_t ticks) noexcept { next_tick_ += ticks; }

  /// Makes the next tick latch a fault that the host has found, such as `kLoopOverrun`; the worst state counts.
  void request_stop(safety::Finding finding) noexcept { requested_ = followed_by(requested_, finding); }

  /// Inputs of the last tick.
  [[nodiscard]] const SensorSnapshot& snapshot() const noexcept { return snapshot_; }
  [[nodiscard]] const can::FrameCounters& counters() const noexcept { return exchange_.counters(); }

  /// @param node  one of `can::kSensorNodes`
  [[nodiscard]] const can::NodeStatus& node_status(can::Node node) const noexcept {
    return exchange_.node_status(node);
  }

  /// The tick that comes next.
  [[nodiscard]] std::uint32_t next_tick() const noexcept { return next_tick_; }

  /// Before tick 0: the robot is a simulated one that waits for us, tick by tick.
  [[nodiscard]] bool is_robot_in_lockstep() const noexcept { return exchange_.is_robot_in_lockstep(); }

  /// Every node has announced since the fault latched that it started anew: another robot, or the whole one again.
  [[nodiscard]] bool has_robot_restarted() const noexcept {
    return output_.fault != safety::Fault::kNone && std::ranges::all_of(can::kSensorNodes, [this](can::Node node) {
             return node_status(node).restarts > restarts_at_fault_[can::slot(node)];
           });
  }

 private:
  void run_controller() noexcept {
    output_ = controller_.tick(snapshot_, followed_by(exchange_.finding(), requested_));
    ++next_tick_;
  }

  can::FrameExchange exchange_{};
  Controller controller_;
  SensorSnapshot snapshot_{};
  safety::Finding requested_{};
  TickOutput output_{};
  std::array<std::uint32_t, can::kSensorNodes.size()> restarts_at_fault_{};
  std::uint32_t next_tick_ = 0;
};

}  // namespace surefoot::host
