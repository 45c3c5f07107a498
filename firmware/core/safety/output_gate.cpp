#include "firmware/core/safety/output_gate.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace surefoot::safety {
namespace {

constexpr std::size_t kNodes = 5;  ///< right leg, left leg, right foot, left foot, torso

std::array<Freshness, kNodes> freshness_of_nodes(const SensorSnapshot& sensors) noexcept {
  return {sensors.leg[0].freshness, sensors.leg[1].freshness, sensors.foot[0].freshness, sensors.foot[1].freshness,
          sensors.torso.freshness};
}

/// Inertial sensors of legs and feet; a robot without them has never heard of them.
bool are_inertial_silent(const OutputGateConfig& config, const SensorSnapshot& sensors) noexcept {
  const auto is_silent = [&](const auto& inertial) {
    return inertial.freshness.was_heard() && inertial.freshness.age_ticks > config.ride_through_ticks;
  };
  return std::ranges::any_of(sensors.leg_inertial, is_silent) || std::ranges::any_of(sensors.foot_inertial, is_silent);
}

/// A node still awaited after power-up is as old as the gate.
Finding find_silence(const OutputGateConfig& config, const OutputGateState& state,
                     const SensorSnapshot& sensors) noexcept {
  const auto nodes = freshness_of_nodes(sensors);
  Finding found;
  for (std::size_t node = 0; node < nodes.size(); ++node) {
    const bool is_awaited = !state.all_nodes_heard && !nodes[node].was_heard();
    const std::uint32_t silent_ticks = is_awaited ? state.awaited_ticks : nodes[node].age_ticks;
    if (silent_ticks <= config.ride_through_ticks) continue;
    found = followed_by(found, finding_of_node(Fault::kSensorSilent, node < sensors.leg.size()));
  }
  if (are_inertial_silent(config, sensors)) found = followed_by(found, finding_of_node(Fault::kSensorSilent, false));
  return found;
}

bool is_finite(const PerSide<LegVector>& values) noexcept {
  bool finite = true;
  for (const LegVector& leg : values) {
    for (const double value : leg) finite = finite && std::isfinite(value);
  }
  return finite;
}

/// Only what the mode sends.
bool is_finite(const WantedMotion& wanted) noexcept {
  if (wanted.mode == LegMode::kDamp) return true;
  return is_finite(wanted.mode == LegMode::kPosition ? wanted.angle_rad : wanted.torque_nm);
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

bool have_spoken(const PerSide<LegSensors>& legs) noexcept {
  return std::ranges::all_of(legs, [](const LegSensors& leg) { return leg.freshness.is_fresh(); });
}

/// Ticks for which a board has damped; a tick without its word neither adds nor forgives.
std::uint32_t count_damping(const SensorSnapshot& sensors, std::uint32_t ticks_so_far) noexcept {
  const auto& legs = sensors.leg;
  const auto damps = [](const LegSensors& leg) { return leg.freshness.is_fresh() && leg.is_damping; };
  if (std::ranges::any_of(legs, damps)) return ticks_so_far + 1;
  return have_spoken(legs) ? 0 : ticks_so_far;
}

Finding find_joint_fault(const OutputGateConfig& config, const LegSensors& leg) noexcept {
  if (!leg.freshness.is_fresh()) return {};
  if (!is_in_range(config, leg)) return finding_of(Fault::kJointOutOfRange);
  return is_slow_enough(config, leg) ? Finding{} : finding_of(Fault::kJointOverspeed);
}

/// All faults of this tick as one, in the order of cause and consequence.
Finding find_fault(const OutputGateConfig& config, const OutputGateState& state, const WantedMotion& wanted,
                   const SensorSnapshot& sensors, const GateOrders& orders) noexcept {
  Finding found = followed_by(orders.reported, find_silence(config, state, sensors));
  if (state.damped_ticks > config.ride_through_ticks) found = followed_by(found, finding_of(Fault::kBoardDamping));
  for (const LegSensors& leg : sensors.leg) found = followed_by(found, find_joint_fault(config, leg));
  if (!is_finite(wanted)) found = followed_by(found, finding_of(Fault::kTorqueNotFinite));
  return found;
}

PerSide<LegCommand> limited_torques(const OutputGateConfig& config, OutputGateState& state,
                                    const PerSide<LegVector>& wanted_nm, const SensorSnapshot& sensors,
                                    double period_s) noexcept {
  state.holds_angles = false;
  const double largest_change_nm = config.torque_rate_limit_nm_s * period_s;
  PerSide<LegCommand> command{};
  for (const Side side : kSides) {
    LegVector& last_nm = state.last_torque_nm[index(side)];
    if (sensors.leg[index(side)].freshness.is_fresh()) {
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

double in_range(const OutputGateConfig& config, std::size_t joint, double angle_rad) noexcept {
  return std::clamp(angle_rad, config.angle_min_rad[joint], config.angle_max_rad[joint]);
}

/// Both ends of a change are in range, and so is all that lies between them.
PerSide<LegCommand> limited_angles(const OutputGateConfig& config, OutputGateState& state,
                                   const PerSide<LegVector>& wanted_rad, const SensorSnapshot& sensors,
                                   double period_s) noexcept {
  if (!state.holds_angles && !have_spoken(sensors.leg)) return {};
  const double largest_change_rad = config.reference_rate_limit_rad_s * period_s;
  PerSide<LegCommand> command{};
  for (const Side side : kSides) {
    const LegSensors& leg = sensors.leg[index(side)];
    LegVector& last_rad = state.last_angle_rad[index(side)];
    if (leg.freshness.is_fresh()) {
      const bool begins = !state.holds_angles || leg.is_damping;
      for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
        if (begins) last_rad[joint] = in_range(config, joint, leg.angle_rad[joint]);
        const double limited_rad = in_range(config, joint, wanted_rad[index(side)][joint]);
        last_rad[joint] =
            std::clamp(limited_rad, last_rad[joint] - largest_change_rad, last_rad[joint] + largest_change_rad);
      }
    }
    command[index(side)] = {.mode = LegMode::kPosition, .angle_rad = last_rad};
  }
  state.holds_angles = true;
  state.last_torque_nm = {};
  return command;
}

}  // namespace

PerSide<LegCommand> step(const OutputGateConfig& config, OutputGateState& state, const WantedMotion& wanted,
                         const SensorSnapshot& sensors, const GateOrders& orders, double period_s) noexcept {
  if (std::ranges::all_of(freshness_of_nodes(sensors), &Freshness::was_heard)) state.all_nodes_heard = true;
  if (!state.all_nodes_heard) ++state.awaited_ticks;
  const bool is_standing_by = !state.all_nodes_heard || orders.is_waiting_for_posture || wanted.mode == LegMode::kDamp;
  if (!is_standing_by) state.damped_ticks = count_damping(sensors, state.damped_ticks);

  state.latched = followed_by(state.latched, find_fault(config, state, wanted, sensors, orders));
  if (is_standing_by && state.latched.needs != SafeState::kNone) state.latched.needs = SafeState::kDamp;
  if (is_standing_by || state.latched.needs == SafeState::kDamp) {
    state.last_torque_nm = {};
    state.holds_angles = false;
    return {};
  }
  if (wanted.mode == LegMode::kPosition) return limited_angles(config, state, wanted.angle_rad, sensors, period_s);
  return limited_torques(config, state, wanted.torque_nm, sensors, period_s);
}

}  // namespace surefoot::safety
