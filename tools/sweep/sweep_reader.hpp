#pragma once

#include <toml++/toml.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tools/scenario/scenario_error.hpp"
#include "tools/sweep/key_kind.hpp"

namespace surefoot::sweep {

/// A value that was written into a sweep file, or drawn.
struct Value {
  std::string text;   ///< TOML, as `--set` takes it
  std::string place;  ///< "file:line:column"
};

/// One key with the values that it takes.
struct Varied {
  std::string key;
  std::vector<Value> values;
};

/// A key that is drawn at random from [min, max].
struct RandomKey {
  std::string key;
  std::string place;
  bool is_integer = false;
  double min = 0.0, max = 0.0;
  std::int64_t min_integer = 0, max_integer = 0;
};

/// What stands in a sweep file, checked as far as it can be without a scenario.
struct SweepFile {
  std::string scenario;     ///< as written; empty: none
  std::vector<Varied> set;  ///< one value each
  std::vector<Varied> grid;
  std::vector<Varied> list;  ///< all of one length
  std::vector<RandomKey> random;
  std::uint64_t draws = 1;
  std::uint64_t draw_seed = 1;
};

/// @param name  of the file, as messages show it
/// @throws scenario::ScenarioError with every problem found, in the order of the lines
[[nodiscard]] SweepFile read_sweep_file(const std::string& name, const toml::table& root);

}  // namespace surefoot::sweep
