#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/can/can_bus.hpp"

namespace surefoot::sim_hw {

/// Frames that the nodes want to send, in order, until they are handed to the bus together.
class FrameOutbox {
 public:
  /// All nodes' state and inertial frames, heartbeats and emergencies of one tick.
  static constexpr std::size_t kCapacity = 20;

  void add(const can::CanFrame& frame) noexcept {
    if (count_ < kCapacity) {
      frame_[count_++] = frame;
    } else {
      ++dropped_;
    }
  }

  /// @return what the bus took, valid until the next `add`
  std::span<const can::CanFrame> flush(can::CanBus& bus) noexcept {
    if (count_ == 0) return {};
    const std::size_t taken = bus.send({frame_.data(), count_});
    sent_ += taken;
    dropped_ += count_ - taken;
    count_ = 0;
    return {frame_.data(), taken};
  }

  [[nodiscard]] std::uint64_t sent() const noexcept { return sent_; }
  [[nodiscard]] std::uint64_t dropped() const noexcept { return dropped_; }  ///< refused by the bus

 private:
  std::array<can::CanFrame, kCapacity> frame_{};
  std::size_t count_ = 0;
  std::uint64_t sent_ = 0;
  std::uint64_t dropped_ = 0;
};

}  // namespace surefoot::sim_hw
