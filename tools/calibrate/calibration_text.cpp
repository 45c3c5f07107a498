#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "tools/calibrate/calibration.hpp"

namespace surefoot::calibrate {
namespace {

using Json = nlohmann::ordered_json;

double mm(double metres) { return 1e3 * metres; }

std::string describe(const WholeTable& whole) {
  return fmt::format(
      "friction {:g}, toe {:g} mm: {} of {} cells survive, {} differ from Table 4.1; half the step changes {}\n",
      whole.friction, mm(whole.toe_m), whole.survive, whole.cells, whole.differing, whole.changed_by_halving);
}

std::string matrix(const Calibration& calibration) {
  std::string text = fmt::format("  {:>8}", "friction");
  for (const double toe_m : calibration.search.axes.toes_m)
    text += fmt::format(" {:>8}", fmt::format("{:g} mm", mm(toe_m)));
  double friction = -1.0;
  for (const PlantCount& plant : calibration.plants) {
    if (!table::is_same(plant.friction, friction)) text += fmt::format("\n  {:>8g}", plant.friction);
    friction = plant.friction;
    text += fmt::format(" {:>8}", fmt::format("{}/{}", plant.light_survive, plant.heavy_survive));
  }
  return text + "\n";
}

Json json_of(const WholeTable& whole) {
  return {{"friction", whole.friction},   {"sole_toe_m", whole.toe_m},
          {"cells", whole.cells},         {"survive", whole.survive},
          {"differing", whole.differing}, {"changed_by_halving_step", whole.changed_by_halving}};
}

}  // namespace

std::string to_text(const Calibration& calibration) {
  std::string text = fmt::format(
      "reflex off: of {} instants, survived with {:g} kg / with {:g} kg (Table 4.1: all / none), by friction and toe\n",
      calibration.search.times_s.size(), kLightKg, kHeavyKg);
  text += matrix(calibration) + fmt::format("plants that differ least, in {} cells\n", calibration.window.differing);
  for (const Window& window : calibration.windows) {
    text += fmt::format("  friction {:g}: toe {:g} to {:g} mm\n", window.friction, mm(window.toes_m.front()),
                        mm(window.toes_m.back()));
  }
  text +=
      fmt::format("half the physics step at friction {:g}, from the longest toe down\n", calibration.window.friction);
  for (const HalvedStep& halved : calibration.halved) {
    text += fmt::format("  toe {:g} mm: {} verdicts change\n", mm(halved.toe_m), halved.changed);
  }
  text +=
      "choice: the widest window, of several such that with the most friction; there the longest toe at which half "
      "the\n"
      "step changes no verdict, for a reflex needs the toe\n  " +
      describe(calibration.chosen);
  if (calibration.is_preset()) return text + "  this is the plant `thesis` as it is set\n";
  return text + "  the plant `thesis` is set otherwise:\n  " + describe(calibration.preset);
}

std::string to_csv(const Calibration& calibration) {
  std::string text = "friction,toe_m,instants,light_survive,heavy_survive,differing\n";
  for (const PlantCount& plant : calibration.plants) {
    text += fmt::format("{},{},{},{},{},{}\n", plant.friction, plant.toe_m, plant.instants, plant.light_survive,
                        plant.heavy_survive, plant.differing());
  }
  return text;
}

std::string to_json(const Calibration& calibration) {
  Json plants = Json::array();
  for (const PlantCount& plant : calibration.plants) {
    plants.push_back({{"friction", plant.friction},
                      {"sole_toe_m", plant.toe_m},
                      {"instants", plant.instants},
                      {"light_survive", plant.light_survive},
                      {"heavy_survive", plant.heavy_survive},
                      {"differing", plant.differing()}});
  }
  Json windows = Json::array();
  for (const Window& window : calibration.windows) {
    windows.push_back({{"friction", window.friction}, {"sole_toe_m", window.toes_m}, {"differing", window.differing}});
  }
  Json halved = Json::array();
  for (const HalvedStep& one : calibration.halved) {
    halved.push_back({{"sole_toe_m", one.toe_m}, {"changed", one.changed}});
  }
  const Json json{{"light_kg", kLightKg},
                  {"heavy_kg", kHeavyKg},
                  {"load_times_s", calibration.search.times_s},
                  {"plants", plants},
                  {"windows", windows},
                  {"halved_step", halved},
                  {"chosen", json_of(calibration.chosen)},
                  {"preset", json_of(calibration.preset)},
                  {"is_preset", calibration.is_preset()}};
  return json.dump(2) + "\n";
}

}  // namespace surefoot::calibrate
