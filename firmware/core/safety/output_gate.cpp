#include "firmware/core/safety/output_gate.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace surefoot::safety {
namespace {

constexpr std::size_t kNodes = 5;

std::array<Freshness, kNodes> freshness_of_nodes(const SensorSnapshot& sensors) noexcept {
  return {sensors.leg[0].freshness, sensors.leg[1].freshness, sensors.foot[0].freshness, sensors.foot[1].freshness,
          sensors.torso.freshness};
}

/// Silence of the quietest node, in ticks. A node still awaited after power-up is as old as the gate.
std::uint32_t longest_silence_ticks(const OutputGateState& state, const SensorSnapshot& sensors) noexcept {
  std::uint32_t longest = 0;
  for (const Freshness& freshness : freshness_of_nodes(sensors)) {
    const bool awaited = !state.all_nodes_heard && !freshness.was_heard();
    longest = std::max(longest, awaited ? state.awaited_ticks : freshness.age_ticks);
  }
  return longest;
}

bool is_finite(const PerSide<LegVector>& torque_nm) noexcept {
  bool finite = true;
  for (const LegVector& leg : torque_nm) {
    for (const double torque : leg) finite = finite && std::isfinite(torque);
  }
  return finite;
}

/// Only what was measured in this tick accuses a joint. The comparisons are false for NaN.
bool is_in_range(const OutputGateConfig& config, const LegSensors& leg) noexcept {
  bool inside = true;
  for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
    const double angle = leg.angle_rad[joint];
    inside = inside && angle >= config.angle_min_rad[joint] && angle <= config.angle_max_rad[joint];
  }
  return inside;
}

bool is_slow_enough(const OutputGateConfig& config, const LegSensors& leg) noexcept {
  bool slow = true;
  for (const double rate : leg.rate_rad_s) slow = slow && std::abs(rate) <= config.joint_rate_limit_rad_s;
  return slow;
}

/// Ticks for which a board has damped; a tick without its word neither adds nor forgives.
std::uint32_t count_damping(const SensorSnapshot& sensors, std::uint32_t ticks_so_far) noexcept {
  const auto& legs = sensors.leg;
  const auto damps = [](const LegSensors& leg) { return leg.freshness.is_fresh() && leg.is_damping; };
  if (std::ranges::any_of(legs, damps)) return ticks_so_far + 1;
  const bool all_spoke = std::ranges::all_of(legs, [](const LegSensors& leg) { return leg.freshness.is_fresh(); });
  return all_spoke ? 0 : ticks_so_far;
}

/// The first fault in the order of cause and consequence.
Fault find_fault(const OutputGateConfig& config, const OutputGateState& state, const PerSide<LegVector>& wanted_nm,
                 const SensorSnapshot& sensors) noexcept {
  if (longest_silence_ticks(state, sensors) > config.ride_through_ticks) return Fault::kSensorSilent;
  if (state.damped_ticks > config.ride_through_ticks) return Fault::kBoardDamping;
  for (const LegSensors& leg : sensors.leg) {
    if (!leg.freshness.is_fresh()) continue;
    if (!is_in_range(config, leg)) return Fault::kJointOutOfRange;
    if (!is_slow_enough(config, leg)) return Fault::kJointOverspeed;
  }
  return is_finite(wanted_nm) ? Fault::kNone : Fault::kTorqueNotFinite;
}

}  // namespace

PerSide<LegCommand> step(const OutputGateConfig& config, OutputGateState& state, const PerSide<LegVector>& wanted_nm,
                         const SensorSnapshot& sensors, double period_s) noexcept {
  const auto nodes = freshness_of_nodes(sensors);
  if (std::ranges::all_of(nodes, &Freshness::was_heard)) state.all_nodes_heard = true;
  if (!state.all_nodes_heard) ++state.awaited_ticks;
  if (state.all_nodes_heard) state.damped_ticks = count_damping(sensors, state.damped_ticks);
  if (state.latched == Fault::kNone) state.latched = find_fault(config, state, wanted_nm, sensors);
  if (state.latched != Fault::kNone || !state.all_nodes_heard) {
    state.last_torque_nm = {};
    return {};
  }

  const bool all_fresh = std::ranges::all_of(nodes, &Freshness::is_fresh);
  const double largest_change_nm = config.torque_rate_limit_nm_s * period_s;
  PerSide<LegCommand> command{};
  for (const Side side : kSides) {
    LegVector& last_nm = state.last_torque_nm[index(side)];
    if (all_fresh) {
      for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
        const double limited_nm =
            std::clamp(wanted_nm[index(side)][joint], -config.torque_limit_nm, config.torque_limit_nm);
        last_nm[joint] = std::clamp(limited_nm, last_nm[joint] - largest_change_nm, last_nm[joint] + largest_change_nm);
      }
    }
    command[index(side)] = {LegMode::kTorque, last_nm};
  }
  return command;
}

}  // namespace surefoot::safety
