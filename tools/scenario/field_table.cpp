#include "tools/scenario/field_table.hpp"

#include <fmt/format.h>

#include "tools/scenario/field_builders.hpp"
#include "tools/scenario/preset.hpp"

namespace surefoot::scenario {
namespace {

constexpr std::array kPayloadInertias{"thesis", "exact"};

}  // namespace

void append_run_fields(std::vector<Field>& table, Scenario& scenario) {
  constexpr double kLargestExactInteger = 9007199254740991.0;  // 2^53 - 1
  table.insert(
      table.end(),
      {name_field("robot", scenario.robot, kRobots, "robot that walks"),
       name_field("plant", scenario.plant, kPlants, "preset of sole size and floor friction"),
       Field{"seed", &scenario.sim.seed, {0.0, kLargestExactInteger}, "1", "seed of all sensor noise"},
       Field{"duration_s", &scenario.duration_s, {0.0, 3600.0, true}, "s", "length of the run on the scenario's clock"},
       Field{"control_period_s", &scenario.firmware.period_s, {1e-4, 1e-2}, "s", "time between two control ticks"}});
}

std::vector<Field> fields(Scenario& scenario) {
  std::vector<Field> table;
  append_run_fields(table, scenario);
  append_firmware_fields(table, scenario);
  append_safety_fields(table, scenario);
  append_simulator_fields(table, scenario);
  if (walks_over_floors(scenario)) append_floor_walk_fields(table, scenario);
  table.insert(table.end(), {Field{"limits.max_abs_pitch_deg",
                                   &scenario.limits.max_abs_pitch_deg,
                                   {0.0, 90.0},
                                   "deg",
                                   "largest torso pitch that passes, 0 for none"},
                             Field{"limits.max_abs_roll_deg",
                                   &scenario.limits.max_abs_roll_deg,
                                   {0.0, 90.0},
                                   "deg",
                                   "largest torso roll that passes, 0 for none"},
                             Field{"limits.min_cycles_after_recovery",
                                   &scenario.limits.min_cycles_after_recovery,
                                   {0.0, 1000.0},
                                   "cycles",
                                   "number of gait cycles to walk after the last recovery, load taken off or push"},
                             flag_field("limits.ends_when_recovered", scenario.limits.ends_when_recovered,
                                        "end of the run as soon as these cycles are walked"),
                             Field{"telemetry.every_ticks",
                                   &scenario.telemetry.every_ticks,
                                   {1.0, 1e6},
                                   "ticks",
                                   "spacing of the telemetry messages"}});
  return table;
}

std::vector<Field> fields(sim_hw::PayloadConfig& payload) {
  return {
      Field{"mass_kg", &payload.mass_kg, {0.0, 60.0}, "kg", "mass of the load"},
      Field{"at_s", &payload.at_s, {0.0, 3600.0}, "s", "instant at which the load is hung on, on the scenario's clock"},
      Field{"removed_at_s",
            &payload.removed_at_s,
            {0.0, 3600.0, false, true},
            "s",
            "instant at which the load is taken off again"},
      array_field("position_m", payload.position_m, {-1.0, 1.0}, "m", "centre of the load in the body frame, x y z"),
      Field{"edge_m", &payload.edge_m, {0.0, 1.0, true}, "m", "edge of the cube"},
      choice_field("inertia", payload.inertia, kPayloadInertias,
                   "law for the trunk's inertia, eq. (3.8) or parallel axes")};
}

std::vector<Field> fields(sim_hw::PushConfig& push) {
  return {Field{"at_s", &push.at_s, {0.0, 3600.0}, "s", "begin of the push on the scenario's clock"},
          Field{"duration_s",
                &push.duration_s,
                {0.0, 60.0, true},
                "s",
                "length of the push; its impulse is force times duration"},
          array_field("force_n", push.force_n, {-1.0e5, 1.0e5}, "N",
                      "force in the world frame, x ahead at the start, y left, z along the floor's normal"),
          array_field("point_body_m", push.point_body_m, {-1.0, 1.0}, "m",
                      "point of the trunk that is pushed, in the body frame, x y z")};
}

std::string element_key(std::string_view array, std::size_t place, std::string_view key) {
  return fmt::format("{}[{}].{}", array, place, key);
}

bool is_array_of_tables(std::string_view key) {
  return key == "payload" || key == "push" || key == "patch" || key == "fault" || key == "planned_gait";
}

}  // namespace surefoot::scenario
