#pragma once

#include <cstdint>

#include "firmware/can/messages.hpp"
#include "sim_hw/nodes/frame_outbox.hpp"

namespace surefoot::sim_hw {

/// Sends a node's heartbeat: every 100 ticks while it is synchronised, each node in a tick of its own; by
/// `announce` while it is not.
class HeartbeatSender {
 public:
  static constexpr std::uint32_t kPeriodTicks = 100;

  explicit HeartbeatSender(can::Node node, bool has_inertial_sensors = false) noexcept
      : node_(node), has_inertial_sensors_(has_inertial_sensors) {}

  void on_sync(std::uint32_t tick, FrameOutbox& outbox) noexcept {
    if (tick % kPeriodTicks != static_cast<std::uint32_t>(node_)) return;
    add(tick, can::NodeState::kOperational, outbox);
  }

  /// A node without a master: boot-up once after power-up, then pre-operational.
  void announce(FrameOutbox& outbox) noexcept {
    add(0, has_booted_ ? can::NodeState::kPreOperational : can::NodeState::kBootUp, outbox);
    has_booted_ = true;
  }

  /// Power came back: says so at once, and counts from 0.
  void restart(FrameOutbox& outbox) noexcept {
    has_booted_ = false;
    counter_ = 0;
    announce(outbox);
  }

 private:
  void add(std::uint32_t tick, can::NodeState state, FrameOutbox& outbox) noexcept {
    const can::Heartbeat heartbeat{.state = state, .has_inertial_sensors = has_inertial_sensors_};
    outbox.add(can::encode_heartbeat(node_, {.tick = tick, .counter = counter_++}, heartbeat));
  }

  can::Node node_;
  bool has_inertial_sensors_;
  bool has_booted_ = false;
  std::uint8_t counter_ = 0;
};

}  // namespace surefoot::sim_hw
