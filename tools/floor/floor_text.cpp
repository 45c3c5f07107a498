#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "tools/floor/ablation.hpp"
#include "tools/floor/floor_table.hpp"

namespace surefoot::floor {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kLegend =
    "largest angle of the torso against the vertical, degrees: mean (worst) of the runs that did not fall";

std::string falls_text(const Summary& summary) { return fmt::format("{} of {}", summary.falls, summary.runs); }

}  // namespace

std::string floor_text(const FloorTable& table) {
  std::string text = fmt::format(
      "KHR-2: on the spot for {:g} s, in the room with steps of 20 cm for {:g} s; {}\n"
      "  {:<11}  {:<6}  {:>10}  {:>8}  {:>13}  {:>13}  paper's roll\n",
      table.spec.duration_s, kRoomWalk_s, kLegend, "controllers", "floor", "slope, deg", "falls", "roll", "pitch");
  for (const FloorRow& row : table.rows) {
    const Summary& summary = row.summary;
    const char* printed = printed_in_paper(row.set, row.floor);
    text += fmt::format("  {:<11}  {:<6}  {:>10g}  {:>8}  {:>13}  {:>13}  {}\n", row.set, name(row.floor),
                        row.slope_deg, falls_text(summary), text_of(summary, summary.roll),
                        text_of(summary, summary.pitch), *printed == '\0' ? "-" : printed);
  }
  for (const FloorRow& row : table.rows) {
    if (row.floor != FloorCase::kRoom || row.summary.all_fell()) continue;
    text += fmt::format("In the room {} walks at least {:.1f} m where it does not fall.\n", row.set,
                        row.summary.shortest_way_m);
  }
  return text + "The paper: pitch below roll in every case; flat practically the same with and without.\n";
}

std::string floor_csv(const FloorTable& table) {
  std::string text = fmt::format("controllers,floor,slope_deg,{},paper_roll_deg\n", csv_header());
  for (const FloorRow& row : table.rows) {
    text += fmt::format("{},{},{},{},{}\n", row.set, name(row.floor), row.slope_deg, csv_of(row.summary),
                        printed_in_paper(row.set, row.floor));
  }
  return text;
}

std::string to_json(const FloorTable& table) {
  Json rows = Json::array();
  for (const FloorRow& row : table.rows) {
    Json json{{"controllers", row.set}, {"floor", name(row.floor)}, {"slope_deg", row.slope_deg}};
    json.update(json_of(row.summary));
    json["paper_roll_deg"] = printed_in_paper(row.set, row.floor);
    rows.push_back(json);
  }
  return Json{{"duration_s", table.spec.duration_s},
              {"room_duration_s", kRoomWalk_s},
              {"seeds", table.spec.seeds},
              {"rows", rows}}
             .dump(2) +
         "\n";
}

std::string ablation_text(const Ablation& ablation) {
  const AblationSpec& spec = ablation.spec;
  std::string text = fmt::format(
      "KHR-2 on the spot for {:g} s, tiles on a slope of {:g} degrees; {}\n  {:<38}  {:>8}  {:>13}  {:>13}\n",
      spec.duration_s, spec.slope_deg, kLegend, "controllers", "falls", "roll", "pitch");
  for (const AblationRow& row : ablation.rows) {
    text += fmt::format("  {:<38}  {:>8}  {:>13}  {:>13}\n", row.what, falls_text(row.summary),
                        text_of(row.summary, row.summary.roll), text_of(row.summary, row.summary.pitch));
  }
  return text;
}

std::string ablation_csv(const Ablation& ablation) {
  std::string text = fmt::format("controllers,{}\n", csv_header());
  for (const AblationRow& row : ablation.rows) text += fmt::format("{},{}\n", row.what, csv_of(row.summary));
  return text;
}

std::string to_json(const Ablation& ablation) {
  Json rows = Json::array();
  for (const AblationRow& row : ablation.rows) {
    Json json{{"controllers", row.what}};
    json.update(json_of(row.summary));
    rows.push_back(json);
  }
  const AblationSpec& spec = ablation.spec;
  return Json{{"set", spec.set},
              {"slope_deg", spec.slope_deg},
              {"duration_s", spec.duration_s},
              {"seeds", spec.seeds},
              {"rows", rows}}
             .dump(2) +
         "\n";
}

}  // namespace surefoot::floor
