#include "tools/table/small_file.hpp"

#include <fstream>
#include <sstream>
#include <system_error>

namespace surefoot::table {

std::optional<std::string> read_small_file(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error || size == 0 || size > kLargestFile) return std::nullopt;
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return stream && text ? std::optional(text.str()) : std::nullopt;
}

}  // namespace surefoot::table
