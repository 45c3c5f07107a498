#pragma once

#include <sys/types.h>

#include <atomic>
#include <optional>
#include <string>
#include <vector>

namespace surefoot::sweep {

/// A program whose standard output is read line by line; its messages are ours. Destroying it ends the program.
class LinePipe {
 public:
  /// @param arguments  the program first
  /// @throws run::ProcessFailure when it cannot be started
  explicit LinePipe(const std::vector<std::string>& arguments);
  ~LinePipe();
  LinePipe(const LinePipe&) = delete;
  LinePipe& operator=(const LinePipe&) = delete;

  /// Waits for the next whole line.
  /// @return nothing at the end of its output, or once `stop` is set
  [[nodiscard]] std::optional<std::string> next(const std::atomic<bool>* stop);

  /// Waits for its end: its exit code, 128 + n for signal n.
  [[nodiscard]] int exit_code();

 private:
  pid_t pid_ = -1;
  int descriptor_ = -1;
  bool has_ended_ = false;
  std::string unread_;
};

}  // namespace surefoot::sweep
