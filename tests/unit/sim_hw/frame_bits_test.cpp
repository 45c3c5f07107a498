// Every count below is done by hand from the frame of ISO 11898-1:2015, base format with bit rate switch:
//   nominal: SOF 1, identifier 11, RRS 1, IDE 1, FDF 1, res 1, BRS 1 | ACK 2, EOF 7, intermission 3     = 29
//   data:    ESI 1, DLC 4, payload 8n | stuff count 4, CRC 17, fixed stuff bits 6, delimiter 1          = 33 + 8n
//            the same with CRC 21 and 7 fixed stuff bits above 16 bytes                                 = 38 + 8n
// SOF, RRS, IDE, res and ESI are 0 (dominant), FDF and BRS are 1. Stuff bits are in brackets.
#include "sim_hw/bus/frame_bits.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>

namespace surefoot::sim_hw {
namespace {

can::CanFrame frame_of(std::uint16_t identifier, std::uint8_t length, std::uint8_t byte) {
  can::CanFrame frame{.identifier = identifier, .length = length};
  frame.payload.fill(byte);
  return frame;
}

// SOF 0, identifier 0001000 0000, RRS 0, IDE 0, FDF 1, res 0, BRS 1:
//   0000 1 00000[1]0000 1 0 1                          one stuff bit, 29 + 1 = 30 nominal bits
// ESI 0, DLC 0000: 00000 and then the CRC field, whose fixed stuff bit stands for the one due: 33 data bits
TEST(FrameBits, AnEmptyFrameEndsInFiveZerosAndNeedsNoStuffBitBeforeTheCrcField) {
  const FrameBits bits = frame_bits(frame_of(0x080, 0, 0));
  EXPECT_EQ(bits.nominal, 30U);
  EXPECT_EQ(bits.data, 33U);
  EXPECT_EQ(duration_ns(bits), 30U * 1000U + 33U * 200U);  // 36.6 us
}

// 0 10101010101 0 0 1 0 1 and 0 1000 01010101 ...: the longest run is the 0000 of DLC and payload.
TEST(FrameBits, AnAlternatingFrameHasNoStuffBits) {
  const FrameBits bits = frame_bits(frame_of(0x555, 8, 0x55));
  EXPECT_EQ(bits.nominal, 29U);
  EXPECT_EQ(bits.data, 33U + 64U);
}

// SOF to IDE are 14 zeros: 00000[1]00000[1]0000 1 0 1, two stuff bits.
// ESI 0, DLC 1, then 3 + 64 zeros: one stuff bit after 5, 10, ... 65 of them, 13 in all.
TEST(FrameBits, AnAllZeroPayloadIsStuffedAfterEachFifthZero) {
  const FrameBits bits = frame_bits(frame_of(0x000, 8, 0x00));
  EXPECT_EQ(bits.nominal, 29U + 2U);
  EXPECT_EQ(bits.data, 33U + 64U + 13U);
}

// DLC 0101, then 40 zeros: eight stuff bits are due, the eighth after the very last payload bit.
TEST(FrameBits, TheStuffBitDueAfterTheLastPayloadBitIsNotSent) {
  EXPECT_EQ(frame_bits(frame_of(0x555, 5, 0x00)).data, 33U + 40U + 7U);
}

// Identifier 0x078: SOF 0, 0000 1111 000, RRS 0, IDE 0: 00000[1]1111[0]0000[1]0 1 0 1.
// Identifier 0x7FF: 0 11111[0]11111[0]1 0 0 1 0 1.
// Payload 0F 0F after ESI and DLC 0 0010: 0 001 00000[1]1111[0]0000[1]1111, the fourth is not sent.
TEST(FrameBits, AStuffBitCountsInTheRunThatFollowsIt) {
  EXPECT_EQ(frame_bits(frame_of(0x078, 0, 0)).nominal, 29U + 3U);
  EXPECT_EQ(frame_bits(frame_of(0x7FF, 0, 0)).nominal, 29U + 2U);
  EXPECT_EQ(frame_bits(frame_of(0x555, 2, 0x0F)).data, 33U + 16U + 3U);
}

// DLC 0001 after ESI: 0 000 1, then F0: 0000 11111[0]0000; the run of ones begins in the DLC.
TEST(FrameBits, ARunThatBeginsInTheDlcGoesOnIntoThePayload) {
  EXPECT_EQ(frame_bits(frame_of(0x555, 1, 0xF0)).data, 33U + 8U + 1U);
}

// DLC 1111 for 64 bytes, then 512 zeros: 102 stuff bits. DLC 1111 then 512 ones: the run starts with
// the four ones of the DLC, 516 ones: 103 stuff bits.
TEST(FrameBits, TheLongestFramesCarryTheLongCrc) {
  EXPECT_EQ(frame_bits(frame_of(0x555, 64, 0x00)).data, 38U + 512U + 102U);
  EXPECT_EQ(frame_bits(frame_of(0x555, 64, 0xFF)).data, 38U + 512U + 103U);
}

// 16 bytes: DLC 1010, CRC 17. 20 bytes: DLC 1011, CRC 21. Neither has a run of five.
TEST(FrameBits, TheCrcGrowsAboveSixteenBytes) {
  EXPECT_EQ(frame_bits(frame_of(0x555, 16, 0x55)).data, 33U + 128U);
  EXPECT_EQ(frame_bits(frame_of(0x555, 20, 0x55)).data, 38U + 160U);
}

TEST(FrameBits, ALengthThatNoDlcStandsForIsPaddedWithZeros) {
  can::CanFrame padded = frame_of(0x123, 12, 0x00);
  can::CanFrame odd = frame_of(0x123, 9, 0xFF);
  for (std::size_t i = 0; i < 9; ++i) padded.payload[i] = 0xFF;
  EXPECT_EQ(frame_bits(odd).data, frame_bits(padded).data);
}

TEST(FrameBits, AnImpossibleFrameIsCountedAsTheLargestPossibleOne) {
  EXPECT_EQ(frame_bits(frame_of(0xFFFF, 255, 0x00)).data, frame_bits(frame_of(0x7FF, 64, 0x00)).data);
  EXPECT_EQ(frame_bits(frame_of(0xFFFF, 255, 0x00)).nominal, frame_bits(frame_of(0x7FF, 64, 0x00)).nominal);
}

// The bound of 3 is reached (0x078 above), never passed, by any identifier.
TEST(FrameBits, NoIdentifierNeedsMoreThanThreeStuffBits) {
  for (std::uint16_t identifier = 0; identifier <= 0x7FF; ++identifier) {
    ASSERT_LE(frame_bits(frame_of(identifier, 0, 0)).nominal, worst_case_frame_bits(0).nominal) << identifier;
  }
}

// 29 + 3 nominal bits; 38 + 8 * 48 + 2 * 48 data bits: 32 us + 103.6 us.
TEST(FrameBits, TheWorstCaseOfAStateFrameTakes135Point6Microseconds) {
  EXPECT_EQ(duration_ns(worst_case_frame_bits(48)), 135'600U);
}

TEST(FrameBits, DurationFollowsTheBitTimes) {
  EXPECT_EQ(duration_ns({.nominal = 30, .data = 100}, {.nominal_bit_ns = 2000, .data_bit_ns = 500}), 110'000U);
}

}  // namespace
}  // namespace surefoot::sim_hw
