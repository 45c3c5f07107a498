#include "tools/calibrate/calibration.hpp"

#include <algorithm>
#include <utility>

namespace surefoot::calibrate {

Search coarse_search() {
  return {{{0.08, 0.11, 0.14, 0.17, 0.2}, {0.1168, 0.1188, 0.1208, 0.1228, 0.1248}}, table::parse_list("0.2:4.8:0.2")};
}

Search fine_search() {
  return {{{0.08, 0.1, 0.11, 0.12, 0.14, 0.17, 0.2, 0.3}, table::parse_list("0.1148:0.1258:0.0005")},
          table::thesis_grid().times_s};
}

std::vector<PlantCount> count_plants(const table::Band& band) {
  std::vector<PlantCount> plants;
  auto cell = band.cells.begin();
  for (const double friction : band.frictions) {
    for (const double toe_m : band.toes_m) {
      PlantCount plant{friction, toe_m, band.grid.times_s.size(), 0, 0};
      for (std::size_t time = 0; time < band.grid.times_s.size(); ++time) {
        for (const double mass_kg : band.grid.masses_kg) {
          std::size_t& count = table::is_same(mass_kg, kLightKg) ? plant.light_survive : plant.heavy_survive;
          if (cell++->survives) ++count;
        }
      }
      plants.push_back(plant);
    }
  }
  return plants;
}

std::vector<Window> windows(const std::vector<PlantCount>& plants) {
  if (plants.empty()) return {};
  const std::size_t least = std::ranges::min(plants, {}, &PlantCount::differing).differing();
  std::vector<Window> found;
  Window row;
  const auto end_row = [&] {
    if (row.toes_m.empty()) return;
    const bool is_same_friction = !found.empty() && table::is_same(found.back().friction, row.friction);
    if (!is_same_friction) {
      found.push_back(row);
    } else if (row.toes_m.size() >= found.back().toes_m.size()) {
      found.back() = row;
    }
    row.toes_m.clear();
  };
  for (const PlantCount& plant : plants) {
    if (plant.differing() != least || !table::is_same(plant.friction, row.friction)) end_row();
    if (plant.differing() != least) continue;
    row.friction = plant.friction;
    row.differing = least;
    row.toes_m.push_back(plant.toe_m);
  }
  end_row();
  return found;
}

Window widest(const std::vector<Window>& windows) {
  return *std::ranges::max_element(
      windows, {}, [](const Window& window) { return std::pair(window.toes_m.size(), window.friction); });
}

bool Calibration::is_preset() const noexcept {
  return table::is_same(chosen.friction, preset.friction) && table::is_same(chosen.toe_m, preset.toe_m);
}

}  // namespace surefoot::calibrate
