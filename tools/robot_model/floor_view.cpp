#include "tools/robot_model/floor_view.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "sim_hw/world/slope.hpp"
#include "sim_hw/world/terrain.hpp"

namespace surefoot::robot_model {
namespace {

using Json = nlohmann::ordered_json;

/// Squares of a grid from one that holds a corner to one that holds the opposite corner.
struct Squares {
  sim_hw::GridCell first;
  std::int64_t nx;
  std::int64_t ny;
};

Squares squares(const Extent& extent, double edge_m) {
  const sim_hw::GridCell first = sim_hw::grid_cell(extent.from_x_m, extent.from_y_m, edge_m);
  const sim_hw::GridCell last = sim_hw::grid_cell(extent.to_x_m, extent.to_y_m, edge_m);
  const Squares found{first, last.x - first.x + 1, last.y - first.y + 1};
  if (static_cast<double>(found.nx) * static_cast<double>(found.ny) > kMaxTiles) {
    throw std::invalid_argument(fmt::format(
        "--extent holds {} by {} squares of {} m; at most {} in all\n  remedy: ask for a smaller part of the floor",
        found.nx, found.ny, edge_m, kMaxTiles));
  }
  return found;
}

Json tiles(const sim_hw::Terrain& terrain, const Extent& extent) {
  if (!terrain.has_tiles()) return nullptr;
  const double edge_m = terrain.config().tile_edge_m;
  const Squares grid = squares(extent, edge_m);
  Json height_m = Json::array();
  for (std::int64_t x = 0; x < grid.nx; ++x) {
    for (std::int64_t y = 0; y < grid.ny; ++y) {
      height_m.push_back(terrain.tile_height_m({grid.first.x + x, grid.first.y + y}));
    }
  }
  return {{"edge_m", edge_m},
          {"x0_m", edge_m * static_cast<double>(grid.first.x)},
          {"y0_m", edge_m * static_cast<double>(grid.first.y)},
          {"nx", grid.nx},
          {"ny", grid.ny},
          {"height_m", height_m}};
}

void add_scattered(Json& plates, const sim_hw::Terrain& terrain, const Extent& extent) {
  const sim_hw::TerrainConfig& config = terrain.config();
  if (config.plates_per_m2 <= 0.0) return;
  const Squares grid = squares(extent, config.plate_edge_m);
  for (std::int64_t x = 0; x < grid.nx; ++x) {
    for (std::int64_t y = 0; y < grid.ny; ++y) {
      const auto centre_m = terrain.plate_centre_m({grid.first.x + x, grid.first.y + y});
      if (!centre_m) continue;
      plates.push_back({{"kind", "plate"},
                        {"centre_m", *centre_m},
                        {"size_m", {config.plate_edge_m, config.plate_edge_m}},
                        {"height_m", config.plate_height_m}});
    }
  }
}

const char* name(sim_hw::PatchKind kind) {
  switch (kind) {
    case sim_hw::PatchKind::kPlate:
      return "plate";
    case sim_hw::PatchKind::kRamp:
      return "ramp";
    case sim_hw::PatchKind::kFriction:
      break;
  }
  return "friction";
}

}  // namespace

nlohmann::ordered_json floor_json(const sim_hw::SimConfig& config, const Extent& extent) {
  const sim_hw::Terrain terrain(config.terrain, config.contact.friction);
  Json plates = Json::array();
  add_scattered(plates, terrain, extent);
  for (const sim_hw::PatchConfig& patch : config.terrain.patches) {
    plates.push_back({{"kind", name(patch.kind)},
                      {"centre_m", patch.centre_m},
                      {"size_m", patch.size_m},
                      {"height_m", patch.kind == sim_hw::PatchKind::kFriction ? 0.0 : patch.height_m}});
  }
  const geometry::Vector3 gravity = sim_hw::gravity_floor_m_s2(config.contact);
  return {{"slope_roll_deg", config.contact.slope_roll_deg},
          {"slope_pitch_deg", config.contact.slope_pitch_deg},
          {"friction", config.contact.friction},
          {"gravity_world_m_s2", {gravity.x(), gravity.y(), gravity.z()}},
          {"tiles", tiles(terrain, extent)},
          {"plates", plates}};
}

}  // namespace surefoot::robot_model
