#pragma once

#include <cstdint>

#include "firmware/can/messages.hpp"
#include "sim_hw/master_watch.hpp"

namespace surefoot::sim_hw {

/// Lockstep: time as the SYNC frames on the wire tell it, whether the nodes hear them or not. The faults' clock:
/// one that went by what the nodes hear would stand still while a link is down.
class WireClock {
 public:
  /// Whether this frame is a SYNC that begins a tick: the master's first, or a later one than the last.
  [[nodiscard]] bool on_frame(const can::CanFrame& frame) noexcept {
    can::FrameStamp stamp;
    if (can::decode_sync(frame, stamp) != can::Rejection::kNone) return false;
    if (!has_begun_) {
      origin_tick_ = stamp.tick;
    } else if (stamp.tick - tick_ - 1 >= MasterWatch::kMaxLostTicks) {
      return false;  // once more, or of the past
    }
    has_begun_ = true;
    tick_ = stamp.tick;
    return true;
  }

  /// The master is gone; the next begins anew.
  void stop() noexcept { has_begun_ = false; }

  [[nodiscard]] bool has_begun() const noexcept { return has_begun_; }
  [[nodiscard]] std::uint32_t tick() const noexcept { return tick_; }  ///< of the last SYNC

  /// Control periods from the master's first SYNC to that tick; 0 before it.
  [[nodiscard]] std::int64_t periods_until(std::uint32_t tick) const noexcept {
    return has_begun_ ? static_cast<std::int64_t>(tick) - origin_tick_ : 0;
  }

 private:
  std::uint32_t origin_tick_ = 0;
  std::uint32_t tick_ = 0;
  bool has_begun_ = false;
};

}  // namespace surefoot::sim_hw
