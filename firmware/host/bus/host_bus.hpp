#pragma once

#include <cstdint>
#include <span>

#include "firmware/can/can_bus.hpp"

namespace surefoot::host {

/// Running totals of one interface (all buses of a bundle added up).
struct BusReport {
  std::uint64_t sent = 0;
  std::uint64_t received = 0;           ///< handed to the caller
  std::uint64_t refused_no_buffer = 0;  ///< frames that met ENOBUFS or EAGAIN
  std::uint64_t link_down = 0;          ///< a send or receive met an interface that is down or gone
  std::uint64_t error_frames = 0;
  std::uint64_t bus_off = 0;         ///< error frames that said so
  std::uint64_t foreign_shape = 0;   ///< classic, extended, RTR, malformed datagram: dropped
  std::uint64_t queue_overflow = 0;  ///< frames that the kernel had no room for (SO_RXQ_OVFL)
  bool is_up = true;
};

/// A bus of the operating system: what a loop needs beyond the seam. After construction nothing allocates,
/// throws or blocks, but for the one call that waits.
class HostBus : public can::CanBus {
 public:
  /// Sleeps until a frame can be received or the deadline (CLOCK_MONOTONIC) has passed: the only blocking
  /// call. To the timer's resolution, no jiffies; signals do not shorten it; a link that is down sleeps too,
  /// and is looked for again at most every 100 ms. May wake for a frame that `receive` then drops.
  ///
  /// @return true when something can be received
  virtual bool wait_readable(std::int64_t deadline_monotonic_ns) noexcept = 0;

  [[nodiscard]] virtual BusReport report() const noexcept = 0;

  /// Kernel receive time stamps (CLOCK_REALTIME, ns) of the frames that the last `receive` returned, one for
  /// one; empty where the backend has none.
  [[nodiscard]] virtual std::span<const std::int64_t> receive_times_ns() const noexcept { return {}; }
};

/// Which end of the bus this participant is; decides what it hears.
enum class BusRole : std::uint8_t {
  kController,  ///< what the five nodes send, and what only the controller may send: a second master is seen
  kRobot,       ///< what the controller sends
  kEverything,
};

}  // namespace surefoot::host
