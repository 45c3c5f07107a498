#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace surefoot::scenario {

/// One thing wrong with a scenario, and what to do about it.
struct Problem {
  std::string place;      ///< "main.toml:14:9", "main.toml" or "--set key=value"
  std::string statement;  ///< "payload[0].mass_kg is -5; expected 0 to 60 kg"
  std::string remedy;     ///< what to do, without full stop
};

/// A scenario that cannot be run; `what()` shows all problems, two lines each:
///
///     main.toml:14:11: payload[0].mass_kg is -5; expected 0 to 60 kg
///       remedy: give the mass of the load in kg, or remove the key to use 5
class ScenarioError : public std::runtime_error {
 public:
  /// @param problems  at least one, in the order in which they are shown
  explicit ScenarioError(std::vector<Problem> problems);

  [[nodiscard]] const std::vector<Problem>& problems() const noexcept { return problems_; }

 private:
  std::vector<Problem> problems_;
};

}  // namespace surefoot::scenario
