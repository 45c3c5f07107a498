#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "firmware/can/can_frame.hpp"

namespace surefoot::host::testing {

inline can::CanFrame frame_of(std::uint16_t identifier, const std::vector<std::uint8_t>& payload) {
  can::CanFrame frame{.identifier = identifier, .length = static_cast<std::uint8_t>(payload.size()), .payload = {}};
  std::copy(payload.begin(), payload.end(), frame.payload.begin());
  return frame;
}

/// A frame that tells which one it is. Does not allocate.
inline can::CanFrame numbered_frame(std::uint32_t number) {
  can::CanFrame frame{.identifier = 0x181, .length = 4, .payload = {}};
  for (unsigned i = 0; i < 4; ++i) frame.payload[i] = static_cast<std::uint8_t>(number >> (24 - 8 * i));
  return frame;
}

inline std::uint32_t number_of(const can::CanFrame& frame) {
  return (std::uint32_t{frame.payload[0]} << 24) | (std::uint32_t{frame.payload[1]} << 16) |
         (std::uint32_t{frame.payload[2]} << 8) | std::uint32_t{frame.payload[3]};
}

}  // namespace surefoot::host::testing
