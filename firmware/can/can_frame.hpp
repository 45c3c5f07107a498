#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace surefoot::can {

inline constexpr std::size_t kMaxPayloadBytes = 64;

/// One CAN FD data frame with an 11-bit identifier, bit rate switched.
struct CanFrame {
  std::uint16_t identifier = 0;  ///< 0 to 0x7FF
  std::uint8_t length = 0;       ///< payload bytes: 0-8, 12, 16, 20, 24, 32, 48, 64
  std::array<std::uint8_t, kMaxPayloadBytes> payload{};

  [[nodiscard]] std::span<const std::uint8_t> bytes() const noexcept { return {payload.data(), length}; }
};

}  // namespace surefoot::can
