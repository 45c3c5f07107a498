#pragma once

#include <string>
#include <vector>

#include "tools/scenario/field.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::scenario {

/// Something impossible in a scenario, before it is known where it was written.
struct Finding {
  std::vector<std::string>
      keys;  ///< keys that take part, e.g. "payload[0].mass_kg"; the place is that of the first given
  std::string statement;
  std::string remedy;
};

/// A value that its key does not take.
///
/// @param key           as messages show it
/// @param value         as messages show it, e.g. "-5" or "the string \"abc\""
/// @param expected      e.g. "0 to 60 kg"
/// @param default_text  what holds without the key
[[nodiscard]] Finding refusal(const Field& field, const std::string& key, const std::string& value,
                              const std::string& expected, const std::string& default_text);

/// Values out of their key's range.
[[nodiscard]] std::vector<Finding> check_ranges(const Scenario& scenario);

/// Values that contradict each other: physics step, reach of the legs, joint ranges, detector, watchdog, bus, loads
/// taken off before they hang.
[[nodiscard]] std::vector<Finding> check_relations(const Scenario& scenario);

}  // namespace surefoot::scenario
