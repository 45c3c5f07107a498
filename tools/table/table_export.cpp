#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "tools/table/band.hpp"
#include "tools/table/random_table.hpp"
#include "tools/table/table_text.hpp"

namespace surefoot::table {
namespace {

using Json = nlohmann::ordered_json;

std::optional<bool> printed_in(const std::optional<Reference>& reference, const Load& load) {
  return reference ? reference->at(load.at_s, load.mass_kg) : std::nullopt;
}

template <typename Value>
Json json_of(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json json_of(const Fall& fall) {
  return {{"direction", name(fall.direction)},
          {"after_load_s", fall.after_load_s},
          {"after_trigger_s", json_of(fall.after_trigger_s)},
          {"phase", fall.phase}};
}

Json json_of(const SymmetryCheck& check) {
  Json breaches = Json::array();
  for (const SymmetryBreach& breach : check.breaches) {
    breaches.push_back({{"mass_kg", breach.mass_kg},
                        {"early_s", breach.early_s},
                        {"late_s", breach.late_s},
                        {"early_survives", breach.early_survives}});
  }
  return {{"pairs", check.pairs}, {"breaches", breaches}};
}

Json json_of(const std::vector<Load>& loads, const std::vector<Cell>& cells,
             const std::optional<Reference>& reference) {
  Json list = Json::array();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    list.push_back({{"load_time_s", loads[i].at_s},
                    {"mass_kg", loads[i].mass_kg},
                    {"survives", cells[i].survives},
                    {"outcome", run::name(cells[i].outcome)},
                    {"reference", json_of(printed_in(reference, loads[i]))},
                    {"fall", cells[i].fall ? json_of(*cells[i].fall) : Json(nullptr)}});
  }
  return list;
}

}  // namespace

std::string to_csv(const std::vector<Load>& loads, const std::vector<Cell>& cells,
                   const std::optional<Reference>& reference) {
  std::string text = "load_time_s,mass_kg,survives,outcome,reference,direction,after_load_s,after_trigger_s,phase\n";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell& cell = cells[i];
    const std::optional<bool> printed = printed_in(reference, loads[i]);
    text += fmt::format("{},{},{:d},{},{}", loads[i].at_s, loads[i].mass_kg, cell.survives, run::name(cell.outcome),
                        printed ? fmt::format("{:d}", *printed) : "");
    if (cell.fall) {
      text += fmt::format(",{},{:.3f},{},{}\n", name(cell.fall->direction), cell.fall->after_load_s,
                          cell.fall->after_trigger_s ? fmt::format("{:.3f}", *cell.fall->after_trigger_s) : "",
                          cell.fall->phase);
    } else {
      text += ",,,,\n";
    }
  }
  return text;
}

std::string to_json(const Table& table, const std::optional<Reference>& reference, double half_cycle_s) {
  Json json{{"picture", "table"},
            {"method", table.method},
            {"plant", table.plant},
            {"load_times_s", table.grid.times_s},
            {"masses_kg", table.grid.masses_kg},
            {"survive", survivors(table.cells)},
            {"of", table.cells.size()},
            {"reference", nullptr},
            {"symmetry", json_of(check_symmetry(table, half_cycle_s))},
            {"cells", json_of(loads_of(table.grid), table.cells, reference)}};
  if (reference) {
    const Comparison sums = compare(table, *reference);
    json["reference"] = {{"name", reference->name},
                         {"printed", sums.printed},
                         {"survive", sums.survive_printed},
                         {"differ", sums.differing()},
                         {"only_survive_here", sums.only_survive_here},
                         {"only_survive_there", sums.only_survive_there}};
  }
  return json.dump(2) + "\n";
}

std::string to_json(const RandomTable& table) {
  return Json{{"picture", "random_loads"},
              {"method", table.method},
              {"plant", table.plant},
              {"seed", table.seed},
              {"survive", survivors(table.cells)},
              {"of", table.cells.size()},
              {"cells", json_of(table.loads, table.cells, {})}}
             .dump(2) +
         "\n";
}

std::string to_json(const Band& band) {
  Json counts = Json::array();
  for (std::size_t friction = 0; friction < band.frictions.size(); ++friction) {
    for (std::size_t toe = 0; toe < band.toes_m.size(); ++toe) {
      counts.push_back({{"friction", band.frictions[friction]},
                        {"toe_m", band.toes_m[toe]},
                        {"survive", band.survive(friction, toe)}});
    }
  }
  return Json{{"picture", "band"},
              {"method", band.method},
              {"plant", band.plant},
              {"frictions", band.frictions},
              {"toes_m", band.toes_m},
              {"load_times_s", band.grid.times_s},
              {"masses_kg", band.grid.masses_kg},
              {"of", band.grid.size()},
              {"counts", counts}}
             .dump(2) +
         "\n";
}

}  // namespace surefoot::table
