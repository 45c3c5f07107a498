#include "tools/table/experiment.hpp"

#include <fmt/format.h>

namespace surefoot::table {

batch::Batch batch_of(const Experiment& experiment) {
  batch::Batch batch;
  batch.scenario_file = experiment.scenario_file;
  batch.common = {"limits.max_abs_pitch_deg=0", "limits.max_abs_roll_deg=0", "limits.min_cycles_after_recovery=2",
                  "limits.ends_when_recovered=true"};
  batch.common.insert(batch.common.end(), experiment.overrides.begin(), experiment.overrides.end());
  if (!experiment.plant.empty()) batch.common.push_back("plant=" + experiment.plant);
  batch.common.push_back("reflex.method=" + experiment.method);
  return batch;
}

scenario::Scenario load_common(const batch::Batch& batch) {
  return batch.scenario_file.empty() ? scenario::load_default(batch.common)
                                     : scenario::load(batch.scenario_file, batch.common);
}

double seconds_to_judge(const scenario::Scenario& scenario) {
  const gait::WalkParameters& walk = scenario.firmware.walk;
  const decision::ReflexConfig& reflex = scenario.firmware.reflex;
  const double detection_s = walk.cycle_s();
  const double restoring_s = 0.25 * walk.cycle_s();  // (3.24), (3.25) with factor 0
  const double resting_s = 0.5 * reflex.settling_s;
  const bool is_gentle = reflex.method == decision::ReflexMethod::kCapture;
  const double longest_shift_m = reflex.max_shift_m + reflex.capture.max_step_m;
  const double shift_s =
      is_gentle ? decision::gentle_shift_s(reflex.capture, longest_shift_m, reflex.shift_s) : reflex.shift_s;
  return detection_s + reflex.reflex_s + reflex.settling_s + shift_s + restoring_s + resting_s +
         scenario.limits.min_cycles_after_recovery * walk.cycle_s();
}

batch::Trial trial_of(const Load& load, double seconds_to_judge) {
  return {{fmt::format("payload.0.mass_kg={}", load.mass_kg), fmt::format("payload.0.at_s={}", load.at_s),
           fmt::format("duration_s={}", load.at_s + seconds_to_judge)}};
}

batch::Batch batch_of(const Experiment& experiment, const std::vector<Load>& loads) {
  batch::Batch batch = batch_of(experiment);
  const double judged_s = seconds_to_judge(load_common(batch));
  for (const Load& load : loads) batch.trials.push_back(trial_of(load, judged_s));
  return batch;
}

}  // namespace surefoot::table
