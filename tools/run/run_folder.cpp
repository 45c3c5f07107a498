#include "tools/run/run_folder.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "tools/run/lockstep_run.hpp"

namespace surefoot::run {
namespace {

constexpr const char* kRemedy = "remedy: free disk space, or name a folder that you may write with --out";

}  // namespace

void create_run_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder)) {
    throw RecordingFailure(fmt::format("{}: can not be made: {}\n  {}", folder.string(),
                                       error ? error.message() : "a file is in the way", kRemedy));
  }
}

void write_whole_file(const std::filesystem::path& path, const std::string& text) {
  const std::filesystem::path unfinished = path.string() + ".unfinished";
  std::ofstream file(unfinished, std::ios::binary | std::ios::trunc);
  file << text;
  file.close();
  std::error_code error;
  if (file) std::filesystem::rename(unfinished, path, error);
  if (!file || error) {
    const std::string cause = error ? error.message() : std::strerror(errno);
    std::filesystem::remove(unfinished, error);
    throw RecordingFailure(fmt::format("{}: can not be written: {}\n  {}", path.string(), cause, kRemedy));
  }
}

}  // namespace surefoot::run
