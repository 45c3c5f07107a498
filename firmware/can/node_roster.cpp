#include "firmware/can/node_roster.hpp"

#include <algorithm>

namespace surefoot::can {

bool NodeRoster::on_heartbeat(Node node, Heartbeat heartbeat, std::uint32_t tick) noexcept {
  NodeStatus& status = status_[slot(node)];
  const bool has_booted = heartbeat.state == NodeState::kBootUp;
  if (has_booted && status.was_announced) ++status.restarts;
  status.was_announced = true;
  status.state = heartbeat.state;
  status.protocol_version = heartbeat.protocol_version;
  status.last_heartbeat_tick = tick;
  status.missed_heartbeats = 0;
  return has_booted;
}

void NodeRoster::on_emergency(Node node, Emergency emergency) noexcept {
  NodeStatus& status = status_[slot(node)];
  status.last_emergency_code = emergency.code;
  ++status.emergencies;
}

void NodeRoster::on_own_heartbeat() noexcept {
  for (NodeStatus& status : status_) ++status.missed_heartbeats;
}

bool NodeRoster::is_everybody_ready() const noexcept {
  return std::ranges::all_of(status_, [](const NodeStatus& status) {
    return status.was_announced && !status.is_foreign() && status.missed_heartbeats <= kMaxMissedHeartbeats;
  });
}

safety::Finding NodeRoster::finding() const noexcept {
  safety::Finding found;
  for (const Node node : kSensorNodes) {
    if (!status(node).is_foreign()) continue;
    found = followed_by(found, finding_of_node(safety::Fault::kForeignVersion, is_leg_board(node)));
  }
  return found;
}

}  // namespace surefoot::can
