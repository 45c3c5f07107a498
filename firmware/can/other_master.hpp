#pragma once

#include <cstdint>

#include "firmware/can/messages.hpp"

namespace surefoot::can {

/// Commands and heartbeats carry 16 bits of their tick: so far ahead of the running one they still accuse a
/// second master; further ahead they are old ones, whose tick has come round (after 65.536 s at 1 kHz).
inline constexpr std::uint16_t kMaxTicksAhead = 1000;

/// True for a frame that only another controller can have sent: SYNC, leg command or controller heartbeat,
/// intact and plausible, of the running tick or of one to come. The controller never receives its own
/// frames, so what is older is a replay: it moves nobody and is only counted.
///
/// @param frame  received, whatever it is
/// @param tick   the one that runs
[[nodiscard]] bool is_of_another_master(const CanFrame& frame, std::uint32_t tick) noexcept;

/// The same before the loop, when no tick runs: any intact frame that only a controller sends.
[[nodiscard]] bool is_of_a_master(const CanFrame& frame) noexcept;

}  // namespace surefoot::can
