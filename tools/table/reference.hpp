#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "tools/table/grid.hpp"

namespace surefoot::table {

/// A table of results that cannot be used; the message names file, line, value and remedy.
class BadReference : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Results of somebody else: who survived what.
struct Reference {
  std::string name;  ///< as tables show it
  Grid grid;
  std::vector<std::optional<bool>> survives;  ///< one for each cell of the grid; nothing: not printed

  /// The cell of that instant and load; nothing where the reference has none, or did not print it.
  [[nodiscard]] std::optional<bool> at(double time_s, double mass_kg) const noexcept;
};

/// Reads comma-separated values: a head "load_time_s,2.5,5.0,...", then one row for each instant with 1 (survives),
/// 0 (falls) or nothing (not printed) for each load.
/// @throws BadReference
[[nodiscard]] Reference parse_reference(const std::string& name, const std::string& text);

/// The same from a file.
/// @throws BadReference
[[nodiscard]] Reference load_reference(const std::filesystem::path& file);

/// Table 4.1, 4.2 or 4.3 of El-Kahlout 2003 for the methods off, original and modified; nothing for another.
[[nodiscard]] std::optional<Reference> thesis_table(const std::string& method);

}  // namespace surefoot::table
