#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "sim_hw/plant_config.hpp"

namespace surefoot::sim_hw {

/// The floor's surface at one place, in the frame of its plane.
struct Surface {
  double height_m = 0.0;
  double slope_x = 0.0;  ///< rise for each metre ahead
};

/// A square of a grid, counted from the origin; negative ones lie behind it or to its right.
struct GridCell {
  std::int64_t x = 0;
  std::int64_t y = 0;
};

/// The rough floor: tiles, and on top of them scattered plates and the listed patches. A pure function of the
/// configuration: each tile's height and each plate is drawn from the seed and the place alone, so that the floor has
/// no bounds and needs no memory.
///
/// Plates and patches raise the tile under them; where several lie, the highest counts. Friction is that of the last
/// patch in the list that lies there and has one, else the floor's.
class Terrain {
 public:
  /// @param friction  of the floor without patches
  Terrain(const TerrainConfig&, double friction);

  /// Whether the surface is the plane itself, of one height and friction.
  [[nodiscard]] bool is_plane() const noexcept { return is_plane_; }
  [[nodiscard]] bool has_tiles() const noexcept { return config_.tile_height_m > 0.0; }

  /// The surface at this place; exactly zero where the floor is a plane, and farther away than 10^9 m.
  [[nodiscard]] Surface at(double x_m, double y_m) const noexcept;
  [[nodiscard]] double height_m(double x_m, double y_m) const noexcept { return at(x_m, y_m).height_m; }
  [[nodiscard]] double friction(double x_m, double y_m) const noexcept;

  // What the surface is made of.
  [[nodiscard]] const TerrainConfig& config() const noexcept { return config_; }
  /// From 0 to `tile_height_m`, uniformly; of the tile from x to x + 1 edges ahead and y to y + 1 to the left.
  [[nodiscard]] double tile_height_m(GridCell tile) const noexcept;
  /// Centre of the plate in a square of the edge of a plate: at most one, anywhere in it, so that a plate may reach
  /// into the next squares.
  [[nodiscard]] std::optional<std::array<double, 2>> plate_centre_m(GridCell square) const noexcept;

 private:
  [[nodiscard]] bool lies_on_plate(double x_m, double y_m) const noexcept;

  TerrainConfig config_;
  double friction_;
  bool is_plane_;
};

/// The square of a grid that holds a place. Coordinates up to 10^9 m.
[[nodiscard]] GridCell grid_cell(double x_m, double y_m, double edge_m) noexcept;

/// Whether a patch covers a place; its near and right edges belong to it, its far and left ones do not.
[[nodiscard]] bool covers(const PatchConfig&, double x_m, double y_m) noexcept;

}  // namespace surefoot::sim_hw
