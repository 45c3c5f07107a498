#pragma once

#include <nlohmann/json.hpp>

#include "sim_hw/plant_config.hpp"

namespace surefoot::robot_model {

/// A rectangle of floor, in the frame of its plane.
struct Extent {
  double from_x_m = -1.0;
  double to_x_m = 3.0;
  double from_y_m = -1.0;
  double to_y_m = 1.0;
};

/// Most tiles that one view lists: 12 m by 5 m of the usual ones of 3 cm.
inline constexpr double kMaxTiles = 70000.0;

/// The floor as something to draw: slopes, gravity in its frame, friction, each tile's and plate's place and height.
///
/// Tiles: a grid from (`x0_m`, `y0_m`) on, `nx` ahead by `ny` to the left, heights row by row along y; null where there
/// are none. Plates: scattered and listed ones, by centre, size, height and kind (`plate`, `ramp`, `friction`).
/// @throws std::invalid_argument when the extent holds more than `kMaxTiles` tiles
[[nodiscard]] nlohmann::ordered_json floor_json(const sim_hw::SimConfig&, const Extent&);

}  // namespace surefoot::robot_model
