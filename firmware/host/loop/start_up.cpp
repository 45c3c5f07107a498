#include "firmware/host/loop/start_up.hpp"

#include <fmt/format.h>

#include "firmware/host/realtime/monotonic_clock.hpp"

namespace surefoot::host {
namespace {

constexpr std::int64_t kAnnouncePeriod_ns = 100'000'000;
constexpr std::int64_t kReportPeriod_ns = 1'000'000'000;

void listen_until(FirmwareNode& node, HostBus& bus, std::int64_t deadline_ns) {
  while (MonotonicClock::now_ns() < deadline_ns) {
    if (bus.wait_readable(deadline_ns)) node.listen(bus);
  }
}

void refuse_second_master(const FirmwareNode& node) {
  if (!node.has_heard_second_master()) return;
  throw StartUpError(
      "another master drives this bus: SYNC, torques or heartbeats of a controller were heard\n"
      "  remedy: stop the other firmware, or use another interface");
}

void refuse_foreign_version(const FirmwareNode& node) {
  for (const can::Node each : can::kSensorNodes) {
    const can::NodeStatus status = node.node_status(each);
    if (!status.was_announced || status.protocol_version == can::kProtocolVersion) continue;
    throw StartUpError(
        fmt::format("node {} speaks protocol version {}, this firmware {}\n"
                    "  remedy: update one of them; firmware/can/surefoot.dbc is the version of this firmware",
                    can::name(each), status.protocol_version, can::kProtocolVersion));
  }
}

/// In lockstep ticks come as fast as the answers: for a robot with a clock of its own that is far too fast.
void refuse_other_clock(const FirmwareNode& node, LoopClock clock) {
  const bool is_lockstep = clock == LoopClock::kLockstep;
  if (node.is_robot_in_lockstep() == is_lockstep) return;
  throw StartUpError(is_lockstep ? "this robot runs on a clock of its own, the firmware in lockstep\n"
                                   "  remedy: --clock wall; lockstep is for `surefoot sim` in lockstep only"
                                 : "this robot waits for each tick (lockstep), the firmware runs on the wall clock\n"
                                   "  remedy: --clock lockstep, or start `surefoot sim` with --clock wall");
}

std::string missing_nodes(const FirmwareNode& node) {
  std::string missing;
  for (const can::Node each : can::kSensorNodes) {
    if (!node.node_status(each).was_announced)
      missing += fmt::format("{}{}", missing.empty() ? "" : ", ", can::name(each));
  }
  return missing.empty() ? "a fresh heartbeat of each node" : missing;
}

}  // namespace

bool await_robot(FirmwareNode& node, HostBus& bus, const StartUpConfig& config, const std::atomic<bool>& stop,
                 const std::function<void(const std::string&)>& on_waiting) {
  const std::int64_t start_ns = MonotonicClock::now_ns();
  listen_until(node, bus, start_ns + config.listen_ns);
  refuse_second_master(node);

  std::int64_t reported_ns = MonotonicClock::now_ns();
  for (std::int64_t next_ns = reported_ns;; next_ns += kAnnouncePeriod_ns) {
    node.announce(bus, can::NodeState::kPreOperational);
    listen_until(node, bus, next_ns + kAnnouncePeriod_ns);
    refuse_second_master(node);
    refuse_foreign_version(node);
    if (node.is_everybody_ready()) {
      refuse_other_clock(node, config.clock);
      return true;
    }
    if (stop.load(std::memory_order_relaxed)) return false;
    const std::int64_t now_ns = MonotonicClock::now_ns();
    if (now_ns - start_ns > config.patience_ns) {
      throw StartUpError(
          fmt::format("no robot on this bus: still waiting for {}\n"
                      "  remedy: switch the robot on, or start `surefoot sim` on the same bus",
                      missing_nodes(node)));
    }
    if (now_ns - reported_ns >= kReportPeriod_ns) {
      reported_ns = now_ns;
      on_waiting(missing_nodes(node));
    }
  }
}

}  // namespace surefoot::host
