#include "tools/floor/floor_cases.hpp"

#include <fmt/format.h>

namespace surefoot::floor {
namespace {

constexpr double kTile_m = 0.004;            // 4 mm over a sole of 140 mm: 1.6 degrees (Kim, Park, Oh 2007, section 4)
constexpr double kRoomSlope_deg = 1.0;       // a usual room's
constexpr double kRoomPlates_per_m2 = 20.0;  // the paper prints none: every third place of a plate has one
constexpr double kRoomStep_m = 0.2;

double tile_height_m(FloorCase floor, std::uint64_t seed) noexcept {
  if (floor == FloorCase::kLocal || floor == FloorCase::kBoth) return kTile_m;
  constexpr std::array kRoomTiles_m{0.002, 0.003, 0.004};  // about +-1 to +-2 degrees
  return floor == FloorCase::kRoom ? kRoomTiles_m[seed % kRoomTiles_m.size()] : 0.0;
}

}  // namespace

const char* name(FloorCase floor) noexcept {
  constexpr std::array kNames{"flat", "local", "global", "both", "room"};
  return kNames[static_cast<std::size_t>(floor)];
}

bool has_seeds(FloorCase floor) noexcept { return floor != FloorCase::kFlat && floor != FloorCase::kGlobal; }

double slope_of(FloorCase floor, double slope_deg) noexcept {
  if (floor == FloorCase::kRoom) return kRoomSlope_deg;
  return floor == FloorCase::kGlobal || floor == FloorCase::kBoth ? slope_deg : 0.0;
}

std::vector<std::string> overrides_of(FloorCase floor, double slope_deg, std::uint64_t seed, double duration_s) {
  const bool is_room = floor == FloorCase::kRoom;
  const double slope = slope_of(floor, slope_deg);
  const bool leans_right = !is_room || seed % 2 == 0;
  const bool leans_ahead = !is_room || seed / 2 % 2 == 0;
  return {fmt::format("pattern.step_length_m={}", is_room ? kRoomStep_m : 0.0),
          fmt::format("floor.slope_roll_deg={}", leans_right ? slope : -slope),
          fmt::format("floor.slope_pitch_deg={}", leans_ahead ? slope : -slope),
          fmt::format("floor.tile_height_m={}", tile_height_m(floor, seed)),
          "floor.tile_edge_m=0.03",
          fmt::format("floor.tile_seed={}", seed),
          fmt::format("floor.plates_per_m2={}", is_room ? kRoomPlates_per_m2 : 0.0),
          "floor.plate_height_m=0.004",
          "floor.plate_edge_m=0.12",
          fmt::format("duration_s={}", is_room ? kRoomWalk_s : duration_s)};
}

batch::Batch base_of(const std::filesystem::path& scenario_file, const std::vector<std::string>& overrides) {
  batch::Batch batch;
  batch.scenario_file = scenario_file;
  batch.common = {"robot=khr2", "payload=[]", "limits.max_abs_pitch_deg=0", "limits.max_abs_roll_deg=0",
                  "limits.min_cycles_after_recovery=0"};
  batch.common.insert(batch.common.end(), overrides.begin(), overrides.end());
  return batch;
}

}  // namespace surefoot::floor
