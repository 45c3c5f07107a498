#pragma once

#include <sys/resource.h>

#include <csignal>
#include <stdexcept>

namespace surefoot::host::testing {

/// While it lives, no file of this process grows beyond `bytes`: write says EFBIG, as a full disk
/// says ENOSPC, in the middle of a buffer. The signal that comes with it is left to the recorder.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    if (::getrlimit(RLIMIT_FSIZE, &before_) != 0) throw std::runtime_error("getrlimit");
    const rlimit limit{.rlim_cur = bytes, .rlim_max = before_.rlim_max};
    if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) throw std::runtime_error("setrlimit");
  }
  ~FileSizeLimit() { ::setrlimit(RLIMIT_FSIZE, &before_); }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
};

}  // namespace surefoot::host::testing
