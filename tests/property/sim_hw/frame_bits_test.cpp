// The byte automaton against the standard's text taken literally: write all bits down, insert a
// complement after each five equal bits on the wire, count.
#include "sim_hw/bus/frame_bits.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace surefoot::sim_hw {
namespace {

constexpr std::array<std::uint8_t, 16> kLengths{0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 16, 20, 24, 32, 48, 64};

std::string binary(unsigned value, int digits) {
  std::string text;
  for (int i = digits - 1; i >= 0; --i) text += ((value >> i) & 1U) != 0 ? '1' : '0';
  return text;
}

FrameBits by_the_book(const can::CanFrame& frame, unsigned dlc) {
  const std::string to_brs = "0" + binary(frame.identifier, 11) + "00101";
  std::string unstuffed = to_brs + "0" + binary(dlc, 4);
  for (const std::uint8_t byte : frame.bytes()) unstuffed += binary(byte, 8);

  std::string wire;
  FrameBits bits;
  for (std::size_t i = 0; i < unstuffed.size(); ++i) {
    std::uint32_t& phase = i < to_brs.size() ? bits.nominal : bits.data;
    wire += unstuffed[i];
    ++phase;
    const bool is_last = i + 1 == unstuffed.size();
    if (!is_last && wire.size() >= 5 && wire.substr(wire.size() - 5) == std::string(5, wire.back())) {
      wire += wire.back() == '1' ? '0' : '1';
      ++phase;
    }
  }
  bits.nominal += 2 + 7 + 3;
  bits.data += frame.length <= 16 ? 4 + 17 + 6 + 1 : 4 + 21 + 7 + 1;
  return bits;
}

/// Frames whose bytes come in runs, where stuffing happens; uniform bytes rarely stuff.
rc::Gen<can::CanFrame> any_frame() {
  return rc::gen::exec([] {
    can::CanFrame frame;
    frame.identifier = *rc::gen::inRange<std::uint16_t>(0, 0x800);
    frame.length = kLengths[*rc::gen::inRange<std::size_t>(0, kLengths.size())];
    const auto byte = rc::gen::oneOf(rc::gen::arbitrary<std::uint8_t>(),
                                     rc::gen::elementOf(std::vector<std::uint8_t>{0x00, 0xFF, 0x0F, 0xF0, 0x83, 0x7C}));
    for (std::size_t i = 0; i < frame.length; ++i) frame.payload[i] = *byte;
    return frame;
  });
}

unsigned dlc_of(const can::CanFrame& frame) {
  unsigned dlc = 0;
  while (kLengths[dlc] != frame.length) ++dlc;
  return dlc;
}

}  // namespace

RC_GTEST_PROP(FrameBits, AgreeWithTheStandardTakenLiterally, ()) {
  const can::CanFrame frame = *any_frame();
  const FrameBits expected = by_the_book(frame, dlc_of(frame));
  const FrameBits bits = frame_bits(frame);
  RC_ASSERT(bits.nominal == expected.nominal);
  RC_ASSERT(bits.data == expected.data);
}

RC_GTEST_PROP(FrameBits, NeverPassTheWorstCase, ()) {
  const can::CanFrame frame = *any_frame();
  const FrameBits bits = frame_bits(frame);
  const FrameBits worst = worst_case_frame_bits(frame.length);
  RC_ASSERT(bits.nominal <= worst.nominal);
  RC_ASSERT(bits.data <= worst.data);
}

RC_GTEST_PROP(FrameBits, DoNotDependOnBytesBeyondTheLength, (std::uint8_t garbage)) {
  const can::CanFrame frame = *any_frame();
  can::CanFrame other = frame;
  for (std::size_t i = frame.length; i < other.payload.size(); ++i) other.payload[i] = garbage;
  RC_ASSERT(frame_bits(other).data == frame_bits(frame).data);
}

}  // namespace surefoot::sim_hw
