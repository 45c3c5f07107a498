#pragma once

#include <sys/types.h>

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace surefoot::run {

/// A program could not be started, or ended in a way that it should not; the message names it.
class ProcessFailure : public std::runtime_error {
 public:
  /// @param exit_code  that this failure asks of the program that reports it
  ProcessFailure(const std::string& message, int exit_code) : std::runtime_error(message), exit_code_(exit_code) {}
  [[nodiscard]] int exit_code() const noexcept { return exit_code_; }

 private:
  int exit_code_;
};

/// A program that runs beside this one; its standard output is thrown away, its messages are ours.
/// Destroying it ends the program.
class ChildProcess {
 public:
  /// @param arguments  the program first
  /// @throws ProcessFailure
  explicit ChildProcess(const std::vector<std::string>& arguments);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Its exit code once it has ended, 128 + n for signal n; nothing while it runs. Never waits.
  [[nodiscard]] std::optional<int> exit_code();

  /// Asks it to end (SIGTERM).
  void ask_to_end() noexcept;

 private:
  pid_t pid_ = -1;
  std::optional<int> exit_code_;
};

}  // namespace surefoot::run
