#include "tools/floor/floor_maps.hpp"

#include <fmt/format.h>

namespace surefoot::floor {
namespace {

constexpr int kInstants = 8;
constexpr double kCycle_s = 1.9;

map::MapSpec between_sets(double duration_s) {
  map::MapSpec spec;
  spec.method_key = "stabilizer.set";
  spec.method_title = "controllers";
  spec.methods = {"paper", "extended"};
  spec.set = {fmt::format("duration_s={}", duration_s), "pattern.step_length_m=0"};
  return spec;
}

}  // namespace

map::MapSpec rough_map(const std::vector<std::uint64_t>& seeds, double duration_s) {
  map::MapSpec spec = between_sets(duration_s);
  spec.title = "KHR-2 on slopes with tiles of 30 x 30 mm";
  spec.rows.title = "slope, degrees";
  spec.columns.title = "tiles, mm";
  spec.repeats.title = "seed";
  for (int slope_deg = 0; slope_deg <= 10; ++slope_deg) {
    spec.rows.values.push_back(
        {fmt::format("{}", slope_deg),
         {fmt::format("floor.slope_roll_deg={}", slope_deg), fmt::format("floor.slope_pitch_deg={}", slope_deg)}});
  }
  for (int height_mm = 0; height_mm <= 12; height_mm += 2) {
    spec.columns.values.push_back(
        {fmt::format("{}", height_mm), {fmt::format("floor.tile_height_m={}", 1e-3 * height_mm)}});
  }
  for (const std::uint64_t seed : seeds) {
    spec.repeats.values.push_back({fmt::format("{}", seed), {fmt::format("floor.tile_seed={}", seed)}});
  }
  return spec;
}

map::MapSpec push_map(double duration_s) {
  map::MapSpec spec = between_sets(duration_s);
  spec.title = "KHR-2 pushed sideways, 0.25 m above the hips";
  spec.set.insert(spec.set.end(), {"push.0.duration_s=0.1", "push.0.point_body_m=[0.0, 0.0, 0.25]"});
  spec.rows.title = "impulse, N s";
  spec.columns.title = "push at, s";
  spec.repeats.title = "towards";
  for (int impulse_n_s = 5; impulse_n_s <= 25; impulse_n_s += 5) {
    spec.rows.values.push_back({fmt::format("{}", impulse_n_s), {}});
  }
  for (int i = 0; i < kInstants; ++i) {
    const std::string at_s = fmt::format("{:.2f}", kFirstPush_s + kCycle_s * i / kInstants);
    spec.columns.values.push_back({at_s, {"push.0.at_s=" + at_s}});
  }
  // {row}0: an impulse in N s, as force in N over 0.1 s.
  spec.repeats.values = {{"left", {"push.0.force_n=[0.0, {row}0.0, 0.0]"}},
                         {"right", {"push.0.force_n=[0.0, -{row}0.0, 0.0]"}}};
  return spec;
}

map::MapSpec payload_map(double duration_s) {
  map::MapSpec spec;
  spec.title = "KHR-2 on tiles on a slope of 3 degrees, a load hung on its chest";
  spec.method_key = "reflex.method";
  spec.methods = {"off", "original"};
  spec.set = {fmt::format("duration_s={}", kFirstPush_s + duration_s),
              "pattern.step_length_m=0",
              "stabilizer.set=extended",
              "floor.slope_roll_deg=3",
              "floor.slope_pitch_deg=3",
              "floor.tile_height_m=0.004",
              "payload.0.position_m=[0.2, 0.0, 0.25]"};
  spec.rows.title = "load, kg";
  spec.columns.title = "hung at, s";
  spec.repeats.title = "seed";
  for (const double load_kg : {5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 35.0, 40.0}) {
    spec.rows.values.push_back({fmt::format("{}", load_kg), {fmt::format("payload.0.mass_kg={}", load_kg)}});
  }
  for (int i = 0; i < kInstants; ++i) {
    const std::string at_s = fmt::format("{:.2f}", kFirstPush_s + kCycle_s * i / kInstants);
    spec.columns.values.push_back({at_s, {"payload.0.at_s=" + at_s}});
  }
  for (const std::uint64_t seed : {1U, 2U}) {
    spec.repeats.values.push_back({fmt::format("{}", seed), {fmt::format("floor.tile_seed={}", seed)}});
  }
  return spec;
}

}  // namespace surefoot::floor
