#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "firmware/can/can_frame.hpp"

namespace surefoot::sim_hw {

/// Frames in the order of their arrival; a full queue takes no more. No heap.
class FrameQueue {
 public:
  static constexpr std::size_t kCapacity = 1024;

  /// False: full, and not taken.
  bool push(const can::CanFrame& frame) noexcept {
    if (count_ == kCapacity) return false;
    frame_[(first_ + count_++) % kCapacity] = frame;
    return true;
  }

  /// False: empty.
  bool pop(can::CanFrame& frame) noexcept {
    if (count_ == 0) return false;
    frame = frame_[first_];
    first_ = (first_ + 1) % kCapacity;
    --count_;
    return true;
  }

 private:
  std::array<can::CanFrame, kCapacity> frame_{};
  std::size_t first_ = 0;
  std::size_t count_ = 0;
};

}  // namespace surefoot::sim_hw
