#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cstdio>
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
  long long seconds = -1;
  long long microseconds = -1;
  unsigned identifier = 0;
  int payload_at = 0;
  RC_ASSERT(std::sscanf(line.c_str(), "(%10lld.%6lld) can0 %3x##1%n", &seconds, &microseconds, &identifier,
                        &payload_at) == 3);
  RC_ASSERT(payload_at == 31);
  RC_ASSERT(seconds * 1'000'000 + microseconds == elapsed_us);
  RC_ASSERT(identifier == frame.identifier);
  RC_ASSERT(line.size() == 31U + 2U * frame.length + 1U);
  RC_ASSERT(line.back() == '\n');
  for (std::size_t i = 0; i < frame.length; ++i) {
    RC_ASSERT(std::stoi(line.substr(31 + 2 * i, 2), nullptr, 16) == frame.payload[i]);
  }
}

}  // namespace
}  // namespace surefoot::host
