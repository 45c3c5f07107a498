#pragma once

#include <filesystem>
#include <string>

namespace surefoot::run {

/// Makes the folder and writes a small file into it at once or not at all (written beside, then renamed).
/// @throws RecordingFailure naming the path and the remedy
void create_run_folder(const std::filesystem::path& folder);
void write_whole_file(const std::filesystem::path& path, const std::string& text);

}  // namespace surefoot::run
