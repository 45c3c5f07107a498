#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/table/table.hpp"

namespace surefoot::table {

/// The matrix, beside its reference where there is one: '+' survives, 'f' falls, 'l' limit, 'x' fault, '-' not
/// printed in the reference; '!' stands behind a cell that differs.
[[nodiscard]] std::string matrix_text(const Table& table, const std::optional<Reference>& reference);

/// Counts, differences and half-cycle symmetry in a few lines.
[[nodiscard]] std::string summary_text(const Table& table, const std::optional<Reference>& reference,
                                       double half_cycle_s);

/// Every cell that does not survive, a line each: load, instant, direction, seconds after load and trigger, phase.
[[nodiscard]] std::string falls_text(const std::vector<Load>& loads, const std::vector<Cell>& cells);

/// A row for each load; columns of cells without a fall or a reference stay empty.
[[nodiscard]] std::string to_csv(const std::vector<Load>& loads, const std::vector<Cell>& cells,
                                 const std::optional<Reference>& reference);

/// Grid, cells, reference, counts and symmetry.
[[nodiscard]] std::string to_json(const Table& table, const std::optional<Reference>& reference, double half_cycle_s);

}  // namespace surefoot::table
