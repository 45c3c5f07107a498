#include "tools/scenario/checks.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "sim_hw/bus/bus_budget.hpp"
#include "sim_hw/config_check.hpp"
#include "sim_hw/faults/fault_check.hpp"
#include "sim_hw/nodes/command_queue.hpp"
#include "tools/scenario/bus_traffic.hpp"
#include "tools/scenario/field_table.hpp"
#include "tools/scenario/planned_gait_checks.hpp"
#include "tools/scenario/preset.hpp"

namespace surefoot::scenario {
namespace {

bool is_choice(const Field& field) { return std::holds_alternative<Choice>(field.target); }

void check_field(const Field& field, const std::string& key, const std::string& default_text,
                 std::vector<Finding>& findings) {
  const auto check = [&](const std::string& shown_key, double value, const std::string& text) {
    if (!is_in_range(field, value)) {
      findings.push_back(refusal(field, shown_key, text, range_text(field), default_text));
    }
  };
  if (const auto* number = std::get_if<double*>(&field.target)) check(key, **number, value_text(field));
  if (const auto* number = std::get_if<std::uint32_t*>(&field.target)) check(key, **number, value_text(field));
  if (const auto* number = std::get_if<std::uint64_t*>(&field.target)) {
    check(key, static_cast<double>(**number), value_text(field));
  }
  if (const auto* choice = std::get_if<Choice>(&field.target); choice && choice->get() >= choice->names.size()) {
    findings.push_back(refusal(field, key, "none of them", expectation(field), default_text));
  }
  if (const auto* numbers = std::get_if<Numbers>(&field.target)) {
    for (std::size_t i = 0; i < numbers->size(); ++i) {
      check(fmt::format("{}[{}]", key, i), *(*numbers)[i], toml_number(*(*numbers)[i]));
    }
  }
}

void check_physics_step(const Scenario& scenario, std::vector<Finding>& findings) {
  const double period_s = scenario.firmware.period_s;
  const double step_s = scenario.sim.physics_step_s;
  const double steps = period_s / step_s;
  if (std::round(steps) >= 1.0 && std::abs(steps - std::round(steps)) < 1e-9 * steps) return;
  findings.push_back({{"physics.step_s", "control_period_s"},
                      fmt::format("physics.step_s is {}; expected control_period_s = {} s divided by a whole number",
                                  step_s, period_s),
                      "take half the control period, or a quarter"});
}

void check_reach(const Scenario& scenario, std::vector<Finding>& findings) {
  const gait::WalkParameters& walk = scenario.firmware.walk;
  const geometry::RobotGeometry& robot = scenario.firmware.geometry;
  const std::vector<std::string> keys{"gait.body_height_m",      "gait.half_step_m",      "gait.sway_m",
                                      "gait.swing_height_m",     "gait.foot_offset_y_m",  "gait.reference_x_body_m",
                                      "gait.reference_y_body_m", "geometry.thigh_m",      "geometry.calf_m",
                                      "geometry.ankle_height_m", "geometry.hip_x_body_m", "geometry.hip_y_body_m"};
  // Corners of the box that the feet stay in; from the hip to the ankle.
  const double far_x_m = std::abs(walk.reference_x_body_m - robot.hip_x_body_m) + walk.half_step_m;
  const double far_y_m =
      std::abs(walk.foot_offset_y_m - robot.hip_y_body_m) + std::abs(walk.reference_y_body_m) + walk.sway_m;
  const double far_z_m = walk.body_height_m - robot.ankle_height_m;
  const double needed_m = std::hypot(far_x_m, far_y_m, far_z_m);
  const double reach_m = robot.thigh_m + robot.calf_m;
  if (needed_m >= reach_m) {
    findings.push_back(
        {keys,
         fmt::format("the walk needs a leg of {:.4g} m; expected less than thigh and calf together, {:.4g} m", needed_m,
                     reach_m),
         "lower gait.body_height_m, gait.half_step_m or gait.sway_m, or lengthen geometry.thigh_m or geometry.calf_m"});
  }
  const double near_m = far_z_m - walk.swing_height_m;
  const double folded_m = std::abs(robot.thigh_m - robot.calf_m);
  if (near_m <= folded_m) {
    findings.push_back(
        {keys,
         fmt::format("the swing foot comes within {:.4g} m of the hip; expected more than the folded leg, {:.4g} m",
                     near_m, folded_m),
         "raise gait.body_height_m, or lower gait.swing_height_m or geometry.ankle_height_m"});
  }
}

void check_soles(const Scenario& scenario, std::vector<Finding>& findings) {
  const double distance_m = 2.0 * scenario.firmware.walk.foot_offset_y_m;
  const double width_m = scenario.firmware.geometry.sole_width_m;
  if (distance_m > width_m) return;
  findings.push_back({{"gait.foot_offset_y_m", "geometry.sole_width_m"},
                      fmt::format("the soles overlap: they are {} m wide and {} m apart", width_m, distance_m),
                      "raise gait.foot_offset_y_m or lower geometry.sole_width_m"});
}

void check_joint_ranges(const Scenario& scenario, std::vector<Finding>& findings) {
  const safety::OutputGateConfig& gate = scenario.firmware.gate;
  for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
    if (gate.angle_min_rad[joint] < gate.angle_max_rad[joint]) continue;
    findings.push_back({{"gate.angle_max_rad", "gate.angle_min_rad"},
                        fmt::format("gate.angle_max_rad[{}] is {}; expected more than gate.angle_min_rad[{}] = {} rad",
                                    joint, gate.angle_max_rad[joint], joint, gate.angle_min_rad[joint]),
                        fmt::format("give {} a range of angles", kLegJointNames[joint])});
  }
}

void check_learning(const Scenario& scenario, std::vector<Finding>& findings) {
  const double cycle_s = scenario.firmware.walk.cycle_s();
  const double learning_s = scenario.firmware.detector.learning_s;
  if (learning_s >= cycle_s * (1.0 - 1e-9)) return;
  findings.push_back(
      {{"detector.learning_s", "gait.single_support_s", "gait.double_support_s"},
       fmt::format("detector.learning_s is {}; expected at least one gait cycle, {:.4g} s", learning_s, cycle_s),
       "learn over a whole cycle: the force of a shorter time misses its maximum"});
}

void check_measuring(const Scenario& scenario, std::vector<Finding>& findings) {
  const double cycle_s = scenario.firmware.walk.cycle_s();
  const double measuring_s = scenario.firmware.floor.payload.measuring_s;
  if (!walks_over_floors(scenario) || measuring_s >= cycle_s * (1.0 - 1e-9)) return;
  findings.push_back(
      {{"payload_shift.measuring_s", "gait.single_support_s", "gait.double_support_s"},
       fmt::format("payload_shift.measuring_s is {}; expected at least one gait cycle, {:.4g} s", measuring_s, cycle_s),
       "average over a whole cycle: force and ZMP of a shorter time are those of a part of a step"});
}

void check_foot_offset(const Scenario& scenario, std::vector<Finding>& findings) {
  const double offset_m = scenario.firmware.reflex.foot_offset_m;
  const double half_step_m = scenario.firmware.walk.half_step_m;
  if (offset_m <= half_step_m) return;
  findings.push_back(
      {{"reflex.foot_offset_m", "gait.half_step_m"},
       fmt::format("reflex.foot_offset_m is {}; expected at most gait.half_step_m = {} m", offset_m, half_step_m),
       "lower reflex.foot_offset_m: one restoring step cannot make up for more"});
}

void check_ride_through(const Scenario& scenario, std::vector<Finding>& findings) {
  const double latency_ticks = std::ceil(scenario.sim.command_latency_s / scenario.firmware.period_s - 1e-9);
  const double least_ticks = latency_ticks + 1.0;
  if (scenario.firmware.gate.ride_through_ticks >= least_ticks) return;
  findings.push_back(
      {{"gate.ride_through_ticks", "bus.command_latency_s"},
       fmt::format("gate.ride_through_ticks is {}; expected at least {}, the command latency and one tick",
                   scenario.firmware.gate.ride_through_ticks, least_ticks),
       "raise gate.ride_through_ticks: until the first torques act, the boards damp"});
}

void check_watchdog(const Scenario& scenario, std::vector<Finding>& findings) {
  const double period_s = scenario.firmware.period_s;
  if (scenario.sim.watchdog_s > period_s) return;
  findings.push_back({{"bus.watchdog_s", "control_period_s"},
                      fmt::format("bus.watchdog_s is {}; expected more than one control period, {:.4g} s",
                                  scenario.sim.watchdog_s, period_s),
                      "raise bus.watchdog_s, or the leg boards damp between any two torque frames"});
}

void check_latency(const Scenario& scenario, std::vector<Finding>& findings) {
  const double longest_s = static_cast<double>(sim_hw::CommandQueue::kCapacity - 1) * scenario.firmware.period_s;
  if (scenario.sim.command_latency_s < longest_s) return;
  findings.push_back({{"bus.command_latency_s", "control_period_s"},
                      fmt::format("bus.command_latency_s is {}; expected less than {:.4g} s, {} control periods",
                                  scenario.sim.command_latency_s, longest_s, sim_hw::CommandQueue::kCapacity - 1),
                      "lower bus.command_latency_s"});
}

/// A rate of which a bit lasts a whole number of nanoseconds, as the bus model counts them.
void check_bit_rate(const char* key, double rate_hz, std::vector<Finding>& findings) {
  const double bit_ns = 1e9 / rate_hz;
  if (std::abs(bit_ns - std::round(bit_ns)) < 1e-6) return;
  findings.push_back(
      {{key},
       fmt::format("{} is {}; expected a rate of which a bit lasts a whole number of nanoseconds, not {:.6g}", key,
                   rate_hz, bit_ns),
       "take 1e9 divided by a whole number, e.g. 1e6, 2e6, 4e6, 5e6 or 8e6"});
}

void check_bus(const Scenario& scenario, std::vector<Finding>& findings) {
  const sim_hw::BusConfig& bus = scenario.sim.bus;
  const std::size_t findings_before = findings.size();
  check_bit_rate("bus.nominal_bit_rate_hz", bus.nominal_bit_rate_hz, findings);
  check_bit_rate("bus.data_bit_rate_hz", bus.data_bit_rate_hz, findings);
  if (bus.data_bit_rate_hz < bus.nominal_bit_rate_hz) {
    findings.push_back({{"bus.data_bit_rate_hz", "bus.nominal_bit_rate_hz"},
                        fmt::format("bus.data_bit_rate_hz is {}; expected bus.nominal_bit_rate_hz = {} or more",
                                    bus.data_bit_rate_hz, bus.nominal_bit_rate_hz),
                        "raise bus.data_bit_rate_hz: the data phase is the fast one"});
  }
  if (findings.size() > findings_before) return;
  if (const auto refused = sim_hw::refuse_overload(bus, scenario.firmware.period_s, bus_traffic(scenario))) {
    findings.push_back({{"control_period_s", "bus.count", "bus.data_bit_rate_hz", "bus.nominal_bit_rate_hz",
                         "bus.node_latency_s", "bus.node_jitter_s", "bus.compute_s"},
                        refused->statement,
                        refused->remedy});
  }
}

void check_shared_numbers(const Scenario& scenario, std::vector<Finding>& findings) {
  Scenario shared = scenario;
  share_numbers(shared);
  const geometry::RobotGeometry& here = shared.sim.geometry;
  const geometry::RobotGeometry& there = scenario.sim.geometry;
  const bool same_geometry = here.hip_x_body_m == there.hip_x_body_m && here.hip_y_body_m == there.hip_y_body_m &&
                             here.thigh_m == there.thigh_m && here.calf_m == there.calf_m &&
                             here.ankle_height_m == there.ankle_height_m && here.sole_heel_m == there.sole_heel_m &&
                             here.sole_toe_m == there.sole_toe_m && here.sole_width_m == there.sole_width_m;
  if (same_geometry && shared.sim.control_period_s == scenario.sim.control_period_s &&
      shared.firmware.servo.torque_limit_nm == scenario.firmware.servo.torque_limit_nm) {
    return;
  }
  findings.push_back({{},
                      "simulator and firmware disagree on geometry, control period or torque limit",
                      "call share_numbers after changing a scenario in code"});
}

/// The simulator's own checks, so that nothing that it refuses gets as far as a run.
void check_simulator(const Scenario& scenario, std::vector<Finding>& findings) {
  try {
    sim_hw::check(scenario.sim);
  } catch (const std::invalid_argument& error) {
    const std::string message = error.what();
    const std::string separator = "\n  remedy: ";
    const std::size_t remedy = message.find(separator);
    findings.push_back({{}, message.substr(0, remedy), message.substr(remedy + separator.size())});
  }
}

/// Ranges of an array of tables, and their number.
template <typename Element>
void check_elements(const std::string& array_name, std::vector<Element>& elements, std::size_t max,
                    std::vector<Finding>& findings) {
  Element default_element;
  const std::vector<Field> defaults = fields(default_element);
  for (std::size_t place = 0; place < elements.size(); ++place) {
    const std::vector<Field> table = fields(elements[place]);
    for (std::size_t i = 0; i < table.size(); ++i) {
      check_field(table[i], element_key(array_name, place, table[i].key), value_text(defaults[i]), findings);
    }
  }
  if (elements.size() > max) {
    findings.push_back({{array_name},
                        fmt::format("{} has {} tables; expected at most {}", array_name, elements.size(), max),
                        fmt::format("remove some of the [[{}]] tables", array_name)});
  }
}

void check_removals(const Scenario& scenario, std::vector<Finding>& findings) {
  for (std::size_t place = 0; place < scenario.sim.payloads.size(); ++place) {
    const sim_hw::PayloadConfig& payload = scenario.sim.payloads[place];
    if (payload.removed_at_s > payload.at_s) continue;
    const std::string key = element_key("payload", place, "removed_at_s");
    const std::string hung_key = element_key("payload", place, "at_s");
    findings.push_back(
        {{key, hung_key},
         fmt::format("{} is {}; expected later than {} = {} s", key, payload.removed_at_s, hung_key, payload.at_s),
         "take the load off after it was hung on, or remove the key: then it hangs on"});
  }
}

void check_plates(const Scenario& scenario, std::vector<Finding>& findings) {
  const sim_hw::TerrainConfig& terrain = scenario.sim.terrain;
  const double most_per_m2 = 1.0 / (terrain.plate_edge_m * terrain.plate_edge_m);
  if (terrain.plates_per_m2 <= most_per_m2) return;
  findings.push_back({{"floor.plates_per_m2", "floor.plate_edge_m"},
                      fmt::format("floor.plates_per_m2 is {}; expected at most {:.4g}, one on each square of the size "
                                  "of a plate",
                                  terrain.plates_per_m2, most_per_m2),
                      "scatter fewer plates, or lower floor.plate_edge_m"});
}

/// Kinds of fault that their target, signal or value cannot have.
void check_faults(const Scenario& scenario, std::vector<Finding>& findings) {
  for (std::size_t place = 0; place < scenario.sim.faults.size(); ++place) {
    const auto problem = sim_hw::find_problem(scenario.sim.faults[place]);
    if (!problem) continue;
    const std::string key = element_key("fault", place, problem->field);
    findings.push_back({{key, element_key("fault", place, "kind")}, key + " " + problem->statement, problem->remedy});
  }
}

}  // namespace

Finding refusal(const Field& field, const std::string& key, const std::string& value, const std::string& expected,
                const std::string& default_text) {
  const std::string advice = is_choice(field) ? "choose a name that exists" : fmt::format("give the {}", field.doc);
  return {{key},
          fmt::format("{} is {}; expected {}", key, value, expected),
          fmt::format("{}, or remove the key to use {}", advice, default_text)};
}

std::vector<Finding> check_ranges(const Scenario& scenario) {
  Scenario checked = scenario;
  Scenario defaults = preset(preset_names(scenario));
  std::vector<Finding> findings;
  const std::vector<Field> table = fields(checked);
  const std::vector<Field> default_table = fields(defaults);
  for (std::size_t i = 0; i < table.size(); ++i) {
    check_field(table[i], table[i].key, value_text(default_table[i]), findings);
  }
  check_elements("payload", checked.sim.payloads, kMaxPayloads, findings);
  check_elements("push", checked.sim.pushes, sim_hw::kMaxPushes, findings);
  check_elements("patch", checked.sim.terrain.patches, sim_hw::kMaxPatches, findings);
  check_elements("fault", checked.sim.faults, sim_hw::kMaxFaults, findings);
  check_elements("planned_gait", checked.gaits, kMaxPlannedGaits, findings);
  return findings;
}

std::vector<Finding> check_relations(const Scenario& scenario) {
  std::vector<Finding> findings;
  check_physics_step(scenario, findings);
  scenario.gaits.empty() ? check_reach(scenario, findings) : check_planned_gaits(scenario, findings);
  check_soles(scenario, findings);
  check_joint_ranges(scenario, findings);
  check_learning(scenario, findings);
  check_measuring(scenario, findings);
  check_foot_offset(scenario, findings);
  check_ride_through(scenario, findings);
  check_watchdog(scenario, findings);
  check_latency(scenario, findings);
  check_bus(scenario, findings);
  check_removals(scenario, findings);
  check_plates(scenario, findings);
  check_faults(scenario, findings);
  check_shared_numbers(scenario, findings);
  if (findings.empty()) check_simulator(scenario, findings);
  return findings;
}

}  // namespace surefoot::scenario
