#pragma once

#include <string>
#include <vector>

#include "tools/floor/floor_table.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::floor {

/// Angles of the torso against the vertical over the scored time of one walk, sampled every 20 ms, until the end or the
/// fall.
struct TorsoTrace {
  std::vector<double> time_s;  ///< on the scenario's clock
  std::vector<double> roll_deg;
  std::vector<double> pitch_deg;
  bool has_fallen = false;
};

/// Walks the scenario in lockstep, unrecorded.
[[nodiscard]] TorsoTrace trace_of(const scenario::Scenario& scenario);

/// One line in the paper's figures 23 and 24.
struct TracedWalk {
  std::string set;
  FloorCase floor = FloorCase::kFlat;
  double slope_deg = 0.0;
  TorsoTrace trace;
};

/// For pictures; `trace` of each is still empty: the four floors on the spot under each set.
[[nodiscard]] std::vector<TracedWalk> traced_walks(const FloorTableSpec& spec);

/// The scenario of one of them, on the first seed.
/// @throws scenario::ScenarioError
[[nodiscard]] scenario::Scenario scenario_of(const TracedWalk& walk, const FloorTableSpec& spec,
                                             const batch::Batch& base);

[[nodiscard]] std::string trace_csv(const std::vector<TracedWalk>& walks);
[[nodiscard]] std::string to_json(const std::vector<TracedWalk>& walks, const FloorTableSpec& spec);

/// Largest angles of each walk.
[[nodiscard]] std::string trace_text(const std::vector<TracedWalk>& walks);

}  // namespace surefoot::floor
