#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>

#include "firmware/can/can_frame.hpp"

namespace surefoot::run {

/// One line of a candump -L log.
struct LoggedFrame {
  std::int64_t elapsed_us = 0;
  can::CanFrame frame;
};

/// A log that cannot be read as CAN FD frames; the message names file, line and remedy.
class CandumpLogError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Parses `(1.234567) can0 181##1AABB`. Nothing for anything else.
[[nodiscard]] std::optional<LoggedFrame> parse_candump_line(const std::string& line);

/// Reads a candump -L log line by line. A last line without an end (a run that was killed) is left out.
class CandumpLogReader {
 public:
  /// @throws CandumpLogError when the file cannot be opened
  explicit CandumpLogReader(const std::filesystem::path& path);

  /// The next frame, or nothing at the end.
  /// @throws CandumpLogError at a line that is no CAN FD frame
  [[nodiscard]] std::optional<LoggedFrame> next();

 private:
  std::filesystem::path path_;
  std::ifstream file_;
  std::string line_;
  std::uint64_t line_number_ = 0;
};

}  // namespace surefoot::run
