#include "tools/sweep/line_pipe.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "tools/run/child_process.hpp"
#include "tools/run/exit_code.hpp"

namespace surefoot::sweep {
namespace {

constexpr int kLookForStop_ms = 100;

[[noreturn]] void fail(const std::string& program, int error) {
  throw run::ProcessFailure(
      fmt::format("{}: cannot be started: {}\n  remedy: run tools/setup", program, std::strerror(error)),
      static_cast<int>(run::ExitCode::kMachineLacks));
}

}  // namespace

LinePipe::LinePipe(const std::vector<std::string>& arguments) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail(arguments.front(), errno);
  descriptor_ = ends[0];
  std::vector<char*> argv;
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  const int error = posix_spawn(&pid_, arguments.front().c_str(), &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  if (error == 0) return;
  ::close(descriptor_);
  fail(arguments.front(), error);
}

LinePipe::~LinePipe() {
  ::close(descriptor_);
  if (has_ended_) return;
  ::kill(pid_, SIGTERM);
  static_cast<void>(exit_code());
}

std::optional<std::string> LinePipe::next(const std::atomic<bool>* stop) {
  while (true) {
    if (const std::size_t end = unread_.find('\n'); end != std::string::npos) {
      std::string line = unread_.substr(0, end);
      unread_.erase(0, end + 1);
      return line;
    }
    if (stop != nullptr && stop->load()) return std::nullopt;
    pollfd waited{descriptor_, POLLIN, 0};
    if (::poll(&waited, 1, kLookForStop_ms) <= 0) continue;
    std::array<char, 65536> bytes;
    const ssize_t size = ::read(descriptor_, bytes.data(), bytes.size());
    if (size == 0) return std::nullopt;
    if (size > 0) unread_.append(bytes.data(), static_cast<std::size_t>(size));
  }
}

int LinePipe::exit_code() {
  int status = 0;
  while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  has_ended_ = true;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace surefoot::sweep
