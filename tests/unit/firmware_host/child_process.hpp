#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <functional>

namespace surefoot::host {

/// For tests that spoil the process they are in: limits, user, locked memory, scheduling.
///
/// @return whether `holds` was true in a child process
inline bool holds_in_a_child(const std::function<bool()>& holds) {
  const pid_t child = fork();
  if (child == 0) {
    const bool is_true = holds();
    std::fflush(stdout);
    _exit(is_true ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// An ordinary user from here on. Exits with 2 where that fails.
inline void become_nobody() {
  constexpr uid_t kNobody = 65534;
  if (geteuid() == 0 && setresuid(kNobody, kNobody, kNobody) != 0) _exit(2);
}

}  // namespace surefoot::host
