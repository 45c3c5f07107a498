#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "firmware/can/can_bus.hpp"

namespace surefoot::can {

/// A bus whose other end is the test: what it puts in `incoming` is received, what was sent is in `sent`.
class ScriptedBus final : public CanBus {
 public:
  std::size_t send(std::span<const CanFrame> frames) noexcept override {
    const std::size_t taken = std::min(frames.size(), room_for);
    sent.insert(sent.end(), frames.begin(), frames.begin() + static_cast<std::ptrdiff_t>(taken));
    return taken;
  }

  std::size_t receive(std::span<CanFrame> frames) noexcept override {
    const std::size_t taken = std::min(frames.size(), incoming.size());
    std::copy_n(incoming.begin(), taken, frames.begin());
    incoming.erase(incoming.begin(), incoming.begin() + static_cast<std::ptrdiff_t>(taken));
    return taken;
  }

  std::vector<CanFrame> incoming;
  std::vector<CanFrame> sent;
  std::size_t room_for = 256;  ///< frames taken by one call of send
};

}  // namespace surefoot::can
