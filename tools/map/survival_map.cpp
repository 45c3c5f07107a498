#include "tools/map/survival_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <string_view>

#include "tools/map/map_spec.hpp"
#include "tools/scenario/scenario.hpp"
#include "tools/table/experiment.hpp"

namespace surefoot::map {
namespace {

constexpr std::size_t kMostRuns = 1'000'000;

/// Labels of one run, to stand for {column}, {row} and {repeat}.
struct Labels {
  const std::string& column;
  const std::string& row;
  const std::string& repeat;
};

void replace_all(std::string& text, std::string_view name, const std::string& label) {
  for (std::size_t at = 0; (at = text.find(name, at)) != std::string::npos; at += label.size()) {
    text.replace(at, name.size(), label);
  }
}

std::string filled_in(std::string text, const Labels& labels) {
  replace_all(text, "{column}", labels.column);
  replace_all(text, "{row}", labels.row);
  replace_all(text, "{repeat}", labels.repeat);
  return text;
}

/// When the last load, removal or push is over.
double last_disturbance_s(const scenario::Scenario& scenario) {
  double last_s = 0.0;
  for (const sim_hw::PayloadConfig& payload : scenario.sim.payloads) {
    const bool is_removed = payload.removed_at_s != sim_hw::kNever_s;
    last_s = std::max(last_s, is_removed ? payload.removed_at_s : payload.at_s);
  }
  for (const sim_hw::PushConfig& push : scenario.sim.pushes) last_s = std::max(last_s, push.at_s + push.duration_s);
  return last_s;
}

batch::Trial trial_of(const MapSpec& spec, const batch::Batch& base, const std::string& method,
                      const std::vector<const AxisValue*>& values) {
  const Labels labels{values[0]->label, values[1]->label, values[2]->label};
  batch::Trial trial{{spec.method_key + "=" + method}};
  for (const std::string& text : spec.set) trial.overrides.push_back(filled_in(text, labels));
  for (const AxisValue* value : values) {
    for (const std::string& text : value->overrides) trial.overrides.push_back(filled_in(text, labels));
  }
  const bool has_duration =
      std::ranges::any_of(trial.overrides, [](const std::string& text) { return text.starts_with("duration_s="); });
  if (!has_duration) {
    batch::Batch alone = base;
    alone.common.insert(alone.common.end(), trial.overrides.begin(), trial.overrides.end());
    const scenario::Scenario scenario = table::load_common(alone);
    trial.overrides.push_back(
        fmt::format("duration_s={}", last_disturbance_s(scenario) + table::seconds_to_judge(scenario)));
  }
  return trial;
}

}  // namespace

std::size_t SurvivalMap::total(std::size_t method) const {
  const auto cells = static_cast<std::ptrdiff_t>(spec.rows.values.size() * spec.columns.values.size());
  const auto begin = survive.begin() + static_cast<std::ptrdiff_t>(method) * cells;
  return std::accumulate(begin, begin + cells, std::size_t{0});
}

batch::Batch map_batch(const MapSpec& spec, const batch::Batch& base) {
  const std::size_t runs =
      spec.methods.size() * spec.rows.values.size() * spec.columns.values.size() * spec.repeats.values.size();
  if (runs > kMostRuns) {
    throw BadSpec(
        fmt::format("{}: {} runs are more than {}\n  remedy: fewer values in its axes", spec.title, runs, kMostRuns));
  }
  batch::Batch batch = base;
  for (const std::string& method : spec.methods) {
    for (const AxisValue& row : spec.rows.values) {
      for (const AxisValue& column : spec.columns.values) {
        for (const AxisValue& repeat : spec.repeats.values) {
          batch.trials.push_back(trial_of(spec, base, method, {&column, &row, &repeat}));
        }
      }
    }
  }
  return batch;
}

SurvivalMap map_of(const MapSpec& spec, const std::string& plant, const std::vector<run::Verdict>& verdicts) {
  SurvivalMap map{spec, plant, {}};
  const std::size_t repeats = spec.repeats.values.size();
  for (std::size_t begin = 0; begin + repeats <= verdicts.size(); begin += repeats) {
    const auto first = verdicts.begin() + static_cast<std::ptrdiff_t>(begin);
    map.survive.push_back(
        static_cast<std::size_t>(std::count_if(first, first + static_cast<std::ptrdiff_t>(repeats),
                                               [](const auto& v) { return v.outcome == run::Outcome::kWalked; })));
  }
  return map;
}

}  // namespace surefoot::map
