#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tools/table/band.hpp"
#include "tools/table/table.hpp"

namespace surefoot::calibrate {

/// The two loads between which the thesis' Table 4.1 divides: with the reflex off the first is survived at every
/// instant, the second at none.
inline constexpr double kLightKg = 2.5;
inline constexpr double kHeavyKg = 5.0;

/// Which plants are tried, and at which instants of the load.
struct Search {
  table::BandAxes axes;
  std::vector<double> times_s;

  [[nodiscard]] table::Grid grid() const { return {times_s, {kLightKg, kHeavyKg}}; }
};

/// Every other instant of the thesis; toes 2 mm apart.
[[nodiscard]] Search coarse_search();

/// Every instant; toes 0.5 mm apart, more frictions.
[[nodiscard]] Search fine_search();

/// What one plant survives without a reflex.
struct PlantCount {
  double friction = 0.0;
  double toe_m = 0.0;
  std::size_t instants = 0;
  std::size_t light_survive = 0;  ///< of the instants, with `kLightKg`
  std::size_t heavy_survive = 0;  ///< of the instants, with `kHeavyKg`

  /// Cells that are not as the thesis prints them.
  [[nodiscard]] std::size_t differing() const noexcept { return instants - light_survive + heavy_survive; }
};

/// In the band's order: by friction, then by toe.
/// @param band  with a grid as `Search::grid` gives it
[[nodiscard]] std::vector<PlantCount> count_plants(const table::Band& band);

/// Neighbouring toe lengths at one friction.
struct Window {
  double friction = 0.0;
  std::vector<double> toes_m;  ///< ascending
  std::size_t differing = 0;   ///< cells of each of its plants that are not as the thesis prints them
};

/// For each friction the longest row of toes whose plants differ from the thesis in the least number of cells that any
/// plant does; of equals that with the longer toes. Frictions without such a plant have none.
/// @param plants  in the order of `count_plants`
[[nodiscard]] std::vector<Window> windows(const std::vector<PlantCount>& plants);

/// The window to choose from: the one with the most toes; of several such that with the most friction.
/// @param windows  at least one
[[nodiscard]] Window widest(const std::vector<Window>& windows);

/// One plant, tried again with half the physics step.
struct HalvedStep {
  double toe_m = 0.0;
  std::size_t changed = 0;  ///< cells with another verdict
};

/// A whole table of the thesis on one plant.
struct WholeTable {
  double friction = 0.0;
  double toe_m = 0.0;
  std::size_t cells = 0;
  std::size_t survive = 0;
  std::size_t differing = 0;           ///< from Table 4.1
  std::size_t changed_by_halving = 0;  ///< cells with another verdict at half the physics step
};

/// What a calibration found.
struct Calibration {
  Search search;
  std::vector<PlantCount> plants;
  std::vector<Window> windows;
  Window window;                   ///< the widest
  std::vector<HalvedStep> halved;  ///< its toes from the longest down, until one that changed nothing
  WholeTable chosen;
  WholeTable preset;  ///< the plant `thesis` as it is set

  [[nodiscard]] bool is_preset() const noexcept;
};

[[nodiscard]] std::string to_text(const Calibration& calibration);
[[nodiscard]] std::string to_csv(const Calibration& calibration);
[[nodiscard]] std::string to_json(const Calibration& calibration);

}  // namespace surefoot::calibrate
