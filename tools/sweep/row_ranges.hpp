#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace surefoot::sweep {

/// Rows from the first to the last, both included.
struct RowRange {
  std::size_t first = 0;
  std::size_t last = 0;
};

/// "3-17"
[[nodiscard]] std::string to_text(const RowRange& range);

/// Of "3-17" or "3"; nothing when it is neither, or the last comes before the first.
[[nodiscard]] std::optional<RowRange> range_of(const std::string& text);

/// Rows in ascending order as ranges of neighbours.
///
/// @param longest  most rows in one range, 1 or more
[[nodiscard]] std::vector<RowRange> ranges_of(const std::vector<std::size_t>& rows, std::size_t longest);

/// So many rows in each piece of work that there are a few pieces for every worker of a large cluster, and the
/// start of a program costs little beside its rows.
[[nodiscard]] std::size_t rows_in_a_piece(std::size_t rows);

}  // namespace surefoot::sweep
