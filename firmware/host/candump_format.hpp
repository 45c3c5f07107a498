#pragma once

#include <cstddef>
#include <cstdint>

#include "firmware/can/can_frame.hpp"

namespace surefoot::host {

/// "(ssssssssss.uuuuuu) can0 iii##f", payload in hexadecimal, line feed.
inline constexpr std::size_t kMaxCandumpLine = 19 + 6 + 6 + 2 * can::kMaxPayloadBytes + 1;

/// Writes one line as `candump -L` writes a CAN FD frame with bit rate switch, without a closing
/// zero: "(0000000001.234567) can0 181##1AABB\n". About 30 ns for 20 payload bytes.
///
/// @param line        room for kMaxCandumpLine characters
/// @param elapsed_us  time since power-up, 0 to 10^16 - 1; a negative time is written as 0
/// @return one past the last character written
char* format_candump_line(char* line, std::int64_t elapsed_us, const can::CanFrame& frame) noexcept;

}  // namespace surefoot::host
