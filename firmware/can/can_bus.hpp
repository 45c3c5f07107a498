#pragma once

#include <cstddef>
#include <span>

#include "firmware/can/can_frame.hpp"

namespace surefoot::can {

/// One participant's view of a CAN bus: the seam behind which memory, SocketCAN and UDP look alike.
/// Batches, because a tick has one moment to send and one to receive. Never blocks, never throws.
class CanBus {
 public:
  virtual ~CanBus() = default;

  /// Queues frames for sending, in order. Returns how many were taken; the rest is the caller's to
  /// count and drop.
  virtual std::size_t send(std::span<const CanFrame> frames) noexcept = 0;

  /// Takes received frames, oldest first, at most `frames.size()`. Returns how many were written.
  /// A participant never receives its own frames.
  virtual std::size_t receive(std::span<CanFrame> frames) noexcept = 0;
};

}  // namespace surefoot::can
