#pragma once

#include <cstdint>

#include "firmware/can/messages.hpp"
#include "sim_hw/nodes/frame_outbox.hpp"

namespace surefoot::sim_hw {

/// Sends a node's heartbeat every 100 ticks, each node in a tick of its own.
class HeartbeatSender {
 public:
  static constexpr std::uint32_t kPeriodTicks = 100;

  explicit HeartbeatSender(can::Node node) noexcept : node_(node) {}

  void on_sync(std::uint32_t tick, FrameOutbox& outbox) noexcept {
    if (tick % kPeriodTicks != static_cast<std::uint32_t>(node_)) return;
    const can::FrameStamp stamp{.tick = tick, .counter = counter_++};
    outbox.add(can::encode_heartbeat(node_, stamp, {.state = can::NodeState::kOperational}));
  }

 private:
  can::Node node_;
  std::uint8_t counter_ = 0;
};

}  // namespace surefoot::sim_hw
