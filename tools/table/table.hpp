#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tools/table/cell.hpp"
#include "tools/table/grid.hpp"
#include "tools/table/reference.hpp"

namespace surefoot::table {

/// What a method survives, load by instant.
struct Table {
  std::string method;
  std::string plant;
  Grid grid;
  std::vector<Cell> cells;  ///< in the grid's order
};

/// A table against a reference: sums over the cells that both have.
struct Comparison {
  std::size_t printed = 0;          ///< cells that the reference has
  std::size_t survive_printed = 0;  ///< of them those that survive in the reference
  std::size_t only_survive_here = 0;
  std::size_t only_survive_there = 0;

  [[nodiscard]] std::size_t differing() const noexcept { return only_survive_here + only_survive_there; }
};

[[nodiscard]] Comparison compare(const Table& table, const Reference& reference);

/// Two instants half a cycle apart at which the robot does the same with left and right changed over.
struct SymmetryBreach {
  double mass_kg = 0.0;
  double early_s = 0.0;
  double late_s = 0.0;
  bool early_survives = false;
};

/// Pairs of one load, half a cycle apart, of which one survives.
struct SymmetryCheck {
  std::size_t pairs = 0;
  std::vector<SymmetryBreach> breaches;
};

[[nodiscard]] SymmetryCheck check_symmetry(const Table& table, double half_cycle_s);

}  // namespace surefoot::table
