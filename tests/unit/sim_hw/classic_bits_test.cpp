// Every count below is done by hand from the classical base frame of ISO 11898-1:2015:
//   SOF 1, identifier 11, RTR 1, IDE 1, r0 1, DLC 4, payload 8n, CRC 15                       = 34 + 8n, stuffed
//   CRC delimiter 1, ACK slot 1, ACK delimiter 1, end of frame 7, intermission 3              = 13
// Stuff bits are in brackets. CRC-15: x15+x14+x10+x8+x7+x4+x3+1, by long division.
#include "sim_hw/bus/classic_bits.hpp"

#include <gtest/gtest.h>

#include <initializer_list>

namespace surefoot::sim_hw {
namespace {

can::CanFrame frame_of(std::uint16_t identifier, std::initializer_list<std::uint8_t> payload) {
  can::CanFrame frame{.identifier = identifier, .length = static_cast<std::uint8_t>(payload.size())};
  std::size_t place = 0;
  for (const std::uint8_t byte : payload) frame.payload[place++] = byte;
  return frame;
}

// All 19 bits up to the DLC are 0, and so is their CRC: 34 zeros, a stuff bit after each fifth: 6.
TEST(ClassicFrameBits, AnAllZeroFrameIsStuffedAfterEachFifthBit) {
  EXPECT_EQ(classic_frame_bits(frame_of(0, {})), 34U + 6U + 13U);
}

// 00000[1]0010100000[1]000100000[1]001 and the CRC 111011101010011
TEST(ClassicFrameBits, AShortFrameCountsItsThreeStuffBits) {
  EXPECT_EQ(classic_frame_bits(frame_of(0x014, {0x01})), 34U + 8U + 3U + 13U);
}

// 011111[0]11111[0]100000[1]00 and the CRC 010011100101111: the run of zeros spans RTR, IDE, r0 and the DLC.
TEST(ClassicFrameBits, ARunCountsAcrossTheFields) {
  EXPECT_EQ(classic_frame_bits(frame_of(0x7FF, {})), 34U + 3U + 13U);
}

// 01010101010100000[1]01010101, then the CRC 111100010010111 after the payload's last 1: 1 1111[0]0001...
TEST(ClassicFrameBits, TheCrcIsStuffedToo) {
  EXPECT_EQ(classic_frame_bits(frame_of(0x555, {0x55})), 34U + 8U + 2U + 13U);
}

// 00000[1]000100100000[1]00, then the CRC 111110000100000: 11111[0]0000[1]00000 and, as its last five bits are
// equal, one more stuff bit ahead of the delimiter.
TEST(ClassicFrameBits, TheStuffBitAfterTheLastBitOfTheCrcIsSent) {
  EXPECT_EQ(classic_frame_bits(frame_of(0x009, {})), 34U + 5U + 13U);
}

// RTR 1, DLC 8, no payload: 000100100011 1 00 1000 and the CRC of those; as long as a frame without payload.
TEST(ClassicFrameBits, ARemoteFrameNamesALengthAndCarriesNothing) {
  can::CanFrame frame = frame_of(0x123, {});
  frame.length = 8;
  EXPECT_LE(classic_frame_bits(frame, ClassicKind::kRemote), worst_case_classic_frame_bits(0));
  EXPECT_GE(classic_frame_bits(frame, ClassicKind::kRemote), 47U);
  EXPECT_GT(classic_frame_bits(frame), 47U + 64U);
}

TEST(ClassicFrameBits, NoMoreThanEightBytesAndElevenIdentifierBitsCount) {
  can::CanFrame longest = frame_of(0x7FF, {});
  longest.length = 8;
  can::CanFrame impossible = longest;
  impossible.identifier = 0xFFFF;
  impossible.length = 64;
  EXPECT_EQ(classic_frame_bits(impossible), classic_frame_bits(longest));
}

// Davis, Burns, Bril, Lukkien 2007: 55 + 10 n bits for 11-bit identifiers.
TEST(ClassicFrameBits, TheWorstCaseIsTheOneOfTheLiterature) {
  for (std::uint8_t length = 0; length <= 8; ++length) {
    EXPECT_EQ(worst_case_classic_frame_bits(length), 55U + 10U * length);
  }
}

}  // namespace
}  // namespace surefoot::sim_hw
