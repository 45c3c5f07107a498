#include "tools/floor/criteria_walk.hpp"

#include <cmath>
#include <numeric>
#include <optional>

#include "firmware/core/kinematics/leg_kinematics.hpp"
#include "firmware/host/firmware_node.hpp"
#include "firmware/host/memory_bus.hpp"
#include "sim_hw/simulated_robot.hpp"
#include "tools/run/schedule.hpp"
#include "tools/run/standing_pose.hpp"

namespace surefoot::floor {
namespace {

ObservedTick tick_of(const scenario::Scenario& scenario, const FloorWalkerOutput& floor,
                     const sim_hw::GroundTruth& truth) {
  const stabilizer::StabilizerInput& input = floor.input;
  ObservedTick tick;
  tick.walk = input.walk;
  tick.measured = input.measured;
  tick.nominal = input.nominal;
  tick.ankle = input.ankle;
  tick.hip_roll_rate_rad_s = input.hip_roll_rate_rad_s;
  tick.total = floor.adjustment.total;
  tick.torso = sim_hw::inclination(truth, scenario.sim.contact);
  for (const Side side : kSides) {
    const std::size_t i = index(side);
    tick.force_n[i] = std::accumulate(truth.corner_force_n[i].begin(), truth.corner_force_n[i].end(), 0.0);
    tick.foot_body_m[i] = kinematics::forward(scenario.firmware.geometry, side, truth.angle_rad[i]).position_body_m;
    tick.ankle_roll_rad[i] = truth.angle_rad[i][index(LegJoint::kAnkleRoll)];
    tick.hip_joint_rate_rad_s[i] = truth.rate_rad_s[i][index(LegJoint::kHipRoll)];
  }
  return tick;
}

/// First tick from `begin` on in which something holds.
template <typename Condition>
std::optional<std::size_t> first(const ObservedWalk& walk, std::size_t begin, Condition condition) {
  for (std::size_t i = begin; i < walk.ticks.size(); ++i) {
    if (condition(walk.ticks[i])) return i;
  }
  return std::nullopt;
}

}  // namespace

std::size_t ObservedWalk::ticks_in(double duration_s) const noexcept {
  return static_cast<std::size_t>(std::llround(duration_s / period_s));
}

ObservedWalk observe(const scenario::Scenario& given) {
  const scenario::Scenario scenario = run::scheduled(given);
  const run::Schedule schedule = run::schedule_of(scenario);
  host::MemoryBus bus;
  host::FirmwareNode firmware(scenario.firmware);
  sim_hw::SimulatedRobot robot(scenario.sim, run::standing_pose(scenario.firmware));
  ObservedWalk walk;
  walk.config = scenario.firmware.floor.stabilizer;
  walk.period_s = scenario.firmware.period_s;
  walk.body_mass_kg = scenario.firmware.floor.body_mass_kg;
  walk.foot_offset_y_m = scenario.firmware.walk.foot_offset_y_m;
  if (!scenario.sim.pushes.empty()) walk.push_s = scenario.sim.pushes.front().at_s;
  walk.ticks.reserve(static_cast<std::size_t>(schedule.ticks));
  for (std::int64_t tick = 0; tick < schedule.ticks && !walk.has_fallen; ++tick) {
    firmware.begin_tick(bus.controller_end());
    robot.serve(bus.robot_end());
    static_cast<void>(firmware.collect(bus.controller_end()));
    const TickOutput& output = firmware.finish_tick(bus.controller_end());
    robot.serve(bus.robot_end());
    walk.has_fallen = robot.truth().has_fallen || output.fault != safety::Fault::kNone;
    walk.ticks.push_back(tick_of(scenario, output.floor, robot.truth()));
    walk.ticks.back().time_s = static_cast<double>(tick - schedule.zero_tick) * walk.period_s;
  }
  return walk;
}

std::vector<Landing> landings_of(const ObservedWalk& walk) {
  std::vector<Landing> landings;
  for (std::size_t i = 1; i < walk.ticks.size(); ++i) {
    const stabilizer::WalkView& now = walk.ticks[i].walk;
    if (!now.has_landed || walk.ticks[i - 1].walk.has_landed) continue;
    const auto contact =
        first(walk, i, [&](const ObservedTick& tick) { return tick.ankle[index(now.moving)].carries(); });
    const auto step_end = first(walk, i, [](const ObservedTick& tick) { return tick.walk.begins_step; });
    const auto lift = step_end
                          ? first(walk, *step_end, [](const ObservedTick& tick) { return tick.walk.is_swinging(); })
                          : std::nullopt;
    if (!contact || !lift) break;
    landings.push_back({now.moving, *contact, *step_end, *lift, *contact < *step_end ? now.swing_share : 1.0});
  }
  return landings;
}

}  // namespace surefoot::floor
