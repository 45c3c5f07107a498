#include "tools/scenario/field_builders.hpp"
#include "tools/scenario/field_table.hpp"

namespace surefoot::scenario {
namespace {

// In the order of the enumerators.
constexpr std::array kPatchKinds{"plate", "ramp", "friction"};

}  // namespace

void append_terrain_fields(std::vector<Field>& table, sim_hw::TerrainConfig& terrain) {
  constexpr double kLargestExactInteger = 9007199254740991.0;  // 2^53 - 1
  table.insert(
      table.end(),
      {Field{"floor.tile_height_m",
             &terrain.tile_height_m,
             {0.0, 0.05},
             "m",
             "largest height of a tile, drawn from 0 on; 0 for no tiles"},
       Field{"floor.tile_edge_m", &terrain.tile_edge_m, {0.005, 1.0}, "m", "edge of a tile"},
       Field{"floor.tile_seed",
             &terrain.tile_seed,
             {0.0, kLargestExactInteger},
             "1",
             "seed of the tiles' heights and of the plates' places"},
       Field{"floor.plates_per_m2",
             &terrain.plates_per_m2,
             {0.0, 1000.0},
             "1/m2",
             "number of scattered plates on a square metre"},
       Field{"floor.plate_height_m", &terrain.plate_height_m, {0.0, 0.05}, "m", "thickness of a scattered plate"},
       Field{"floor.plate_edge_m", &terrain.plate_edge_m, {0.005, 1.0}, "m", "edge of a scattered plate"}});
}

std::vector<Field> fields(sim_hw::PatchConfig& patch) {
  return {choice_field("kind", patch.kind, kPatchKinds,
                       "what lies there: a plate or step, a ramp that rises ahead, or another friction alone"),
          array_field("centre_m", patch.centre_m, {-1000.0, 1000.0}, "m",
                      "centre of the rectangle on the floor, x ahead at the start, y left"),
          array_field("size_m", patch.size_m, {0.005, 1000.0}, "m", "length along x and width along y"),
          Field{"height_m", &patch.height_m, {0.0, 0.3}, "m", "height of the plate, or of the ramp at its far edge"},
          Field{"friction", &patch.friction, {-1.0, 2.0}, "1", "coefficient of friction, below 0 that of the floor"}};
}

}  // namespace surefoot::scenario
