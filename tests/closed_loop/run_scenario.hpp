#pragma once

#include <algorithm>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "tools/run/lockstep_run.hpp"

namespace surefoot::testing {

/// Runs a scenario of tools/scenarios with overrides, unrecorded unless the options name a folder.
inline run::Verdict run_scenario(const std::string& name, const std::vector<std::string>& overrides = {},
                                 const run::RunOptions& options = {}) {
  return run::run_lockstep(scenario::load(SUREFOOT_SCENARIOS "/" + name + ".toml", overrides), options);
}

/// Time of the first event of that name at or after `from_s`.
inline std::optional<double> time_of(const run::Verdict& verdict, const char* event_name, double from_s = -1e9) {
  const auto found = std::find_if(verdict.events.begin(), verdict.events.end(), [&](const run::TimedEvent& event) {
    return std::strcmp(event.name, event_name) == 0 && event.time_s >= from_s;
  });
  if (found == verdict.events.end()) return std::nullopt;
  return found->time_s;
}

}  // namespace surefoot::testing
