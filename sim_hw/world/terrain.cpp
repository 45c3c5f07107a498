#include "sim_hw/world/terrain.hpp"

#include <algorithm>
#include <cmath>

#include "sim_hw/faults/fault_random.hpp"

namespace surefoot::sim_hw {
namespace {

constexpr double kFarAwayM = 1.0e9;

/// What a number is drawn for; tiles and plates do not share any.
enum class Draw : std::uint64_t { kTileHeight, kHasPlate, kPlateX, kPlateY };

/// In [0, 1), from the seed, the place and the purpose alone (counter-based).
double draw(std::uint64_t seed, GridCell cell, Draw what) noexcept {
  std::uint64_t bits = FaultRandom::mixed(seed);
  bits = FaultRandom::mixed(bits ^ static_cast<std::uint64_t>(what));
  bits = FaultRandom::mixed(bits ^ static_cast<std::uint64_t>(cell.x));
  return FaultRandom::uniform(FaultRandom::mixed(bits ^ static_cast<std::uint64_t>(cell.y)));
}

}  // namespace

GridCell grid_cell(double x_m, double y_m, double edge_m) noexcept {
  return {static_cast<std::int64_t>(std::floor(x_m / edge_m)), static_cast<std::int64_t>(std::floor(y_m / edge_m))};
}

bool covers(const PatchConfig& patch, double x_m, double y_m) noexcept {
  const double from_near_m = x_m - (patch.centre_m[0] - 0.5 * patch.size_m[0]);
  const double from_right_m = y_m - (patch.centre_m[1] - 0.5 * patch.size_m[1]);
  return from_near_m >= 0.0 && from_near_m < patch.size_m[0] && from_right_m >= 0.0 && from_right_m < patch.size_m[1];
}

Terrain::Terrain(const TerrainConfig& config, double friction)
    : config_(config),
      friction_(friction),
      is_plane_(config.tile_height_m == 0.0 && config.plates_per_m2 == 0.0 && config.patches.empty()) {}

double Terrain::tile_height_m(GridCell tile) const noexcept {
  return config_.tile_height_m * draw(config_.tile_seed, tile, Draw::kTileHeight);
}

std::optional<std::array<double, 2>> Terrain::plate_centre_m(GridCell square) const noexcept {
  const double edge_m = config_.plate_edge_m;
  const double probability = config_.plates_per_m2 * edge_m * edge_m;
  if (draw(config_.tile_seed, square, Draw::kHasPlate) >= probability) return std::nullopt;
  return std::array{edge_m * (static_cast<double>(square.x) + draw(config_.tile_seed, square, Draw::kPlateX)),
                    edge_m * (static_cast<double>(square.y) + draw(config_.tile_seed, square, Draw::kPlateY))};
}

bool Terrain::lies_on_plate(double x_m, double y_m) const noexcept {
  const double half_m = 0.5 * config_.plate_edge_m;
  const GridCell first = grid_cell(x_m - half_m, y_m - half_m, config_.plate_edge_m);
  for (std::int64_t x = first.x; x <= first.x + 1; ++x) {
    for (std::int64_t y = first.y; y <= first.y + 1; ++y) {
      const auto centre = plate_centre_m({x, y});
      if (centre && std::abs(x_m - (*centre)[0]) <= half_m && std::abs(y_m - (*centre)[1]) <= half_m) return true;
    }
  }
  return false;
}

Surface Terrain::at(double x_m, double y_m) const noexcept {
  const bool is_near = std::abs(x_m) < kFarAwayM && std::abs(y_m) < kFarAwayM;  // false for NaN
  if (is_plane_ || !is_near) return {};
  Surface top;
  if (config_.plates_per_m2 > 0.0 && lies_on_plate(x_m, y_m)) top.height_m = config_.plate_height_m;
  for (const PatchConfig& patch : config_.patches) {
    if (patch.kind == PatchKind::kFriction || !covers(patch, x_m, y_m)) continue;
    Surface raised{.height_m = patch.height_m};
    if (patch.kind == PatchKind::kRamp) {
      raised.slope_x = patch.height_m / patch.size_m[0];
      raised.height_m = raised.slope_x * (x_m - (patch.centre_m[0] - 0.5 * patch.size_m[0]));
    }
    if (raised.height_m >= top.height_m) top = raised;
  }
  if (has_tiles()) top.height_m += tile_height_m(grid_cell(x_m, y_m, config_.tile_edge_m));
  return top;
}

double Terrain::friction(double x_m, double y_m) const noexcept {
  double friction = friction_;
  for (const PatchConfig& patch : config_.patches) {
    if (patch.friction >= 0.0 && covers(patch, x_m, y_m)) friction = patch.friction;
  }
  return friction;
}

}  // namespace surefoot::sim_hw
