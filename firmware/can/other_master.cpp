#include "firmware/can/other_master.hpp"

#include <optional>

namespace surefoot::can {
namespace {

/// Stamp of an intact frame that is the controller's to send, or nothing.
std::optional<FrameStamp> stamp_of_master(const CanFrame& frame) noexcept {
  FrameStamp stamp;
  LegCommand command;
  Heartbeat heartbeat;
  const bool is_heartbeat = frame.identifier == heartbeat_identifier(Node::kController);
  const bool is_intact = decode_sync(frame, stamp) == Rejection::kNone ||
                         decode_leg_command(frame, stamp, command) == Rejection::kNone ||
                         (is_heartbeat && decode_heartbeat(frame, stamp, heartbeat) == Rejection::kNone);
  return is_intact ? std::optional(stamp) : std::nullopt;
}

}  // namespace

bool is_of_another_master(const CanFrame& frame, std::uint32_t tick) noexcept {
  const std::optional<FrameStamp> stamp = stamp_of_master(frame);
  if (!stamp) return false;
  if (frame.identifier == kSyncIdentifier) return static_cast<std::int32_t>(stamp->tick - tick) >= 0;
  return static_cast<std::uint16_t>(stamp->tick - tick) <= kMaxTicksAhead;
}

bool is_of_a_master(const CanFrame& frame) noexcept { return stamp_of_master(frame).has_value(); }

}  // namespace surefoot::can
