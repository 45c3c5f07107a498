#include "sim_hw/bus/frame_bits.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace surefoot::sim_hw {
namespace {

/// Payload bytes by DLC (ISO 11898-1:2015).
constexpr std::array<std::uint8_t, 16> kLengthByDlc{0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 16, 20, 24, 32, 48, 64};
constexpr std::uint8_t kLongestPayloadWithCrc17 = 16;

// Fields around the stuffed ones. One fixed stuff bit leads the CRC field and one follows each
// fourth of its bits: 6 for stuff count + CRC17 (21 bits), 7 for stuff count + CRC21 (25 bits).
constexpr std::uint32_t kSofToBrs = 1 + 11 + 1 + 1 + 1 + 1 + 1;  // SOF, identifier, RRS, IDE, FDF, res, BRS
constexpr std::uint32_t kAckToIntermission = 1 + 1 + 7 + 3;      // ACK slot and delimiter, EOF, intermission
constexpr std::uint32_t kEsiAndDlc = 1 + 4;
constexpr std::uint32_t kCrc17Field = 4 + 17 + 6 + 1;  // stuff count, CRC, fixed stuff bits, delimiter
constexpr std::uint32_t kCrc21Field = 4 + 21 + 7 + 1;

/// The stuffing rule as an automaton over the bits before stuffing: the last bit on the wire and
/// the length of its run, 1 to 5. At 5 a stuff bit is due; it is sent ahead of the next bit, so that
/// the one due at the end of the data field never is: the CRC field's fixed stuff bit takes its place.
class RunLength {
 public:
  static constexpr std::size_t kStates = 10;

  constexpr RunLength(bool last, unsigned run) noexcept : last_(last), run_(run) {}
  static constexpr RunLength from_index(std::size_t index) noexcept {
    return {index % 2 == 1, static_cast<unsigned>(index / 2 + 1)};
  }
  [[nodiscard]] constexpr std::size_t index() const noexcept { return (run_ - 1) * 2 + (last_ ? 1 : 0); }

  /// Takes the lowest `count` bits of `bits`, highest first; returns the stuff bits sent on the way.
  constexpr std::uint8_t take(unsigned bits, unsigned count) noexcept {
    std::uint8_t stuffed = 0;
    while (count-- > 0) {
      const bool bit = ((bits >> count) & 1U) != 0;
      if (run_ == 5) {
        ++stuffed;
        last_ = !last_;
        run_ = 1;
      }
      run_ = bit == last_ ? run_ + 1 : 1;
      last_ = bit;
    }
    return stuffed;
  }

 private:
  bool last_;
  unsigned run_;
};

/// The automaton's steps by whole bytes. A state is kept as its row's offset, so that a step is one load.
struct ByteSteps {
  std::array<std::uint16_t, RunLength::kStates * 256> next_row{};
  std::array<std::uint8_t, RunLength::kStates * 256> stuffed{};
};

constexpr ByteSteps make_byte_steps() {
  ByteSteps steps;
  for (std::size_t row = 0; row < RunLength::kStates; ++row) {
    for (unsigned byte = 0; byte < 256; ++byte) {
      RunLength run = RunLength::from_index(row);
      steps.stuffed[row * 256 + byte] = run.take(byte, 8);
      steps.next_row[row * 256 + byte] = static_cast<std::uint16_t>(run.index() * 256);
    }
  }
  return steps;
}

constexpr ByteSteps kByteSteps = make_byte_steps();

std::uint32_t stuff_bits_before_brs(std::uint16_t identifier) noexcept {
  RunLength run{true, 1};                                  // whatever was before, SOF starts a run
  const unsigned sof_to_ide = (identifier & 0x7FFU) << 2;  // SOF 0, identifier, RRS 0, IDE 0
  const unsigned fdf_res_brs = 0b101;
  return run.take(sof_to_ide << 3 | fdf_res_brs, kSofToBrs);
}

/// The automaton on its way through bytes.
struct ByteWalk {
  std::size_t row;
  std::uint32_t stuffed = 0;

  void take(std::uint8_t byte) noexcept {
    stuffed += kByteSteps.stuffed[row + byte];
    row = kByteSteps.next_row[row + byte];
  }
};

/// Walks both halves of the bytes at once, for each step waits for the one before: the second half from the state that
/// the byte before it nearly always leaves, and once more where it did not.
void take_bytes(ByteWalk& walk, std::span<const std::uint8_t> bytes) noexcept {
  const std::size_t half = bytes.size() / 2;
  if (half == 0) {
    for (const std::uint8_t byte : bytes) walk.take(byte);
    return;
  }
  const std::size_t guess = kByteSteps.next_row[bytes[half - 1]];
  ByteWalk ahead{guess};
  for (std::size_t i = 0; i < half; ++i) {
    walk.take(bytes[i]);
    ahead.take(bytes[half + i]);
  }
  if (bytes.size() % 2 == 1) ahead.take(bytes.back());
  if (walk.row == guess) {
    walk.row = ahead.row;
    walk.stuffed += ahead.stuffed;
  } else {
    for (const std::uint8_t byte : bytes.subspan(half)) walk.take(byte);
  }
}

std::uint32_t stuff_bits_after_brs(unsigned dlc, std::span<const std::uint8_t> payload, std::size_t padding) noexcept {
  RunLength run{true, 1};                                  // BRS 1 after res 0
  const std::uint32_t before = run.take(dlc, kEsiAndDlc);  // ESI 0, DLC
  ByteWalk walk{run.index() * 256, before};
  take_bytes(walk, payload);
  for (; padding > 0; --padding) walk.take(0);
  return walk.stuffed;
}

unsigned dlc_for(std::size_t length) noexcept {
  const auto* const found = std::lower_bound(kLengthByDlc.begin(), kLengthByDlc.end() - 1, length);
  return static_cast<unsigned>(found - kLengthByDlc.begin());
}

FrameBits bits_without_dynamic_stuffing(std::uint8_t length_on_wire) noexcept {
  const std::uint32_t crc_field = length_on_wire <= kLongestPayloadWithCrc17 ? kCrc17Field : kCrc21Field;
  return {.nominal = kSofToBrs + kAckToIntermission, .data = kEsiAndDlc + 8U * length_on_wire + crc_field};
}

}  // namespace

FrameBits frame_bits(const can::CanFrame& frame) noexcept {
  const std::size_t length = std::min<std::size_t>(frame.length, can::kMaxPayloadBytes);
  const unsigned dlc = dlc_for(length);
  FrameBits bits = bits_without_dynamic_stuffing(kLengthByDlc[dlc]);
  bits.nominal += stuff_bits_before_brs(frame.identifier);
  bits.data += stuff_bits_after_brs(dlc, {frame.payload.data(), length}, kLengthByDlc[dlc] - length);
  return bits;
}

FrameBits worst_case_frame_bits(std::uint8_t length) noexcept {
  const std::uint8_t length_on_wire = kLengthByDlc[dlc_for(length)];
  FrameBits bits = bits_without_dynamic_stuffing(length_on_wire);
  bits.nominal += 3;                 // runs of 5, 4, 4 are all that SOF to IDE can hold; FDF, res and BRS alternate
  bits.data += 2U * length_on_wire;  // from ESI on: one due after 5, then every 4 bits; the last is never sent
  return bits;
}

}  // namespace surefoot::sim_hw
