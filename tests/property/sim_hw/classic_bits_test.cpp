// The counter against the standard's text taken literally: write all bits down, divide for the CRC, insert a
// complement after each five equal bits on the wire, count.
#include "sim_hw/bus/classic_bits.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <vector>

namespace surefoot::sim_hw {
namespace {

std::string binary(unsigned value, int digits) {
  std::string text;
  for (int i = digits - 1; i >= 0; --i) text += ((value >> i) & 1U) != 0 ? '1' : '0';
  return text;
}

/// Remainder of long division by x15+x14+x10+x8+x7+x4+x3+1, on text.
std::string crc_15(std::string bits) {
  const std::string divisor = "1100010110011001";
  bits += std::string(15, '0');
  for (std::size_t i = 0; i + 15 < bits.size(); ++i) {
    if (bits[i] == '0') continue;
    for (std::size_t k = 0; k < divisor.size(); ++k) bits[i + k] = bits[i + k] == divisor[k] ? '0' : '1';
  }
  return bits.substr(bits.size() - 15);
}

std::size_t by_the_book(const can::CanFrame& frame, bool is_remote) {
  std::string unstuffed = "0" + binary(frame.identifier, 11) + (is_remote ? "100" : "000") + binary(frame.length, 4);
  if (!is_remote) {
    for (const std::uint8_t byte : frame.bytes()) unstuffed += binary(byte, 8);
  }
  unstuffed += crc_15(unstuffed);
  std::string wire;
  for (const char bit : unstuffed) {
    wire += bit;
    if (wire.size() >= 5 && wire.substr(wire.size() - 5) == std::string(5, bit)) wire += bit == '1' ? '0' : '1';
  }
  return wire.size() + 1 + 2 + 7 + 3;
}

/// Bytes that come in runs, where stuffing happens.
can::CanFrame any_frame() {
  can::CanFrame frame;
  frame.identifier = *rc::gen::inRange<std::uint16_t>(0, 0x800);
  frame.length = *rc::gen::inRange<std::uint8_t>(0, 9);
  const auto byte = rc::gen::oneOf(rc::gen::arbitrary<std::uint8_t>(),
                                   rc::gen::elementOf(std::vector<std::uint8_t>{0x00, 0xFF, 0x0F, 0xF0, 0x83, 0x7C}));
  for (std::size_t i = 0; i < frame.length; ++i) frame.payload[i] = *byte;
  return frame;
}

}  // namespace

RC_GTEST_PROP(ClassicFrameBits, AgreeWithTheStandardTakenLiterally, ()) {
  const can::CanFrame frame = any_frame();
  RC_ASSERT(classic_frame_bits(frame) == by_the_book(frame, false));
  RC_ASSERT(classic_frame_bits(frame, ClassicKind::kRemote) == by_the_book(frame, true));
}

RC_GTEST_PROP(ClassicFrameBits, NeverPassTheWorstCase, ()) {
  const can::CanFrame frame = any_frame();
  RC_ASSERT(classic_frame_bits(frame) <= worst_case_classic_frame_bits(frame.length));
}

}  // namespace surefoot::sim_hw
