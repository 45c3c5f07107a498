#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace surefoot::table {

/// Files that people write by hand are smaller.
inline constexpr std::uintmax_t kLargestFile = 1'000'000;

/// The whole of a regular file of 1 to `kLargestFile` bytes; nothing for anything else, or where it cannot be read.
[[nodiscard]] std::optional<std::string> read_small_file(const std::filesystem::path& file);

}  // namespace surefoot::table
