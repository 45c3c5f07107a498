#pragma once

#include <array>
#include <cstdint>

#include "firmware/can/messages.hpp"
#include "firmware/core/safety/safe_state.hpp"

namespace surefoot::can {

/// What a sensor node has said of itself.
struct NodeStatus {
  bool was_announced = false;             ///< an intact heartbeat came, of whatever version
  NodeState state = NodeState::kBootUp;   ///< as announced last
  std::uint8_t protocol_version = 0;      ///< as announced last
  std::uint32_t last_heartbeat_tick = 0;  ///< tick that ran here when the last one came; 0 before the loop
  std::uint32_t missed_heartbeats = 0;    ///< the controller's own since the node's last
  std::uint32_t restarts = 0;             ///< boot-ups announced after the node had been heard
  std::uint16_t last_emergency_code = 0;  ///< 0: none, or the last one was reset
  std::uint64_t emergencies = 0;          ///< that came, resets included

  [[nodiscard]] bool is_foreign() const noexcept { return was_announced && protocol_version != kProtocolVersion; }
};

/// The five sensor nodes by what they announce. Keeps no time: it counts in the controller's heartbeats.
class NodeRoster {
 public:
  /// A node whose last heartbeat is older than so many of the controller's is stale: it is gone, or hung.
  static constexpr std::uint32_t kMaxMissedHeartbeats = 3;

  /// An intact heartbeat of a sensor node.
  /// @return true for a boot-up: the node has started, and its counters begin again
  [[nodiscard]] bool on_heartbeat(Node, Heartbeat, std::uint32_t tick) noexcept;

  void on_emergency(Node, Emergency) noexcept;

  /// The controller sent its own heartbeat.
  void on_own_heartbeat() noexcept;

  /// All five have announced our protocol version, none more than `kMaxMissedHeartbeats` ago.
  [[nodiscard]] bool is_everybody_ready() const noexcept;

  /// Fault 9 while a node speaks another version; the worst, should there be several.
  [[nodiscard]] safety::Finding finding() const noexcept;

  [[nodiscard]] const NodeStatus& status(Node node) const noexcept { return status_[slot(node)]; }

 private:
  std::array<NodeStatus, kSensorNodes.size()> status_{};
};

}  // namespace surefoot::can
