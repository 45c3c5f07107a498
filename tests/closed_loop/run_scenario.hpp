#pragma once

#include <algorithm>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "tools/run/lockstep_run.hpp"

namespace surefoot::testing {

/// Runs the main job with overrides, unrecorded.
inline run::Verdict run_main_job(const std::vector<std::string>& overrides, const run::RunOptions& options = {}) {
  return run::run_lockstep(scenario::load_default(overrides), options);
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
