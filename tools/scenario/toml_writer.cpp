#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "tools/scenario/field_builders.hpp"
#include "tools/scenario/field_table.hpp"
#include "tools/scenario/preset.hpp"

namespace surefoot::scenario {
namespace {

std::string table_of(const std::string& key) {
  const std::size_t dot = key.find('.');
  return dot == std::string::npos ? "" : key.substr(0, dot);
}

std::string name_in_table(const std::string& key) { return key.substr(key.find('.') + 1); }

/// What stands behind a key as a comment: its meaning and its limits.
std::string comment(const Field& field) {
  if (std::holds_alternative<bool*>(field.target)) return field.doc;
  const bool is_choice = std::holds_alternative<Choice>(field.target);
  return field.doc + ": " + (is_choice ? expectation(field) : range_text(field));
}

void write_line(std::string& text, const Field& field) {
  fmt::format_to(std::back_inserter(text), "{} = {}  # {}\n", name_in_table(field.key), value_text(field),
                 comment(field));
}

void describe(std::string& text, const std::string& key, const Field& field) { text += description(key, field); }

/// The keys that the other robot has beside all of these.
void describe_khr2_keys(std::string& text, std::string& table) {
  Scenario khr2 = preset({.robot = "khr2"});
  std::vector<Field> its_own;
  append_floor_walk_fields(its_own, khr2);
  text +=
      "\nWith robot = \"khr2\" or a [[planned_gait]] alone; khr2 also has other defaults above (its effective scenario "
      "shows them):\n";
  for (const Field& field : its_own) {
    if (table_of(field.key) != table) {
      table = table_of(field.key);
      text += "\n[" + table + "]\n";
    }
    describe(text, field.key, field);
  }
}

}  // namespace

std::string to_toml(const Scenario& scenario) {
  Scenario written = scenario;
  std::string text = "# The effective scenario: every key, with its meaning and limits.\n";
  std::string table;
  if (written.sim.payloads.empty()) text += "payload = []\n";
  if (written.sim.pushes.empty()) text += "push = []\n";
  if (written.sim.terrain.patches.empty()) text += "patch = []\n";
  if (written.sim.faults.empty()) text += "fault = []\n";
  if (written.gaits.empty()) text += "planned_gait = []\n";
  for (const Field& field : fields(written)) {
    if (table_of(field.key) != table) {
      table = table_of(field.key);
      text += "\n[" + table + "]\n";
    }
    write_line(text, field);
  }
  for (sim_hw::PayloadConfig& payload : written.sim.payloads) {
    text += "\n[[payload]]\n";
    for (const Field& field : fields(payload)) write_line(text, field);
  }
  for (sim_hw::PushConfig& push : written.sim.pushes) {
    text += "\n[[push]]\n";
    for (const Field& field : fields(push)) write_line(text, field);
  }
  for (sim_hw::PatchConfig& patch : written.sim.terrain.patches) {
    text += "\n[[patch]]\n";
    for (const Field& field : fields(patch)) write_line(text, field);
  }
  for (sim_hw::FaultConfig& fault : written.sim.faults) {
    text += "\n[[fault]]\n";
    for (const Field& field : fields(fault)) write_line(text, field);
  }
  for (PlannedGaitConfig& gait : written.gaits) {
    text += "\n[[planned_gait]]\n";
    for (const Field& field : fields(gait)) write_line(text, field);
  }
  return text;
}

std::string describe_keys() {
  Scenario defaults = preset({});
  std::string text =
      "Keys of a scenario file, and of --set KEY=VALUE. Defaults are those of the plant \"thesis\";\n"
      "the plant \"nominal\" has a longer sole and more friction.\n";
  std::string table;
  for (const Field& field : fields(defaults)) {
    if (table_of(field.key) != table) {
      table = table_of(field.key);
      text += "\n[" + table + "]\n";
    }
    describe(text, field.key, field);
  }
  describe_khr2_keys(text, table);
  sim_hw::PayloadConfig payload;
  text += fmt::format(
      "\n[[payload]], up to {} of them; --set payload.0.mass_kg=5 changes the first, payload=[] removes all\n",
      kMaxPayloads);
  for (const Field& field : fields(payload)) describe(text, "payload.N." + field.key, field);
  sim_hw::PushConfig push;
  text += fmt::format("\n[[push]], up to {} of them; --set push.0.force_n=[0,200,0] and so on, as with payloads\n",
                      sim_hw::kMaxPushes);
  for (const Field& field : fields(push)) describe(text, "push.N." + field.key, field);
  sim_hw::PatchConfig patch;
  text += fmt::format("\n[[patch]], up to {} of them; --set patch.0.kind=ramp and so on, as with payloads\n",
                      sim_hw::kMaxPatches);
  for (const Field& field : fields(patch)) describe(text, "patch.N." + field.key, field);
  sim_hw::FaultConfig fault;
  text += fmt::format("\n[[fault]], up to {} of them; --set fault.0.kind=corrupt and so on, as with payloads\n",
                      sim_hw::kMaxFaults);
  for (const Field& field : fields(fault)) describe(text, "fault.N." + field.key, field);
  PlannedGaitConfig gait;
  text += fmt::format(
      "\n[[planned_gait]], up to {} of them, walked one after the other by either robot; surefoot plan writes them\n",
      kMaxPlannedGaits);
  for (const Field& field : fields(gait)) describe(text, "planned_gait.N." + field.key, field);
  return text;
}

}  // namespace surefoot::scenario
