#include "firmware/host/candump_format.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>

#include "tests/unit/firmware_host/frames.hpp"

namespace surefoot::host {
namespace {

using testing::frame_of;

std::string line_of(std::int64_t elapsed_us, const can::CanFrame& frame) {
  std::array<char, kMaxCandumpLine> line{};
  return {line.data(), format_candump_line(line.data(), elapsed_us, frame)};
}

// Golden lines: the format of `candump -L` (can-utils, lib.c, sprint_canframe) for CAN FD frames.
TEST(CandumpFormat, WritesTheLineThatCandumpWrites) {
  EXPECT_EQ(line_of(1'234'567, frame_of(0x181, {0xAA, 0xBB})), "(0000000001.234567) can0 181##1AABB\n");
  EXPECT_EQ(line_of(0, frame_of(0x080, {0x00, 0x01, 0x0F, 0xF0})), "(0000000000.000000) can0 080##100010FF0\n");
  EXPECT_EQ(line_of(59'999'999, frame_of(0x7FF, {})), "(0000000059.999999) can0 7FF##1\n");
  EXPECT_EQ(line_of(5, frame_of(0x001, {0x9})), "(0000000000.000005) can0 001##109\n");
}

TEST(CandumpFormat, FillsTheLongestLineExactly) {
  const std::string line = line_of(9'999'999'999'999'999, frame_of(0x205, std::vector<std::uint8_t>(64, 0xFF)));
  EXPECT_EQ(line.size(), kMaxCandumpLine);
  EXPECT_EQ(line, "(9999999999.999999) can0 205##1" + std::string(128, 'F') + "\n");
}

TEST(CandumpFormat, KeepsItsWidthForImpossibleTimesAndLengths) {
  can::CanFrame frame{};
  frame.length = 255;
  EXPECT_EQ(line_of(std::numeric_limits<std::int64_t>::min(), frame).substr(0, 20), "(0000000000.000000) ");
  EXPECT_EQ(line_of(std::numeric_limits<std::int64_t>::max(), frame).size(), kMaxCandumpLine);
}

}  // namespace
}  // namespace surefoot::host
