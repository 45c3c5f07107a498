#include "tools/table/trigger_delays.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "firmware/core/decision/reflex_phase.hpp"

namespace surefoot::table {
namespace {

using Json = nlohmann::ordered_json;

std::optional<double> delay_of(const run::Verdict& verdict, double load_at_s) {
  for (const run::TimedEvent& event : verdict.events) {
    const bool is_seen = std::string_view(event.name) == decision::name(decision::ReflexEvent::kPayloadDetected) ||
                         std::string_view(event.name) == "payload_seen";  // what the method "off" does with it
    if (is_seen && event.time_s >= load_at_s) return event.time_s - load_at_s;
  }
  return std::nullopt;
}

std::string milliseconds(std::optional<double> delay_s) {
  return delay_s ? fmt::format("{:.1f}", 1e3 * *delay_s) : "-";
}

/// The delay of that load; nothing where the grid has it not, or it was not seen.
std::optional<double> delay_at(const TriggerDelays& study, const Load& wanted) {
  const std::vector<Load> loads = loads_of(study.grid);
  const auto found = std::ranges::find_if(loads, [&](const Load& load) {
    return is_same(load.at_s, wanted.at_s) && is_same(load.mass_kg, wanted.mass_kg);
  });
  return found == loads.end() ? std::nullopt : study.delays_s[static_cast<std::size_t>(found - loads.begin())];
}

std::string spread_of(const TriggerDelays& study, std::size_t mass) {
  std::vector<double> seen_s;
  for (std::size_t time = 0; time < study.grid.times_s.size(); ++time) {
    if (const auto delay_s = study.delays_s[study.grid.index(time, mass)]) seen_s.push_back(*delay_s);
  }
  std::ranges::sort(seen_s);
  const std::string load =
      fmt::format("  {:>5} kg: seen {} of {}", study.grid.masses_kg[mass], seen_s.size(), study.grid.times_s.size());
  if (seen_s.empty()) return load + "\n";
  return fmt::format("{}, after {} to {} ms, half of them within {} ms\n", load, milliseconds(seen_s.front()),
                     milliseconds(seen_s.back()), milliseconds(seen_s[(seen_s.size() - 1) / 2]));
}

}  // namespace

batch::Batch delay_batch(const Experiment& experiment, const Grid& grid) {
  batch::Batch batch = batch_of(experiment);
  for (const Load& load : loads_of(grid)) batch.trials.push_back(trial_of(load, kLongestDelay_s));
  return batch;
}

TriggerDelays delays_of(const Experiment& experiment, const Grid& grid, const std::vector<run::Verdict>& verdicts) {
  TriggerDelays study{experiment.method, experiment.plant, grid, {}};
  const std::vector<Load> loads = loads_of(grid);
  for (std::size_t i = 0; i < loads.size(); ++i) study.delays_s.push_back(delay_of(verdicts.at(i), loads[i].at_s));
  return study;
}

std::string delay_text(const TriggerDelays& study) {
  std::string text = "  load at   seen after, ms; load in kg\n          ";
  for (const double mass_kg : study.grid.masses_kg) text += fmt::format("{:>7} ", mass_kg);
  text += "\n";
  for (std::size_t time = 0; time < study.grid.times_s.size(); ++time) {
    text += fmt::format("  {:>5} s ", study.grid.times_s[time]);
    for (std::size_t mass = 0; mass < study.grid.masses_kg.size(); ++mass) {
      text += fmt::format(" {:>7}", milliseconds(study.delays_s[study.grid.index(time, mass)]));
    }
    text += "\n";
  }
  for (std::size_t mass = 0; mass < study.grid.masses_kg.size(); ++mass) text += spread_of(study, mass);
  for (const PrintedDelay& printed : kThesisDelays) {
    text += fmt::format("  {:>5} kg at {} s: thesis {} ms, here {} ms\n", printed.load.mass_kg, printed.load.at_s,
                        milliseconds(printed.delay_s), milliseconds(delay_at(study, printed.load)));
  }
  return text;
}

std::string delay_csv(const TriggerDelays& study) {
  std::string text = "load_time_s,mass_kg,delay_s\n";
  const std::vector<Load> loads = loads_of(study.grid);
  for (std::size_t i = 0; i < loads.size(); ++i) {
    text += fmt::format("{},{},{}\n", loads[i].at_s, loads[i].mass_kg,
                        study.delays_s[i] ? fmt::format("{:.4f}", *study.delays_s[i]) : "");
  }
  return text;
}

std::string to_json(const TriggerDelays& study) {
  Json delays = Json::array();
  const std::vector<Load> loads = loads_of(study.grid);
  for (std::size_t i = 0; i < loads.size(); ++i) {
    delays.push_back({{"load_time_s", loads[i].at_s},
                      {"mass_kg", loads[i].mass_kg},
                      {"delay_s", study.delays_s[i] ? Json(*study.delays_s[i]) : Json(nullptr)}});
  }
  Json printed = Json::array();
  for (const PrintedDelay& thesis : kThesisDelays) {
    printed.push_back(
        {{"load_time_s", thesis.load.at_s}, {"mass_kg", thesis.load.mass_kg}, {"delay_s", thesis.delay_s}});
  }
  return Json{{"picture", "trigger_delays"},
              {"method", study.method},
              {"plant", study.plant},
              {"load_times_s", study.grid.times_s},
              {"masses_kg", study.grid.masses_kg},
              {"longest_delay_s", kLongestDelay_s},
              {"delays", delays},
              {"thesis", printed}}
             .dump(2) +
         "\n";
}

}  // namespace surefoot::table
