#include "tools/scenario/checks.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "sim_hw/config_check.hpp"
#include "sim_hw/nodes/command_queue.hpp"
#include "tools/scenario/field_table.hpp"

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
  Scenario defaults = preset(scenario.plant);
  std::vector<Finding> findings;
  const std::vector<Field> table = fields(checked);
  const std::vector<Field> default_table = fields(defaults);
  for (std::size_t i = 0; i < table.size(); ++i) {
    check_field(table[i], table[i].key, value_text(default_table[i]), findings);
  }
  sim_hw::PayloadConfig default_payload;
  const std::vector<Field> default_payload_table = fields(default_payload);
  for (std::size_t place = 0; place < checked.sim.payloads.size(); ++place) {
    const std::vector<Field> payload_table = fields(checked.sim.payloads[place]);
    for (std::size_t i = 0; i < payload_table.size(); ++i) {
      check_field(payload_table[i], payload_key(place, payload_table[i].key), value_text(default_payload_table[i]),
                  findings);
    }
  }
  if (checked.sim.payloads.size() > kMaxPayloads) {
    findings.push_back(
        {{"payload"},
         fmt::format("payload has {} tables; expected at most {}", checked.sim.payloads.size(), kMaxPayloads),
         "remove some of the [[payload]] tables"});
  }
  return findings;
}

std::vector<Finding> check_relations(const Scenario& scenario) {
  std::vector<Finding> findings;
  check_physics_step(scenario, findings);
  check_reach(scenario, findings);
  check_soles(scenario, findings);
  check_joint_ranges(scenario, findings);
  check_learning(scenario, findings);
  check_foot_offset(scenario, findings);
  check_ride_through(scenario, findings);
  check_watchdog(scenario, findings);
  check_latency(scenario, findings);
  check_shared_numbers(scenario, findings);
  if (findings.empty()) check_simulator(scenario, findings);
  return findings;
}

}  // namespace surefoot::scenario
