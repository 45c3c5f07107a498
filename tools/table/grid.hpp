#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace surefoot::table {

/// Text that is no list of numbers; the message says what was expected.
class BadList : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Numbers as given on the command line: "2.5,5,10", "0.1:4.8:0.1" (first, last, step), or both mixed with commas.
///
/// Sums are rounded to 1e-9, so that the third of "0.1:4.8:0.1" is 0.3.
/// @return at least one and at most 10,000 numbers, ascending, each once
/// @throws BadList
[[nodiscard]] std::vector<double> parse_list(const std::string& text);

/// Two bounds "1:20", the second above the first.
struct Bounds {
  double low = 0.0;
  double high = 0.0;
};

/// @throws BadList
[[nodiscard]] Bounds parse_bounds(const std::string& text);

/// One experiment of a table.
struct Load {
  double mass_kg = 0.0;
  double at_s = 0.0;  ///< on the scenario's clock
};

/// The experiments of a table: every load at every instant.
struct Grid {
  std::vector<double> times_s;    ///< instants of the load on the scenario's clock
  std::vector<double> masses_kg;  ///< loads

  [[nodiscard]] std::size_t size() const noexcept { return times_s.size() * masses_kg.size(); }
  /// Cells are kept row by row: all loads of an instant, then the next instant.
  [[nodiscard]] std::size_t index(std::size_t time, std::size_t mass) const noexcept {
    return time * masses_kg.size() + mass;
  }
};

/// All of them in the order of the cells.
[[nodiscard]] std::vector<Load> loads_of(const Grid& grid);

/// 48 instants 0.1 to 4.8 s and six loads 2.5 to 15 kg: El-Kahlout 2003, tables 4.1 to 4.3.
[[nodiscard]] Grid thesis_grid();

/// Two numbers that mean the same instant or load.
[[nodiscard]] inline bool is_same(double a, double b) noexcept { return a - b < 1e-9 && b - a < 1e-9; }

}  // namespace surefoot::table
