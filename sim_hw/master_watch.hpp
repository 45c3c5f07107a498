#pragma once

#include <cstdint>

#include "firmware/can/counter_watch.hpp"
#include "firmware/can/messages.hpp"

namespace surefoot::sim_hw {

/// Who drives this robot: one master at a time.
///
/// The first valid SYNC makes its sender the master. From then on a SYNC must carry a later tick than
/// the last, so that neither a second master that begins at tick 0 nor an old SYNC played back sets the
/// robot back. `release` ends it: the master fell silent, and the next may begin at any tick.
class MasterWatch {
 public:
  /// Longest gap in the ticks that is still taken for lost frames.
  static constexpr std::uint32_t kMaxLostTicks = 10'000;

  /// Judges a SYNC that is intact.
  /// @param max_gap_ticks  ticks by which the world's own clock lets the master be ahead of its last SYNC;
  ///                       `kMaxLostTicks` in lockstep, where nobody but the master counts
  [[nodiscard]] can::Rejection on_sync(can::FrameStamp stamp, std::uint32_t max_gap_ticks) noexcept {
    if (is_present_ && stamp.tick == tick_) return can::Rejection::kRepeated;
    if (is_present_ && stamp.tick - tick_ > max_gap_ticks) return can::Rejection::kLate;
    if (const auto rejection = sync_watch_.step(stamp.counter); rejection != can::Rejection::kNone) return rejection;
    if (!is_present_) may_command_ = false;  // what an earlier one announced is not this one's
    tick_ = stamp.tick;
    is_present_ = true;
    return can::Rejection::kNone;
  }

  /// Judges a controller heartbeat. Only one of our protocol version, operational, after its first SYNC,
  /// allows torques. While a master runs, a heartbeat of another tick than its own is somebody else's.
  [[nodiscard]] can::Rejection on_heartbeat(const can::CanFrame& frame) noexcept {
    can::FrameStamp stamp;
    can::Heartbeat heartbeat;
    const can::Rejection rejection = can::decode_heartbeat(frame, stamp, heartbeat);
    if (rejection != can::Rejection::kNone) return rejection;
    if (is_present_ && ((stamp.tick ^ tick_) & 0xFFFFU) != 0) return can::Rejection::kLate;
    if (!is_present_) return can::Rejection::kNone;  // an announcement
    const bool speaks_ours = heartbeat.protocol_version == can::kProtocolVersion;
    may_command_ = speaks_ours && heartbeat.state == can::NodeState::kOperational;
    return speaks_ours ? can::Rejection::kNone : can::Rejection::kImplausible;
  }

  /// The master is gone.
  void release() noexcept {
    is_present_ = false;
    may_command_ = false;
    sync_watch_.restart();
  }

  [[nodiscard]] bool is_present() const noexcept { return is_present_; }
  [[nodiscard]] bool may_command() const noexcept { return may_command_; }
  [[nodiscard]] std::uint32_t tick() const noexcept { return tick_; }  ///< of the last SYNC
  [[nodiscard]] std::uint32_t lost() const noexcept { return sync_watch_.lost(); }

 private:
  can::CounterWatch sync_watch_;
  std::uint32_t tick_ = 0;
  bool is_present_ = false;
  bool may_command_ = false;
};

}  // namespace surefoot::sim_hw
