#include "firmware/host/telemetry_log_writer.hpp"

#include <lcm/eventlog.h>
#include <stdio_ext.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

namespace surefoot::host {
namespace {

constexpr std::size_t kBufferBytes = 256 * 1024;
constexpr std::size_t kEventHeaderBytes = 28;  // sync word, event number, timestamp, two lengths
constexpr std::size_t kMaxEventBytes = kEventHeaderBytes + 32 + kMaxEncodedBytes;
constexpr std::size_t kMinEventBytes = kEventHeaderBytes + 8;

}  // namespace

TelemetryLogWriter::TelemetryLogWriter(const std::filesystem::path& path)
    : buffer_(kBufferBytes), log_(lcm_eventlog_create(path.c_str(), "w"), &lcm_eventlog_destroy) {
  if (!log_) throw std::system_error(errno, std::generic_category(), path.string());
  std::setvbuf(log_->f, buffer_.data(), _IOFBF, buffer_.size());
  event_ends_.reserve(kBufferBytes / kMinEventBytes);
}

TelemetryLogWriter::~TelemetryLogWriter() { flush(); }

void TelemetryLogWriter::append(std::int64_t elapsed_us, Channel channel, const std::byte* encoded,
                                std::size_t size) noexcept {
  const std::uint64_t end = event_ends_.empty() ? bytes_ : event_ends_.back();
  // Always before stdio's buffer is full: stdio itself would write a part of an event.
  if (end - bytes_ + kMaxEventBytes > kBufferBytes) {
    flush();
  }
  if (error_) return;
  const std::size_t name_size = std::strlen(name(channel));
  lcm_eventlog_event_t event{};
  event.timestamp = elapsed_us;
  event.channellen = static_cast<std::int32_t>(name_size);
  event.datalen = static_cast<std::int32_t>(size);
  event.channel = const_cast<char*>(name(channel));  // only read
  event.data = const_cast<std::byte*>(encoded);      // only read
  if (lcm_eventlog_write_event(log_.get(), &event) != 0) return give_up(errno);
  event_ends_.push_back(end + kEventHeaderBytes + name_size + size);
}

void TelemetryLogWriter::flush() noexcept {
  if (error_ || event_ends_.empty()) return;
  if (std::fflush(log_->f) != 0 || std::ferror(log_->f) != 0) return give_up(errno);
  messages_ += event_ends_.size();
  bytes_ = event_ends_.back();
  event_ends_.clear();
}

/// Cuts the file back to its last whole event.
void TelemetryLogWriter::give_up(int error_number) noexcept {
  error_.assign(error_number, std::generic_category());
  __fpurge(log_->f);  // glibc has emptied its buffer by itself after a failed flush, but not after a failed fwrite
  struct stat status {};
  if (::fstat(fileno(log_->f), &status) == 0) {
    const auto size = static_cast<std::uint64_t>(status.st_size);
    const auto whole = std::upper_bound(event_ends_.begin(), event_ends_.end(), size) - event_ends_.begin();
    if (whole > 0) bytes_ = event_ends_[static_cast<std::size_t>(whole) - 1];
    messages_ += static_cast<std::uint64_t>(whole);
    // Where cutting is impossible (a device, a pipe) there is nothing to keep whole either.
    static_cast<void>(!::ftruncate(fileno(log_->f), static_cast<off_t>(bytes_)));
  }
  event_ends_.clear();
}

}  // namespace surefoot::host
