#pragma once

#include <filesystem>
#include <string>

namespace surefoot::cli {

/// Says before a long computation what would keep its picture from being drawn.
/// @throws run::RecordingFailure
void check_picture(const std::filesystem::path& png);

/// Has Python draw what a command prints as JSON; its member "picture" chooses how.
/// @throws run::RecordingFailure
void draw_picture(const std::string& json, const std::filesystem::path& png);

}  // namespace surefoot::cli
