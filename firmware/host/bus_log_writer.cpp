#include "firmware/host/bus_log_writer.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string_view>

#include "firmware/host/candump_format.hpp"

namespace surefoot::host {
namespace {

constexpr std::size_t kBufferBytes = 256 * 1024;

}  // namespace

BusLogWriter::BusLogWriter(const std::filesystem::path& path)
    : file_(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644)), buffer_(kBufferBytes) {
  if (file_ < 0) throw std::system_error(errno, std::generic_category(), path.string());
}

BusLogWriter::~BusLogWriter() {
  flush();
  ::close(file_);
}

void BusLogWriter::append(std::int64_t elapsed_us, const can::CanFrame& frame) noexcept {
  if (error_) return;
  if (buffer_.size() - used_ < kMaxCandumpLine) {
    flush();
    if (error_) return;
  }
  char* const line = buffer_.data() + used_;
  used_ += static_cast<std::size_t>(format_candump_line(line, elapsed_us, frame) - line);
  ++buffered_frames_;
}

void BusLogWriter::flush() noexcept {
  if (error_ || used_ == 0) return;
  std::string_view kept(buffer_.data(), write_buffer());
  if (error_) {
    kept = kept.substr(0, kept.rfind('\n') + 1);  // npos + 1 is 0: not even one line
    buffered_frames_ = static_cast<std::uint64_t>(std::count(kept.begin(), kept.end(), '\n'));
  }
  digest_.update(kept.data(), kept.size());
  bytes_ += kept.size();
  frames_ += buffered_frames_;
  used_ = 0;
  buffered_frames_ = 0;
  // Where cutting is impossible (a device, a pipe) there is nothing to keep whole either.
  if (error_) static_cast<void>(!::ftruncate(file_, static_cast<off_t>(bytes_)));
}

/// @return bytes that reached the file
std::size_t BusLogWriter::write_buffer() noexcept {
  std::size_t done = 0;
  while (done < used_) {
    const ssize_t now = ::write(file_, buffer_.data() + done, used_ - done);
    if (now < 0 && errno == EINTR) continue;
    if (now < 0) {
      error_.assign(errno, std::generic_category());
      break;
    }
    done += static_cast<std::size_t>(now);
  }
  return done;
}

}  // namespace surefoot::host
