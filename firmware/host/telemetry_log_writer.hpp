#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <system_error>
#include <vector>

#include "firmware/host/telemetry_ring.hpp"

struct _lcm_eventlog_t;

namespace surefoot::host {

/// Writes an LCM event log, as lcm-logger does. The file holds whole events at any time, by the same
/// means as `BusLogWriter`.
class TelemetryLogWriter {
 public:
  /// Creates the file, or empties it.
  /// @throws std::system_error naming the path
  explicit TelemetryLogWriter(const std::filesystem::path& path);
  ~TelemetryLogWriter();
  TelemetryLogWriter(const TelemetryLogWriter&) = delete;
  TelemetryLogWriter& operator=(const TelemetryLogWriter&) = delete;

  /// @param elapsed_us  time since power-up; the event's timestamp
  /// @param encoded     at most kMaxEncodedBytes
  void append(std::int64_t elapsed_us, Channel channel, const std::byte* encoded, std::size_t size) noexcept;

  /// Brings everything appended so far into the file.
  void flush() noexcept;

  /// Why writing stopped; empty while all is well.
  [[nodiscard]] std::error_code error() const noexcept { return error_; }

  /// What is in the file.
  [[nodiscard]] std::uint64_t messages() const noexcept { return messages_; }
  [[nodiscard]] std::uint64_t bytes() const noexcept { return bytes_; }

 private:
  void give_up(int error_number) noexcept;

  std::vector<char> buffer_;  ///< stdio's; outlives the log
  std::unique_ptr<_lcm_eventlog_t, void (*)(_lcm_eventlog_t*)> log_;
  std::vector<std::uint64_t> event_ends_;  ///< file offsets behind each event since the last flush
  std::uint64_t messages_ = 0;
  std::uint64_t bytes_ = 0;
  std::error_code error_;
};

}  // namespace surefoot::host
