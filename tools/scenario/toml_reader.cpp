#include "tools/scenario/toml_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "tools/scenario/checks.hpp"
#include "tools/scenario/field_reader.hpp"
#include "tools/scenario/field_table.hpp"
#include "tools/scenario/preset.hpp"

namespace surefoot::scenario {
namespace {

class Reader : private FieldReader {
 public:
  explicit Reader(const Document& document) : FieldReader(document, "surefoot keys shows every key") {
    const auto text = [&document](const char* key, const std::string& otherwise) {
      return document.root.at_path(key).value_or(otherwise);
    };
    PresetNames names;
    names.robot = text("robot", names.robot);
    names.plant = text("plant", names.plant);
    names.controllers = text("stabilizer.set", names.controllers);
    names.reflex = text("reflex.method", names.reflex);
    const toml::array* gaits = document.root["planned_gait"].as_array();
    names.has_planned_gaits = gaits != nullptr && !gaits->empty();
    defaults_ = preset(names);
    scenario_ = defaults_;
    know(fields(scenario_), {"payload", "push", "patch", "fault", "planned_gait"});
  }

  Scenario read() {
    read_table(document().root, "", fields(scenario_), fields(defaults_));
    if (!was_given("drive.torque_limit_nm")) {
      scenario_.sim.drive.torque_limit_nm = scenario_.firmware.gate.torque_limit_nm;
    }
    share_numbers(scenario_);
    for (const Finding& finding : check_ranges(scenario_)) report(finding);
    report_unless_known_bad(check_relations(scenario_));
    throw_problems();
    std::stable_sort(scenario_.sim.payloads.begin(), scenario_.sim.payloads.end(),
                     [](const auto& a, const auto& b) { return a.at_s < b.at_s; });
    return std::move(scenario_);
  }

 private:
  bool read_other(const std::string& key, const toml::node& node) override {
    if (!is_array_of_tables(key)) return false;
    if (key == "payload") read_elements(key, node, scenario_.sim.payloads, kMaxPayloads);
    if (key == "push") read_elements(key, node, scenario_.sim.pushes, sim_hw::kMaxPushes);
    if (key == "patch") read_elements(key, node, scenario_.sim.terrain.patches, sim_hw::kMaxPatches);
    if (key == "planned_gait") read_elements(key, node, scenario_.gaits, kMaxPlannedGaits);
    if (key == "fault") read_elements(key, node, scenario_.sim.faults, sim_hw::kMaxFaults);
    return true;
  }

  /// Reads an array of tables; one element too many is kept for the check of their number.
  template <typename Element>
  void read_elements(const std::string& array_name, const toml::node& node, std::vector<Element>& elements,
                     std::size_t max) {
    const std::string remedy =
        fmt::format("write [[{0}]] on a line of its own and its keys below, once for each {0}", array_name);
    const toml::array* array = node.as_array();
    if (array == nullptr) {
      add(place_of(array_name, node.source().begin),
          fmt::format("{} is {}; expected an array of tables", array_name, shown_with_type(node)), remedy);
      return;
    }
    elements.resize(std::min(array->size(), max + 1));
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const toml::node& element = (*array)[i];
      if (const toml::table* table = element.as_table()) {
        Element default_element;
        read_element(array_name, i, *table, fields(elements[i]), fields(default_element));
      } else {
        const std::string key = fmt::format("{}[{}]", array_name, i);
        add(place_of(key, element.source().begin),
            fmt::format("{} is {}; expected a table", key, shown_with_type(element)), remedy);
      }
    }
  }

  void read_element(const std::string& array_name, std::size_t index, const toml::table& table,
                    const std::vector<Field>& known, const std::vector<Field>& defaults) {
    for (const auto& [name, node] : table) {
      const std::string key = element_key(array_name, index, name.str());
      if (read_field(name.str(), key, node, known, defaults)) continue;
      std::vector<std::string> names;
      for (const Field& candidate : known) names.push_back(element_key(array_name, index, candidate.key));
      report_unknown(key, place_of(key, name.source().begin), names);
    }
  }

  Scenario defaults_;
  Scenario scenario_;
};

}  // namespace

Scenario read_scenario(const Document& document) { return Reader(document).read(); }

}  // namespace surefoot::scenario
