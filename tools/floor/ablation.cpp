#include "tools/floor/ablation.hpp"

#include "firmware/core/stabilizer/stabilizer.hpp"
#include "tools/floor/floor_cases.hpp"

namespace surefoot::floor {

Ablation planned(const AblationSpec& spec) {
  Ablation plan{spec, {{"off", {"stabilizer.set=off"}, {}}}};
  const stabilizer::Switches set = spec.set == "paper" ? stabilizer::paper_set() : stabilizer::extended_set();
  for (const stabilizer::ActivationRow& row : stabilizer::kActivation) {
    const std::string controller = stabilizer::name(row.controller);
    plan.rows.push_back({controller + " alone", {"stabilizer.set=off", "stabilizer." + controller + "=true"}, {}});
  }
  plan.rows.push_back({spec.set, {"stabilizer.set=" + spec.set}, {}});
  for (const stabilizer::ActivationRow& row : stabilizer::kActivation) {
    if (!set[static_cast<std::size_t>(row.controller)]) continue;
    const std::string controller = stabilizer::name(row.controller);
    plan.rows.push_back({spec.set + " without " + controller,
                         {"stabilizer.set=" + spec.set, "stabilizer." + controller + "=false"},
                         {}});
  }
  return plan;
}

batch::Batch ablation_batch(const Ablation& plan, const batch::Batch& base) {
  batch::Batch batch = base;
  for (const AblationRow& row : plan.rows) {
    for (const std::uint64_t seed : plan.spec.seeds) {
      batch::Trial trial{overrides_of(FloorCase::kBoth, plan.spec.slope_deg, seed, plan.spec.duration_s)};
      trial.overrides.insert(trial.overrides.end(), row.overrides.begin(), row.overrides.end());
      batch.trials.push_back(trial);
    }
  }
  return batch;
}

Ablation ablation_of(Ablation plan, const std::vector<run::Verdict>& verdicts) {
  std::span<const run::Verdict> rest = verdicts;
  for (AblationRow& row : plan.rows) {
    row.summary = summary_of(rest.first(plan.spec.seeds.size()));
    rest = rest.subspan(plan.spec.seeds.size());
  }
  return plan;
}

}  // namespace surefoot::floor
