#include "tools/run/telemetry_messages.hpp"

#include <algorithm>
#include <cstring>

namespace surefoot::run {
namespace {

/// LCM arrays are C arrays of the same shape as ours.
template <typename Source, std::size_t N>
void copy(const Source& source, double (&target)[N]) noexcept {
  for (std::size_t i = 0; i < N; ++i) target[i] = source[static_cast<decltype(i)>(i)];
}

template <typename Source, std::size_t M, std::size_t N>
void copy(const Source& source, double (&target)[M][N]) noexcept {
  for (std::size_t i = 0; i < M; ++i) copy(source[i], target[i]);
}

}  // namespace

controller_state_t state_message(std::int64_t utime_us, const TickOutput& output,
                                 const SensorSnapshot& sensors) noexcept {
  controller_state_t message{};
  message.utime = utime_us;
  message.tick = output.tick;
  message.phase = static_cast<std::int8_t>(output.decision.phase);
  message.walk_phase_s = output.decision.walk_phase_s;
  message.reference_x_body_m = output.decision.reference_x_body_m;
  for (const Side side : kSides) {
    const std::size_t i = index(side);
    for (int axis = 0; axis < 3; ++axis)
      message.foot_reference_m[i][axis] = output.foot_reference[i].position_body_m[axis];
    copy(sensors.leg[i].angle_rad, message.joint_angle_rad[i]);
    copy(sensors.leg[i].rate_rad_s, message.joint_rate_rad_s[i]);
    copy(output.command[i].torque_nm, message.torque_command_nm[i]);
  }
  copy(output.joint_reference.angle_rad, message.joint_reference_rad);
  copy(output.estimate.foot_force_n, message.foot_force_n);
  message.vertical_force_n = output.estimate.vertical_force_n;
  message.filtered_force_n = output.estimate.filtered_force_n;
  message.threshold_n = output.decision.threshold_n;
  message.zmp_x_body_m = output.estimate.zmp_x_body_m;
  message.zmp_y_body_m = output.estimate.zmp_y_body_m;
  message.filtered_zmp_x_body_m = output.estimate.filtered_zmp_x_body_m;
  message.adaptation_m = output.decision.adaptation_m;
  message.balance_zmp_x_body_m = output.decision.balance_zmp_x_body_m;
  const std::array<Freshness, 5> nodes{sensors.leg[0].freshness, sensors.leg[1].freshness, sensors.foot[0].freshness,
                                       sensors.foot[1].freshness, sensors.torso.freshness};
  for (std::size_t node = 0; node < nodes.size(); ++node) {
    message.node_age_ticks[node] = static_cast<std::int32_t>(nodes[node].age_ticks);  // kNeverHeard reads -1
  }
  message.fault = static_cast<std::int8_t>(output.fault);
  message.safe_state = static_cast<std::int8_t>(output.safe_state);
  message.is_waiting_for_posture = output.is_waiting_for_posture ? 1 : 0;
  message.is_reachable = output.joint_reference.is_reachable ? 1 : 0;
  return message;
}

simulator_truth_t truth_message(std::int64_t utime_us, std::uint32_t tick, const sim_hw::GroundTruth& truth) noexcept {
  simulator_truth_t message{};
  message.utime = utime_us;
  message.tick = tick;
  copy(truth.body_position_world_m, message.body_position_world_m);
  copy(truth.body_velocity_world_m_s, message.body_velocity_world_m_s);
  message.roll_rad = truth.roll_rad;
  message.pitch_rad = truth.pitch_rad;
  message.yaw_rad = truth.yaw_rad;
  copy(truth.body_rate_body_rad_s, message.body_rate_body_rad_s);
  copy(truth.corner_force_n, message.corner_force_n);
  copy(truth.angle_rad, message.angle_rad);
  copy(truth.rate_rad_s, message.rate_rad_s);
  copy(truth.torque_nm, message.torque_nm);
  message.zmp_x_body_m = truth.zmp_x_body_m;
  message.payloads_hung = truth.payloads_hung;
  message.payload_kg = truth.payload_kg;
  message.payloads_removed = truth.payloads_removed;
  message.removed_kg = truth.removed_kg;
  copy(truth.push_impulse_world_n_s, message.push_impulse_world_n_s);
  message.slip_m = truth.slip_m;
  message.has_fallen = truth.has_fallen ? 1 : 0;
  return message;
}

bus_statistics_t bus_message(std::int64_t utime_us, std::uint32_t tick, const can::FrameCounters& counters,
                             double load_percent) noexcept {
  bus_statistics_t message{};
  message.utime = utime_us;
  message.tick = tick;
  message.frames_sent = static_cast<std::int64_t>(counters.sent);
  message.frames_refused = static_cast<std::int64_t>(counters.refused_by_bus);
  message.frames_received = static_cast<std::int64_t>(counters.received);
  for (std::size_t cause = 0; cause < counters.rejected.size(); ++cause) {
    message.rejected[cause] = static_cast<std::int64_t>(counters.rejected[cause]);
  }
  message.lost = static_cast<std::int64_t>(counters.lost);
  message.load_percent = load_percent;
  return message;
}

timing_statistics_t timing_message(std::int64_t utime_us, std::uint32_t tick,
                                   const host::TickHistogram& tick_times) noexcept {
  timing_statistics_t message{};
  message.utime = utime_us;
  message.tick = tick;
  message.tick_p50_us = tick_times.p50_us();
  message.tick_p999_us = tick_times.p999_us();
  message.tick_max_us = tick_times.max_us();
  return message;
}

timing_statistics_t timing_message(std::int64_t utime_us, std::uint32_t tick, const host::LoopReport& loop) noexcept {
  timing_statistics_t message{};
  message.utime = utime_us;
  message.tick = tick;
  message.tick_p50_us = loop.compute.p50_us;
  message.tick_p999_us = loop.compute.p999_us;
  message.tick_max_us = loop.compute.max_us;
  message.wake_p50_us = loop.wake_up.p50_us;
  message.wake_p999_us = loop.wake_up.p999_us;
  message.wake_max_us = loop.wake_up.max_us;
  message.overruns = loop.overruns;
  message.minor_page_faults = loop.usage.minor_page_faults;
  message.major_page_faults = loop.usage.major_page_faults;
  message.voluntary_switches = loop.usage.voluntary_switches;
  message.involuntary_switches = loop.usage.involuntary_switches;
  return message;
}

event_t event_message(std::int64_t utime_us, std::uint32_t tick, std::int8_t code, const char* name,
                      double value) noexcept {
  event_t message{};
  message.utime = utime_us;
  message.tick = tick;
  message.code = code;
  message.value = value;
  std::memcpy(message.name, name, std::min(std::strlen(name), sizeof message.name - 1));
  return message;
}

TickOutput output_of(const controller_state_t& message) noexcept {
  TickOutput output;
  output.tick = static_cast<std::uint32_t>(message.tick);
  output.decision.phase = static_cast<decision::ReflexPhase>(message.phase);
  output.decision.walk_phase_s = message.walk_phase_s;
  output.decision.threshold_n = message.threshold_n;
  output.estimate.filtered_force_n = message.filtered_force_n;
  output.joint_reference.is_reachable = message.is_reachable != 0;
  output.fault = static_cast<safety::Fault>(message.fault);
  return output;
}

sim_hw::GroundTruth truth_of(const simulator_truth_t& message) noexcept {
  sim_hw::GroundTruth truth;
  truth.time_s = 1e-6 * static_cast<double>(message.utime);
  for (std::size_t axis = 0; axis < 3; ++axis) truth.body_position_world_m[axis] = message.body_position_world_m[axis];
  truth.roll_rad = message.roll_rad;
  truth.pitch_rad = message.pitch_rad;
  truth.yaw_rad = message.yaw_rad;
  for (const Side side : kSides) {
    for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
      truth.torque_nm[index(side)][joint] = message.torque_nm[index(side)][joint];
    }
  }
  truth.zmp_x_body_m = message.zmp_x_body_m;
  truth.payloads_hung = message.payloads_hung;
  truth.payload_kg = message.payload_kg;
  truth.payloads_removed = message.payloads_removed;
  truth.removed_kg = message.removed_kg;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    truth.push_impulse_world_n_s[axis] = message.push_impulse_world_n_s[axis];
  }
  truth.slip_m = message.slip_m;
  truth.has_fallen = message.has_fallen != 0;
  return truth;
}

}  // namespace surefoot::run
