#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace surefoot::map {

/// One place on an axis: what it is called, and what it changes in the scenario.
struct AxisValue {
  std::string label;
  std::vector<std::string> overrides;  ///< "key=value" each
};

/// One direction of a map.
struct Axis {
  std::string title;  ///< with unit, e.g. "load, kg"
  std::vector<AxisValue> values;
};

/// What is varied, and which methods have to stand it. Each cell of rows by columns is a share: of the runs with its
/// row, its column and every value of `repeats`, those that survive.
struct MapSpec {
  std::string title;
  std::string method_key = "reflex.method";
  std::string method_title = "reflex";  ///< what stands before a method's name
  std::vector<std::string> methods;     ///< values of `method_key`
  std::vector<std::string> set;      ///< overrides of every run
  Axis columns;
  Axis rows;
  Axis repeats;  ///< one nameless value where nothing is repeated
};

/// A specification that cannot be used; the message names file, place and remedy.
class BadSpec : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads TOML: `title`, `methods`, `set`, and the tables `[columns]`, `[rows]` and `[repeats]`, each with a `title` and
/// either `key` and `values`, or `values` as tables of `label` and `set`. In any `set`, {column}, {row} and {repeat}
/// stand for the labels of the run's three values:
///
///     title = "mass x time"
///     methods = ["original", "modified"]
///     [columns]
///     title = "load at, s"
///     key = "payload.0.at_s"
///     values = [0.6, 1.2]
///     [rows]
///     title = "place"
///     values = [{label = "back", set = ["payload.0.position_m=[-0.2, 0.0, 0.25]"]}]
///
/// With `set = ["push.0.force_n=[{row}, 0.0, 0.0]"]` in a column, rows may be bare numbers without a key.
///
/// @param name  of the file, in messages
/// @throws BadSpec
[[nodiscard]] MapSpec parse_spec(const std::string& name, const std::string& text);

/// @throws BadSpec
[[nodiscard]] MapSpec load_spec(const std::filesystem::path& file);

/// A map that comes with the program.
struct Preset {
  const char* kind;
  const char* what;
  const char* text;  ///< as `parse_spec` reads it
};

[[nodiscard]] const std::vector<Preset>& presets();

}  // namespace surefoot::map
