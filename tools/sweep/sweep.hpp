#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "tools/batch/batch.hpp"
#include "tools/scenario/scenario_error.hpp"

namespace surefoot::sweep {

/// Most rows of one sweep; more is a mistake in a file.
inline constexpr std::size_t kMaxRows = 1'000'000;

/// Many runs of one scenario, as a sweep file describes them: every draw with every combination of the grid
/// with every row of the list. Draws change slowest, then the grid's keys in the order of the file, then the list.
struct Sweep {
  std::string name;                              ///< the file without its suffix
  std::vector<std::string> keys;                 ///< what is varied: [grid], [list], [random], each as in the file
  std::vector<std::vector<std::string>> values;  ///< by row, then by key: TOML, numbers in full precision
  batch::Batch batch;                            ///< the same, ready to run
  std::map<std::string, std::string> place_of;   ///< "--set key=value" to "file:line:column"
};

/// Reads a sweep file. Names of keys and values are not checked here but by the scenario, when rows are loaded.
///
/// @throws scenario::ScenarioError naming file, line and key
[[nodiscard]] Sweep load(const std::filesystem::path& file);

/// The same for text; `file` names it, and scenario files are found from there.
[[nodiscard]] Sweep load_text(const std::filesystem::path& file, std::string_view text);

/// What a scenario says about an override, with the place in the sweep file that gave it.
[[nodiscard]] scenario::ScenarioError with_places(const Sweep& sweep, const scenario::ScenarioError& error);

}  // namespace surefoot::sweep
