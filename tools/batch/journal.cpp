#include "tools/batch/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <functional>
#include <iterator>
#include <string_view>
#include <utility>

#include "firmware/host/sha256.hpp"
#include "tools/batch/verdict_line.hpp"
#include "tools/run/run_folder.hpp"
#include "tools/scenario/scenario_error.hpp"

namespace surefoot::batch {
namespace {

/// Of this program: other code may judge the same scenario differently.
std::string build_hash() {
  std::ifstream program("/proc/self/exe", std::ios::binary);
  host::Sha256 digest;
  for (char bytes[65536]; program.read(bytes, sizeof bytes), program.gcount() > 0;) {
    digest.update(bytes, static_cast<std::size_t>(program.gcount()));
  }
  return digest.hex().substr(0, 16);
}

[[noreturn]] void refuse(const std::string& place, std::string statement) {
  throw scenario::ScenarioError(
      {{place, std::move(statement), "remove this file, or give another place, and begin anew"}});
}

[[noreturn]] void fail(const std::filesystem::path& file, const char* what, const char* remedy) {
  throw run::RecordingFailure(
      fmt::format("{}: cannot be {}: {}\n  remedy: {}", file.string(), what, std::strerror(errno), remedy));
}

/// Calls `take(place, line)` for each whole line after the header.
/// @return where the last whole line ends
std::size_t read_lines(const std::filesystem::path& file,
                       const std::function<void(const std::string& place, const std::string& line)>& take) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) fail(file, "read", "check path and permissions");
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  std::size_t begin = 0;
  for (std::size_t number = 1, end = 0; (end = text.find('\n', begin)) != std::string::npos; ++number) {
    const std::string line = text.substr(begin, end - begin);
    const std::string place = fmt::format("{}:{}", file.string(), number);
    if (number == 1) {
      check_journal_header(place, line);
    } else {
      take(place, line);
    }
    begin = end + 1;
  }
  if (begin == 0 && !journal_header().starts_with(text)) check_journal_header(file.string(), text);
  return begin;
}

}  // namespace

const std::string& journal_header() {
  static const std::string header = fmt::format(R"({{"journal":"surefoot batch 1","build":"{}"}})", build_hash());
  return header;
}

void check_journal_header(const std::string& place, const std::string& line) {
  constexpr std::string_view kBegin = R"({"journal":"surefoot batch )";
  if (line == journal_header()) return;
  refuse(place, line.starts_with(kBegin) ? "was written by another build of surefoot" : "is no journal of a batch");
}

Journal::Journal(std::filesystem::path file, FinishedTrials& finished)
    : file_(std::move(file)), descriptor_(::open(file_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0644)) {
  if (descriptor_ < 0) fail(file_, "opened", "name another place for the journal");
  try {
    begin(finished);
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

Journal::~Journal() { ::close(descriptor_); }

void Journal::begin(FinishedTrials& finished) {
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
    throw scenario::ScenarioError(
        {{file_.string(), "is being written by another process", "wait until it has ended, or give another place"}});
  }
  if (!std::filesystem::is_regular_file(file_)) refuse(file_.string(), "is no regular file");
  const std::size_t end =
      read_lines(file_, [&](const std::string& place, const std::string& line) { finished.take(place, line); });
  if (::ftruncate(descriptor_, static_cast<off_t>(end)) != 0) fail(file_, "written", "name another place for it");
  if (end == 0) write(journal_header() + "\n");
}

void Journal::append(const std::string& line) { write(line + "\n"); }

void Journal::merge(const std::filesystem::path& part, FinishedTrials& finished) {
  read_lines(part, [&](const std::string& place, const std::string& line) {
    const std::optional<FinishedTrial> trial = read_line(line);
    const bool is_new = !trial || trial->trial >= finished.hashes().size() || !finished.has(trial->trial);
    finished.take(place, line);
    if (is_new) append(line);
  });
}

void Journal::write(const std::string& text) {
  const off_t begin = ::lseek(descriptor_, 0, SEEK_END);
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t size = ::write(descriptor_, text.data() + done, text.size() - done);
    if (size < 0 && errno == EINTR) continue;
    if (size >= 0) {
      done += static_cast<std::size_t>(size);
      continue;
    }
    // Half a line must not stand before those that others may still add.
    static_cast<void>(::ftruncate(descriptor_, begin));
    fail(file_, "written", "free disk space, then repeat the command: finished trials are kept");
  }
}

}  // namespace surefoot::batch
