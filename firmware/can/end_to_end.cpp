#include "firmware/can/end_to_end.hpp"

#include <array>

namespace surefoot::can {
namespace {

constexpr std::size_t kStride = 8;  ///< bytes taken at once
constexpr std::uint16_t kPolynomial = 0x1021;

/// Row r, entry v: the remainder of byte v followed by r zero bytes.
constexpr auto kTables = [] {
  std::array<std::array<std::uint16_t, 256>, kStride> tables{};
  for (unsigned value = 0; value < 256; ++value) {
    unsigned remainder = value << 8;
    for (int bit = 0; bit < 8; ++bit) {
      remainder = (remainder << 1) ^ ((remainder & 0x8000U) != 0 ? kPolynomial : 0U);
      remainder &= 0xFFFFU;
    }
    tables[0][value] = static_cast<std::uint16_t>(remainder);
  }
  for (std::size_t row = 1; row < kStride; ++row) {
    for (std::size_t value = 0; value < 256; ++value) {
      const unsigned before = tables[row - 1][value];
      tables[row][value] = static_cast<std::uint16_t>(((before << 8) & 0xFFFFU) ^ tables[0][before >> 8]);
    }
  }
  return tables;
}();

std::uint16_t frame_crc(const CanFrame& frame, std::size_t crc_offset) noexcept {
  const std::array<std::uint8_t, 2> identifier{static_cast<std::uint8_t>(frame.identifier & 0xFFU),
                                               static_cast<std::uint8_t>(frame.identifier >> 8)};
  const std::span<const std::uint8_t> payload = frame.bytes();
  const std::uint16_t before = crc16(payload.first(crc_offset), crc16(identifier));
  return crc16(payload.subspan(crc_offset + 2), before);
}

}  // namespace

std::uint16_t crc16(std::span<const std::uint8_t> bytes, std::uint16_t start) noexcept {
  unsigned crc = start;
  const std::uint8_t* next = bytes.data();
  std::size_t left = bytes.size();
  for (; left >= kStride; left -= kStride, next += kStride) {
    crc = static_cast<unsigned>(kTables[7][(crc >> 8) ^ next[0]] ^ kTables[6][(crc & 0xFFU) ^ next[1]] ^
                                kTables[5][next[2]] ^ kTables[4][next[3]] ^ kTables[3][next[4]] ^ kTables[2][next[5]] ^
                                kTables[1][next[6]] ^ kTables[0][next[7]]);
  }
  for (; left > 0; --left, ++next) {
    crc = ((crc << 8) & 0xFFFFU) ^ kTables[0][(crc >> 8) ^ *next];
  }
  return static_cast<std::uint16_t>(crc);
}

void protect(CanFrame& frame, std::size_t crc_offset) noexcept {
  const std::uint16_t crc = frame_crc(frame, crc_offset);
  frame.payload[crc_offset] = static_cast<std::uint8_t>(crc & 0xFFU);
  frame.payload[crc_offset + 1] = static_cast<std::uint8_t>(crc >> 8);
}

bool is_intact(const CanFrame& frame, std::size_t crc_offset) noexcept {
  const unsigned stored =
      static_cast<unsigned>(frame.payload[crc_offset]) | (static_cast<unsigned>(frame.payload[crc_offset + 1]) << 8);
  return stored == frame_crc(frame, crc_offset);
}

}  // namespace surefoot::can
