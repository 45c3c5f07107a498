#include "tools/sweep/row_ranges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <system_error>

namespace surefoot::sweep {
namespace {

constexpr std::size_t kFewestPieces = 64;
constexpr std::size_t kMostPieces = 1000;  // what a Slurm array takes unless it was told otherwise
constexpr std::size_t kWorthAStart = 32;

std::optional<std::size_t> number_of(const char* begin, const char* end) {
  std::size_t number = 0;
  const auto [rest, error] = std::from_chars(begin, end, number);
  if (error != std::errc{} || rest != end) return std::nullopt;
  return number;
}

}  // namespace

std::string to_text(const RowRange& range) { return fmt::format("{}-{}", range.first, range.last); }

std::optional<RowRange> range_of(const std::string& text) {
  const char* const end = text.data() + text.size();
  const char* const dash = std::find(text.data(), end, '-');
  const std::optional<std::size_t> first = number_of(text.data(), dash);
  const std::optional<std::size_t> last = dash == end ? first : number_of(dash + 1, end);
  if (!first || !last || *first > *last) return std::nullopt;
  return RowRange{*first, *last};
}

std::vector<RowRange> ranges_of(const std::vector<std::size_t>& rows, std::size_t longest) {
  std::vector<RowRange> ranges;
  for (const std::size_t row : rows) {
    const bool is_next = !ranges.empty() && row == ranges.back().last + 1;
    if (is_next && row - ranges.back().first < longest) {
      ranges.back().last = row;
    } else {
      ranges.push_back({row, row});
    }
  }
  return ranges;
}

std::size_t rows_in_a_piece(std::size_t rows) {
  const std::size_t wanted = std::clamp<std::size_t>(rows / kFewestPieces, 1, kWorthAStart);
  return std::max(wanted, (rows + kMostPieces - 1) / kMostPieces);
}

}  // namespace surefoot::sweep
