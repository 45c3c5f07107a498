#include "firmware/can/end_to_end.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <string_view>
#include <vector>

namespace surefoot::can {
namespace {

std::uint16_t crc_of(std::string_view text) {
  return crc16(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

/// The definition, bit by bit.
std::uint16_t slow_crc(std::span<const std::uint8_t> bytes) {
  unsigned crc = 0xFFFF;
  for (const unsigned byte : bytes) {
    crc ^= byte << 8;
    for (int bit = 0; bit < 8; ++bit) crc = ((crc << 1) ^ ((crc & 0x8000U) != 0 ? 0x1021U : 0U)) & 0xFFFFU;
  }
  return static_cast<std::uint16_t>(crc);
}

std::vector<std::uint8_t> noise(std::size_t length) {
  std::vector<std::uint8_t> bytes;
  std::uint32_t state = 1;
  for (std::size_t i = 0; i < length; ++i) {
    state = state * 1664525U + 1013904223U;
    bytes.push_back(static_cast<std::uint8_t>(state >> 24));
  }
  return bytes;
}

CanFrame protected_frame(std::uint8_t length, std::size_t crc_offset) {
  CanFrame frame{.identifier = 0x181, .length = length};
  const std::vector<std::uint8_t> content = noise(length);
  std::ranges::copy(content, frame.payload.begin());
  protect(frame, crc_offset);
  return frame;
}

/// Bit `at` of the payload in the order of the wire: most significant bit of a byte first.
void flip(CanFrame& frame, std::size_t at) { frame.payload[at / 8] ^= static_cast<std::uint8_t>(0x80U >> (at % 8)); }

// The check value of CRC-16/CCITT-FALSE in Greg Cook's catalogue (there CRC-16/IBM-3740). A reflected
// CRC gives 0x6F91, one that starts at zero 0x31C3, one with a final XOR 0xD64E.
TEST(Crc16, GivesTheCatalogueCheckValue) { EXPECT_EQ(crc_of("123456789"), 0x29B1); }

// Python 3.11: binascii.crc_hqx(b"", 0xFFFF), and of these two texts.
TEST(Crc16, AgreesWithPythonOnOtherTexts) {
  EXPECT_EQ(crc_of(""), 0xFFFF);
  EXPECT_EQ(crc_of("A"), 0xB915);
  EXPECT_EQ(crc_of("The quick brown fox jumps over the lazy dog"), 0x8FDD);
}

TEST(Crc16, IsItsBitwiseDefinitionAtEveryLength) {
  for (std::size_t length = 0; length <= 66; ++length) {
    const std::vector<std::uint8_t> bytes = noise(length);
    EXPECT_EQ(crc16(bytes), slow_crc(bytes)) << length;
  }
}

TEST(Crc16, GoesOnFromAnyPlaceInTheMiddle) {
  const std::vector<std::uint8_t> bytes = noise(50);
  for (std::size_t split = 0; split <= bytes.size(); ++split) {
    EXPECT_EQ(crc16(std::span(bytes).subspan(split), crc16(std::span(bytes).first(split))), slow_crc(bytes)) << split;
  }
}

TEST(EndToEnd, CoversTheIdentifierLowByteFirstThenThePayloadWithoutTheCrc) {
  CanFrame frame{.identifier = 0x5A3, .length = 8};
  frame.payload = {1, 2, 3, 0xEE, 0xEE, 4, 5, 6};
  protect(frame, 3);
  const std::uint16_t expected = slow_crc(std::array<std::uint8_t, 8>{0xA3, 0x05, 1, 2, 3, 4, 5, 6});
  EXPECT_EQ(frame.payload[3], expected & 0xFF);
  EXPECT_EQ(frame.payload[4], expected >> 8);
  EXPECT_TRUE(is_intact(frame, 3));
}

TEST(EndToEnd, RefusesEveryOtherIdentifier) {
  CanFrame frame = protected_frame(16, 0);
  for (std::uint16_t identifier = 0; identifier <= 0x7FF; ++identifier) {
    if (identifier == 0x181) continue;
    frame.identifier = identifier;
    EXPECT_FALSE(is_intact(frame, 0)) << identifier;
  }
}

TEST(EndToEnd, RefusesEveryErrorOfOneTwoOrThreeBits) {
  CanFrame frame = protected_frame(20, 0);
  const std::size_t bits = 20 * 8;
  for (std::size_t a = 0; a < bits; ++a) {
    flip(frame, a);
    EXPECT_FALSE(is_intact(frame, 0));
    for (std::size_t b = a + 1; b < bits; ++b) {
      flip(frame, b);
      EXPECT_FALSE(is_intact(frame, 0));
      for (std::size_t c = b + 1; c < bits; ++c) {
        flip(frame, c);
        ASSERT_FALSE(is_intact(frame, 0)) << a << ' ' << b << ' ' << c;
        flip(frame, c);
      }
      flip(frame, b);
    }
    flip(frame, a);
  }
}

/// Bursts of up to 16 bits, first and last bit wrong, that start at one bit: how many pass the check.
/// The CRC is linear, so that each wrong bit has a fixed effect and effects add by XOR.
struct BurstCount {
  int beside_field = 0;
  int across_edge = 0;
};

BurstCount undetected_bursts(std::uint8_t length, std::size_t crc_offset) {
  const std::size_t bits = std::size_t{length} * 8;
  std::vector<unsigned> effect(bits);
  for (std::size_t bit = 0; bit < bits; ++bit) {
    CanFrame frame = protected_frame(length, crc_offset);
    CanFrame repaired = frame;
    flip(frame, bit);
    flip(repaired, bit);
    protect(repaired, crc_offset);
    effect[bit] = static_cast<unsigned>(frame.payload[crc_offset] ^ repaired.payload[crc_offset]) |
                  static_cast<unsigned>(frame.payload[crc_offset + 1] ^ repaired.payload[crc_offset + 1]) << 8;
  }
  const std::size_t field_first = crc_offset * 8;
  const std::size_t field_end = field_first + 16;
  BurstCount count;
  for (std::size_t first = 0; first < bits; ++first) {
    const std::size_t longest = std::min<std::size_t>(16, bits - first);
    for (unsigned pattern = 1; pattern < (1U << longest); pattern += 2) {
      unsigned sum = 0;
      for (unsigned rest = pattern; rest != 0; rest &= rest - 1) {
        sum ^= effect[first + static_cast<std::size_t>(std::countr_zero(rest))];
      }
      if (sum != 0) continue;
      const std::size_t end = first + static_cast<std::size_t>(std::bit_width(pattern));
      const bool across =
          (first < field_first && end > field_first) || (first < field_end && first >= field_first && end > field_end);
      ++(across ? count.across_edge : count.beside_field);
    }
  }
  return count;
}

// The counts across the edge come from an enumeration in Python with a bitwise CRC, of 458,753 such
// bursts at each edge (15 starts of 2^15 patterns, less the 2^15 - 1 that end before it).
TEST(EndToEnd, RefusesEveryBurstOfSixteenBitsButAHandfulAcrossTheEdgeOfItsField) {
  struct Layout {
    std::uint8_t length;
    std::size_t crc_offset;
    int across_edge;
  };
  for (const Layout layout :
       {Layout{8, 0, 12}, Layout{16, 0, 6}, Layout{20, 0, 2}, Layout{48, 0, 5}, Layout{8, 6, 12}}) {
    const BurstCount count = undetected_bursts(layout.length, layout.crc_offset);
    EXPECT_EQ(count.beside_field, 0) << int{layout.length};
    EXPECT_EQ(count.across_edge, layout.across_edge) << int{layout.length} << " bytes, CRC at " << layout.crc_offset;
  }
}

}  // namespace
}  // namespace surefoot::can
