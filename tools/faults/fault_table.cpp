#include "tools/faults/fault_table.hpp"

#include <fmt/format.h>

#include <mutex>
#include <nlohmann/json.hpp>

#include "tools/batch/parallel_for.hpp"

namespace surefoot::faults {
namespace {

using Json = nlohmann::ordered_json;

std::string cell(const TrialResult& result) {
  std::string text = result.fault == safety::Fault::kNone
                         ? "rides through"
                         : fmt::format("fault {}, {}, {} ticks", static_cast<int>(result.fault),
                                       safety::name(result.safe_state), result.answer_ticks.value_or(0));
  if (result.fell_after_s) text += fmt::format("; down after {:.1f} s", *result.fell_after_s);
  if (!result.command.is_within_gate) text += "; BEYOND THE GATE";
  return text;
}

template <class Value>
Json json_of(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}

}  // namespace

std::vector<FaultRow> try_all(const scenario::Scenario& scenario, const std::vector<CatalogueEntry>& entries,
                              const std::function<void(std::size_t, std::size_t)>& on_progress) {
  std::vector<FaultRow> rows;
  for (const CatalogueEntry& entry : entries) rows.push_back({entry, {}});
  const std::size_t all = rows.size() * kSituations.size();
  std::size_t done = 0;
  std::mutex mutex;
  batch::parallel_for(all, {}, [&](std::size_t trial) {
    FaultRow& row = rows[trial / kSituations.size()];
    const std::size_t situation = trial % kSituations.size();
    row.result[situation] = try_fault(scenario, kSituations[situation], row.entry.fault);
    const std::scoped_lock lock(mutex);
    on_progress(++done, all);
  });
  return rows;
}

std::string to_markdown(const std::vector<FaultRow>& rows) {
  std::string text = "| fault |";
  for (const Situation situation : kSituations) text += fmt::format(" {} |", name(situation));
  text += "\n| --- | --- | --- | --- |\n";
  for (const FaultRow& row : rows) {
    text += fmt::format("| {} |", row.entry.what);
    for (const TrialResult& result : row.result) text += fmt::format(" {} |", cell(result));
    text += '\n';
  }
  return text;
}

std::string to_json(const std::vector<FaultRow>& rows) {
  Json json = Json::array();
  for (const FaultRow& row : rows) {
    for (const Situation situation : kSituations) {
      const TrialResult& result = row.result[static_cast<std::size_t>(situation)];
      json.push_back({{"what", row.entry.what},
                      {"situation", name(situation)},
                      {"fault", static_cast<int>(result.fault)},
                      {"fault_name", safety::name(result.fault)},
                      {"safe_state", safety::name(result.safe_state)},
                      {"answer_ticks", json_of(result.answer_ticks)},
                      {"fell_after_s", json_of(result.fell_after_s)},
                      {"largest_torque_nm", result.command.torque_nm},
                      {"largest_torque_step_nm", result.command.torque_step_nm},
                      {"largest_angle_step_rad", result.command.angle_step_rad},
                      {"lowest_body_m", result.lowest_body_m},
                      {"is_within_gate", result.command.is_within_gate}});
    }
  }
  return json.dump(2) + "\n";
}

}  // namespace surefoot::faults
