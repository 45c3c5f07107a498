#include "sim_hw/bus/classic_bits.hpp"

#include <algorithm>

namespace surefoot::sim_hw {
namespace {

constexpr std::uint8_t kMaxClassicBytes = 8;
constexpr std::uint32_t kStuffedHeader = 1 + 11 + 1 + 1 + 1 + 4;  // SOF, identifier, RTR, IDE, r0, DLC
constexpr std::uint32_t kCrcBits = 15;
constexpr std::uint32_t kDelimiterToIntermission = 1 + 1 + 1 + 7 + 3;  // CRC and ACK delimiters, ACK slot, EOF
constexpr std::uint32_t kCrc15Polynomial = 0x4599;
constexpr std::uint32_t kCrc15Mask = 0x7FFF;

/// Counts the bits on the wire while they are sent; stuff bits are not part of the CRC.
class Wire {
 public:
  /// The lowest `count` bits of `bits`, highest first.
  void send(std::uint32_t bits, std::uint32_t count) noexcept {
    while (count-- > 0) {
      const std::uint32_t bit = (bits >> count) & 1U;
      crc_ = ((crc_ << 1U) ^ (((crc_ >> 14U) ^ bit) != 0 ? kCrc15Polynomial : 0U)) & kCrc15Mask;
      put(bit);
    }
  }

  /// CRC of what was sent; then the wire holds all that is stuffed.
  void send_crc() noexcept {
    const std::uint32_t crc = crc_;
    send(crc, kCrcBits);
  }

  [[nodiscard]] std::uint32_t bits() const noexcept { return bits_; }

 private:
  void put(std::uint32_t bit) noexcept {
    ++bits_;
    run_ = bit == last_ ? run_ + 1 : 1;
    last_ = bit;
    if (run_ < 5) return;
    ++bits_;  // the stuff bit, first of the next run
    last_ = 1U - bit;
    run_ = 1;
  }

  std::uint32_t bits_ = 0;
  std::uint32_t crc_ = 0;
  std::uint32_t last_ = 1;  // recessive before the start of frame
  std::uint32_t run_ = 0;
};

}  // namespace

std::uint32_t classic_frame_bits(const can::CanFrame& frame, ClassicKind kind) noexcept {
  const std::uint8_t length = std::min(frame.length, kMaxClassicBytes);
  const bool is_remote = kind == ClassicKind::kRemote;
  Wire wire;
  wire.send(0, 1);
  wire.send(frame.identifier & 0x7FFU, 11);
  wire.send(is_remote ? 0b100 : 0b000, 3);
  wire.send(length, 4);
  for (std::uint8_t byte = 0; byte < length && !is_remote; ++byte) wire.send(frame.payload[byte], 8);
  wire.send_crc();
  return wire.bits() + kDelimiterToIntermission;
}

std::uint32_t worst_case_classic_frame_bits(std::uint8_t length) noexcept {
  const std::uint32_t stuffed = kStuffedHeader + 8U * std::min(length, kMaxClassicBytes) + kCrcBits;
  return stuffed + (stuffed - 1) / 4 + kDelimiterToIntermission;  // one after 5 bits, then after every 4
}

}  // namespace surefoot::sim_hw
