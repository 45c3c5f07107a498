#include "tools/run/run_folder.hpp"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <fstream>
#include <system_error>

namespace surefoot::run {
namespace {

constexpr const char* kRemedy = "remedy: free disk space, or name a folder that you may write with --out";

/// What a run writes, the verdict last.
constexpr std::array kRunFiles{"scenario.toml", "bus.log", "telemetry.lcmlog", "verdict.json"};

[[noreturn]] void fail(const std::filesystem::path& path, const char* what, const std::error_code& error) {
  throw RecordingFailure(fmt::format("{}: {}: {}\n  {}", path.string(), what, error.message(), kRemedy));
}

void make_directories(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) fail(folder, "cannot be made", error);
}

/// A run that could not begin leaves empty files; they are in nobody's way. A folder has no size: -1, something.
bool holds_something(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::exists(file, ignored) && std::filesystem::file_size(file, ignored) > 0;
}

}  // namespace

void create_run_folder(const std::filesystem::path& folder) {
  make_directories(folder);
  std::error_code error;
  std::filesystem::remove(folder / kRunFiles.back(), error);
  if (error) fail(folder / kRunFiles.back(), "cannot be removed", error);
}

void refuse_earlier_run(const std::filesystem::path& folder) {
  for (const char* file : kRunFiles) {
    if (!holds_something(folder / file)) continue;
    throw RecordingFailure(
        fmt::format("{}: is there already, from an earlier run\n  remedy: name another folder with --out, or replace "
                    "it with --overwrite",
                    (folder / file).string()));
  }
}

std::filesystem::path claim_run_folder(const std::filesystem::path& wanted) {
  make_directories(wanted.parent_path());
  std::filesystem::path folder = wanted;
  for (int copy = 2;; ++copy) {
    std::error_code error;
    if (std::filesystem::create_directory(folder, error)) return folder;
    if (error) fail(folder, "cannot be made", error);
    folder = fmt::format("{}-{}", wanted.string(), copy);
  }
}

void write_whole_file(const std::filesystem::path& path, const std::string& text) {
  const std::filesystem::path unfinished = path.string() + ".unfinished";
  std::ofstream file(unfinished, std::ios::binary | std::ios::trunc);
  file << text;
  file.close();
  std::error_code error;
  if (file) std::filesystem::rename(unfinished, path, error);
  if (file && !error) return;
  if (!error) error.assign(errno, std::generic_category());
  std::error_code ignored;
  std::filesystem::remove(unfinished, ignored);
  fail(path, "cannot be written", error);
}

}  // namespace surefoot::run
