#include "tools/doctor/outcome.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>

#include "firmware/host/bus/file_descriptor.hpp"

namespace surefoot::doctor {
namespace {

constexpr unsigned kPatienceS = 10;
constexpr int kCannotRun = 127;

[[noreturn]] void be_child(const std::function<int()>& work, int output) {
  alarm(kPatienceS);  // survives exec
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  const int exit_code = work();
  std::fflush(stdout);
  _exit(exit_code);
}

std::string read_to_end(int source) {
  std::string text;
  std::array<char, 4096> chunk;
  while (true) {
    const ssize_t size = read(source, chunk.data(), chunk.size());
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) return text;
    text.append(chunk.data(), static_cast<std::size_t>(size));
  }
}

}  // namespace

Outcome in_child_process(const std::function<int()>& work) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) return {kCannotRun, "no pipe"};
  const host::FileDescriptor source(ends[0]);
  std::fflush(stdout);  // or the child would print it once more
  const pid_t child = fork();
  if (child == 0) be_child(work, ends[1]);
  close(ends[1]);
  if (child < 0) return {kCannotRun, "no child process"};
  Outcome outcome;
  outcome.output = read_to_end(source.get());
  while (!outcome.output.empty() && outcome.output.back() == '\n') outcome.output.pop_back();
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return outcome;
}

Outcome run_program(const std::vector<std::string>& command) {
  return in_child_process([&] {
    std::vector<char*> arguments;
    for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);
    execvp(arguments[0], arguments.data());
    return kCannotRun;
  });
}

}  // namespace surefoot::doctor
