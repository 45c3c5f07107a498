#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tools/table/cell.hpp"
#include "tools/table/grid.hpp"

namespace surefoot::table {

/// Loads and instants drawn evenly from two ranges, off any grid.
struct RandomTable {
  std::string method;
  std::string plant;
  std::uint64_t seed = 1;
  std::vector<Load> loads;
  std::vector<Cell> cells;
};

/// The same draws for the same seed, on every machine; the first n of more draws are the n draws. Rounded to 1 g and
/// 1 ms, so that a row can be typed.
[[nodiscard]] std::vector<Load> draw_loads(std::size_t count, std::uint64_t seed, const Bounds& masses_kg,
                                           const Bounds& times_s);

/// Count of survivors, and that of each quarter of the range of loads.
[[nodiscard]] std::string random_text(const RandomTable& table, const Bounds& masses_kg);

[[nodiscard]] std::string to_json(const RandomTable& table);

}  // namespace surefoot::table
