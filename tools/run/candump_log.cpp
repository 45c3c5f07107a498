#include "tools/run/candump_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>

namespace surefoot::run {
namespace {

constexpr std::int64_t kMaxSeconds = 9'999'999'999;  // ten digits, as candump writes them

template <typename Integer>
bool parse_whole(std::string_view text, Integer& value, int base) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  return error == std::errc{} && end == text.data() + text.size() && !text.empty();
}

bool parse_stamp(std::string_view text, std::int64_t& elapsed_us) {
  const std::size_t point = text.find('.');
  if (point == std::string_view::npos || text.size() - point != 7) return false;
  std::int64_t seconds = 0;
  std::int64_t microseconds = 0;
  if (!parse_whole(text.substr(0, point), seconds, 10) || !parse_whole(text.substr(point + 1), microseconds, 10)) {
    return false;
  }
  if (seconds < 0 || seconds > kMaxSeconds || microseconds < 0) return false;
  elapsed_us = seconds * 1'000'000 + microseconds;
  return true;
}

bool parse_payload(std::string_view text, can::CanFrame& frame) {
  if (text.size() % 2 != 0 || text.size() / 2 > can::kMaxPayloadBytes) return false;
  frame.length = static_cast<std::uint8_t>(text.size() / 2);
  for (std::size_t byte = 0; byte < frame.length; ++byte) {
    if (!parse_whole(text.substr(2 * byte, 2), frame.payload[byte], 16)) return false;
  }
  return true;
}

/// The begin of a line that is no frame, and may be anything: a terminal shall not obey it.
std::string shown(const std::string& line) {
  std::string text = line.substr(0, 80);
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '.');
  return text;
}

}  // namespace

std::optional<LoggedFrame> parse_candump_line(const std::string& line) {
  const std::string_view text{line};
  const std::size_t stamp_end = text.find(") ");
  if (text.empty() || text.front() != '(' || stamp_end == std::string_view::npos) return std::nullopt;
  const std::size_t interface_end = text.find(' ', stamp_end + 2);
  const std::size_t separator = text.find("##");
  if (interface_end == std::string_view::npos || separator == std::string_view::npos || separator < interface_end ||
      separator + 3 > text.size()) {
    return std::nullopt;
  }
  LoggedFrame logged;
  const bool is_frame =
      parse_stamp(text.substr(1, stamp_end - 1), logged.elapsed_us) &&
      parse_whole(text.substr(interface_end + 1, separator - interface_end - 1), logged.frame.identifier, 16) &&
      logged.frame.identifier <= 0x7FF && parse_payload(text.substr(separator + 3), logged.frame);
  if (!is_frame) return std::nullopt;
  return logged;
}

CandumpLogReader::CandumpLogReader(const std::filesystem::path& path) : path_(path), file_(path) {
  if (!file_) {
    throw CandumpLogError(
        fmt::format("{}: cannot be read\n  remedy: give a run folder that `surefoot run` wrote", path.string()));
  }
}

std::optional<LoggedFrame> CandumpLogReader::next() {
  if (!std::getline(file_, line_) || file_.eof()) return std::nullopt;
  ++line_number_;
  std::optional<LoggedFrame> logged = parse_candump_line(line_);
  if (!logged) {
    throw CandumpLogError(
        fmt::format("{}:{}: not a CAN FD frame of candump -L: '{}'\n  remedy: record with "
                    "`surefoot run` or `candump -L`",
                    path_.string(), line_number_, shown(line_)));
  }
  return logged;
}

}  // namespace surefoot::run
