#include "firmware/host/candump_format.hpp"

#include <algorithm>
#include <array>
#include <cstring>

namespace surefoot::host {
namespace {

constexpr char kHexDigits[] = "0123456789ABCDEF";

/// Two characters for each of `Count` values: one copy instead of two divisions.
template <std::size_t Count, unsigned kBase>
constexpr auto pairs_of_digits() {
  std::array<std::array<char, 2>, Count> pairs{};
  for (unsigned value = 0; value < Count; ++value)
    pairs[value] = {kHexDigits[value / kBase], kHexDigits[value % kBase]};
  return pairs;
}

constexpr auto kHexPairs = pairs_of_digits<256, 16>();
constexpr auto kDecimalPairs = pairs_of_digits<100, 10>();

/// Exactly 2 * pairs decimal digits, leading zeros included.
char* put_decimal(char* out, std::uint64_t value, int pairs) noexcept {
  for (int pair = pairs - 1; pair >= 0; --pair) {
    std::memcpy(out + 2 * pair, kDecimalPairs[value % 100].data(), 2);
    value /= 100;
  }
  return out + 2 * pairs;
}

char* put_text(char* out, const char* text, std::size_t length) noexcept {
  std::memcpy(out, text, length);
  return out + length;
}

}  // namespace

char* format_candump_line(char* line, std::int64_t elapsed_us, const can::CanFrame& frame) noexcept {
  const auto time_us = static_cast<std::uint64_t>(std::max<std::int64_t>(elapsed_us, 0));
  char* out = line;
  *out++ = '(';
  out = put_decimal(out, time_us / 1'000'000, 5);
  *out++ = '.';
  out = put_decimal(out, time_us % 1'000'000, 3);
  out = put_text(out, ") can0 ", 7);
  *out++ = kHexDigits[(frame.identifier >> 8) & 0xF];
  out = put_text(out, kHexPairs[frame.identifier & 0xFF].data(), 2);
  out = put_text(out, "##1", 3);  // flags: bit rate switch
  const std::size_t length = std::min<std::size_t>(frame.length, can::kMaxPayloadBytes);
  for (std::size_t i = 0; i < length; ++i) out = put_text(out, kHexPairs[frame.payload[i]].data(), 2);
  *out++ = '\n';
  return out;
}

}  // namespace surefoot::host
