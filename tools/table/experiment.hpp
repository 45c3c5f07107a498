#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/batch/batch.hpp"
#include "tools/scenario/scenario.hpp"
#include "tools/table/grid.hpp"

namespace surefoot::table {

/// What all experiments of a table have in common.
struct Experiment {
  std::string method;                   ///< reflex.method
  std::string plant;                    ///< empty: that of the scenario
  std::filesystem::path scenario_file;  ///< empty: the main job
  std::vector<std::string> overrides;   ///< "key=value", as given to `--set`; method and plant win over them
};

/// Scenario and common overrides of these experiments, without trials. Success needs two gait cycles after the walk
/// has resumed, and knows no limit on the torso's angles.
[[nodiscard]] batch::Batch batch_of(const Experiment& experiment);

/// The batch's scenario as it stands before a trial changes it.
/// @throws scenario::ScenarioError
[[nodiscard]] scenario::Scenario load_common(const batch::Batch& batch);

/// Longest time from a disturbance to the end of two gait cycles after the walk has resumed: one cycle within which the
/// detector must have fired, reflex, settling, shift, the longest restoring step, rest, and the cycles that
/// `limits.min_cycles_after_recovery` asks for. A run whose load was never noticed lasts so long, any other ends when
/// those cycles are walked.
[[nodiscard]] double seconds_to_judge(const scenario::Scenario& scenario);

/// One load, as first payload of the scenario, and a run long enough to judge it.
[[nodiscard]] batch::Trial trial_of(const Load& load, double seconds_to_judge);

/// A batch of one trial for each load.
/// @throws scenario::ScenarioError
[[nodiscard]] batch::Batch batch_of(const Experiment& experiment, const std::vector<Load>& loads);

}  // namespace surefoot::table
