#pragma once

#include <functional>
#include <string>
#include <vector>

namespace surefoot::doctor {

/// How a piece of work in a process of its own ended.
struct Outcome {
  int exit_code = 0;   ///< 127: the program is not there; 128 + n: ended by signal n
  std::string output;  ///< standard output and error, without the last line's end

  [[nodiscard]] bool is_success() const { return exit_code == 0; }
};

/// Runs `work` in a child process, which is killed after 10 s: what it prints, breaks or waits for stays there.
/// @param work  returns the exit code
[[nodiscard]] Outcome in_child_process(const std::function<int()>& work);

/// Runs a program without input.
/// @param command  its name or path, then its arguments
[[nodiscard]] Outcome run_program(const std::vector<std::string>& command);

}  // namespace surefoot::doctor
