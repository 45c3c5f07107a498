#pragma once

#include <cstdint>

#include "firmware/can/messages.hpp"

namespace surefoot::can {

/// Judges the rolling counter of one identifier. Show it only frames that are intact and of the running
/// tick: an old frame played back would otherwise move the counter and hide the true one. Tick (16 bits) and counter (8
/// bits) repeat together every 65.536 s at 1 kHz: a frame of exactly that age passes both.
class CounterWatch {
 public:
  /// @return kNone when the counter moved on (gaps are counted as lost frames), kRepeated when it did not
  [[nodiscard]] Rejection step(std::uint8_t counter) noexcept;

  /// The sender started anew: its next counter is taken as it comes.
  void restart() noexcept { was_heard_ = false; }

  /// Frames missing among those shown, by the gaps in the counter; an outage of more than 255 frames
  /// counts modulo 256.
  [[nodiscard]] std::uint32_t lost() const noexcept { return lost_; }

 private:
  std::uint32_t lost_ = 0;
  std::uint8_t last_ = 0;
  bool was_heard_ = false;
};

}  // namespace surefoot::can
