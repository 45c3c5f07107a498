#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace surefoot::run {

/// The run cannot be recorded: no permission, disk full, an earlier run in the way. The message names path and remedy.
class RecordingFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Makes the folder of a run, with its parents. The verdict of an earlier run in it goes at once: it would
/// speak of a log that is no more.
/// @throws RecordingFailure naming path and remedy
void create_run_folder(const std::filesystem::path& folder);

/// @throws RecordingFailure naming path and remedy when the folder holds an earlier run
void refuse_earlier_run(const std::filesystem::path& folder);

/// Makes a folder that is no other run's, also when many runs start at the same time.
/// @return `wanted`, or that with "-2", "-3", ... behind it
/// @throws RecordingFailure naming path and remedy
[[nodiscard]] std::filesystem::path claim_run_folder(const std::filesystem::path& wanted);

/// Writes a small file at once or not at all: beside its place, then renamed.
/// @throws RecordingFailure naming path and remedy
void write_whole_file(const std::filesystem::path& path, const std::string& text);

}  // namespace surefoot::run
