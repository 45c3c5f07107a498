#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "firmware/can/can_frame.hpp"
#include "firmware/can/identifiers.hpp"

namespace surefoot::sim_hw {

/// Whether all five nodes' answers to this tick's SYNC have left for the controller.
class AnswerWatch {
 public:
  /// A new SYNC.
  void begin_tick(std::uint32_t tick) noexcept {
    tick_ = tick;
    has_left_.fill(false);
  }

  /// Tick of that SYNC.
  [[nodiscard]] std::uint32_t tick() const noexcept { return tick_; }

  /// Frames that the bus took, as their nodes sent them in this tick.
  void note(std::span<const can::CanFrame> frames) noexcept {
    for (const can::CanFrame& frame : frames) {
      const std::size_t place = frame.identifier - can::state_identifier(can::Node::kLegRight);  // below: very large
      if (place < has_left_.size()) has_left_[place] = true;
    }
  }

  [[nodiscard]] bool is_complete() const noexcept {
    return std::all_of(has_left_.begin(), has_left_.end(), [](bool left) { return left; });
  }

 private:
  std::array<bool, 5> has_left_{};  ///< by node, 1 to 5
  std::uint32_t tick_ = 0;
};

}  // namespace surefoot::sim_hw
