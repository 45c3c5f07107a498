#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <regex>
#include <string>

#include "firmware/host/candump_format.hpp"

namespace surefoot::host {
namespace {

// Read back with a reader that shares nothing with the writer.
RC_GTEST_PROP(CandumpFormat, LinesReadBackAsTheFramesTheyCameFrom, ()) {
  can::CanFrame frame{};
  frame.identifier = *rc::gen::inRange<std::uint16_t>(0, 0x800);
  frame.length = *rc::gen::inRange<std::uint8_t>(0, 65);
  for (std::size_t i = 0; i < frame.length; ++i) frame.payload[i] = *rc::gen::arbitrary<std::uint8_t>();
  const auto elapsed_us = *rc::gen::inRange<std::int64_t>(0, 10'000'000'000'000'000);

  std::array<char, kMaxCandumpLine> buffer{};
  const std::string line(buffer.data(), format_candump_line(buffer.data(), elapsed_us, frame));
  static const std::regex kPattern(R"(\((\d{10})\.(\d{6})\) can0 ([0-9A-F]{3})##1((?:[0-9A-F]{2})*)\n)");
  std::smatch part;
  RC_ASSERT(std::regex_match(line, part, kPattern));
  RC_ASSERT(std::stoll(part[1]) * 1'000'000 + std::stoll(part[2]) == elapsed_us);
  RC_ASSERT(std::stoi(part[3], nullptr, 16) == frame.identifier);
  const std::string payload = part[4];
  RC_ASSERT(payload.size() == 2U * frame.length);
  for (std::size_t i = 0; i < frame.length; ++i) {
    RC_ASSERT(std::stoi(payload.substr(2 * i, 2), nullptr, 16) == frame.payload[i]);
  }
}

}  // namespace
}  // namespace surefoot::host
