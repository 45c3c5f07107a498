#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "firmware/can/can_frame.hpp"
#include "firmware/host/sha256.hpp"

namespace surefoot::host {

/// Writes CAN frames as text that `candump -L`, cantools and python-can read. The file holds whole
/// lines at any time: lines collect in a buffer and go out in one write; after a failed write the
/// file is cut back to its last whole line and nothing more is written.
class BusLogWriter {
 public:
  /// Creates the file, or empties it.
  /// @throws std::system_error naming the path
  explicit BusLogWriter(const std::filesystem::path& path);
  ~BusLogWriter();
  BusLogWriter(const BusLogWriter&) = delete;
  BusLogWriter& operator=(const BusLogWriter&) = delete;

  /// @param elapsed_us  time since power-up, see `format_candump_line`
  void append(std::int64_t elapsed_us, const can::CanFrame& frame) noexcept;

  /// Brings everything appended so far into the file.
  void flush() noexcept;

  /// Why writing stopped; empty while all is well.
  [[nodiscard]] std::error_code error() const noexcept { return error_; }

  /// What is in the file.
  [[nodiscard]] std::uint64_t frames() const noexcept { return frames_; }
  [[nodiscard]] std::uint64_t bytes() const noexcept { return bytes_; }
  [[nodiscard]] std::string sha256() const { return digest_.hex(); }

 private:
  [[nodiscard]] std::size_t write_buffer() noexcept;

  int file_;
  std::vector<char> buffer_;
  std::size_t used_ = 0;
  std::uint64_t buffered_frames_ = 0;
  std::uint64_t frames_ = 0;
  std::uint64_t bytes_ = 0;
  Sha256 digest_;
  std::error_code error_;
};

}  // namespace surefoot::host
