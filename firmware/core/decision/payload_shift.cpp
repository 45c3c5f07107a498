#include "firmware/core/decision/payload_shift.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot::decision {
namespace {

constexpr double kGravity_m_s2 = 9.81;

/// Present weight as the last mean has it.
double carried_force_n(const PayloadShiftState& state) noexcept {
  return state.answered_force_n > 0.0 ? state.answered_force_n : state.unloaded_force_n;
}

void move_to(const PayloadShiftConfig& config, PayloadShiftState& state, double target_m, double move_s) noexcept {
  state.from_m = state.offset_m;
  state.target_m = std::clamp(target_m, -config.max_offset_m, config.max_offset_m);
  state.move_s = move_s;
  state.moved_s = 0.0;
}

void move(const PayloadShiftConfig& config, PayloadShiftState& state, double period_s) noexcept {
  if (state.moved_s >= state.move_s) return;
  state.moved_s += period_s;
  state.offset_m = gait::quintic(state.from_m, state.target_m, state.move_s, state.moved_s);
  // A move that begins at speed may swing beyond both ends.
  state.offset_m.position = std::clamp(state.offset_m.position, -config.max_offset_m, config.max_offset_m);
}

void begin_mean(PayloadShiftState& state) noexcept {
  state.force_sum_n = 0.0;
  state.zmp_sum_m = 0.0;
  state.summed_ticks = 0;
}

void include(PayloadShiftState& state, const PayloadShiftInput& input) noexcept {
  state.force_sum_n += input.vertical_force_n;
  state.zmp_sum_m += input.zmp_x_foot_m;
  ++state.summed_ticks;
}

double mean(const PayloadShiftState& state, double sum) noexcept {
  return state.summed_ticks > 0 ? sum / static_cast<double>(state.summed_ticks) : 0.0;
}

void watch(const PayloadDetectorConfig& detector, PayloadShiftState& state, const PayloadShiftInput& input,
           double period_s) noexcept {
  const DetectorStage before = state.detector.stage;
  state.is_payload_seen = step(detector, state.detector, input.filtered_force_n, state.walked_ticks, period_s);
  ++state.walked_ticks;
  if (state.detector.stage == DetectorStage::kLearning) include(state, input);
  if (before == DetectorStage::kLearning && state.detector.stage == DetectorStage::kArmed) {
    state.unloaded_force_n = mean(state, state.force_sum_n);
    state.balance_zmp_x_m = mean(state, state.zmp_sum_m);
  }
  if (state.is_payload_seen && input.answers) state.event = ReflexEvent::kPayloadDetected;
}

void weigh(const PayloadShiftConfig& config, PayloadShiftState& state) noexcept {
  const double force_n = mean(state, state.force_sum_n);
  const double carried_n = carried_force_n(state);
  const double added_kg = (force_n - carried_n) / kGravity_m_s2;
  const double unanswered_m = state.from_m.position;  // the first move may have met the bound
  move_to(config, state, unanswered_m + balancing_offset_m(added_kg, config.lever_m, carried_n / kGravity_m_s2),
          config.settling_s);
}

void adapt(const PayloadShiftConfig& config, const PayloadDetectorConfig& detector, PayloadShiftState& state) noexcept {
  const double force_n = mean(state, state.force_sum_n);
  const double before_m = state.target_m;
  move_to(config, state, before_m - (mean(state, state.zmp_sum_m) - state.balance_zmp_x_m), config.shift_s);
  state.adaptation_m = state.target_m - before_m;
  rearm(detector, state.detector, force_n - carried_force_n(state));
  state.answered_force_n = force_n;
  state.added_mass_kg = std::max(0.0, (force_n - state.unloaded_force_n) / kGravity_m_s2);
  state.walked_ticks = 0;
}

void act(const PayloadShiftConfig& config, const PayloadDetectorConfig& detector, PayloadShiftState& state) noexcept {
  switch (*state.event) {
    case ReflexEvent::kPayloadDetected:
      move_to(config, state, state.target_m - config.first_offset_m, config.reflex_s);
      break;
    case ReflexEvent::kReflexDone:
      weigh(config, state);
      break;
    case ReflexEvent::kSettled:
      adapt(config, detector, state);
      break;
    default:
      break;
  }
  begin_mean(state);
}

/// The end of a phase, with the tolerance of `first_tick_at`.
bool is_over(const PayloadShiftState& state, double duration_s, double period_s) noexcept {
  return state.time_in_phase_s >= duration_s - 1.0e-6 * period_s;
}

void follow(const PayloadShiftConfig& config, PayloadShiftState& state, const PayloadShiftInput& input,
            double period_s) noexcept {
  switch (state.phase) {
    case ReflexPhase::kReflex:
      include(state, input);
      if (is_over(state, config.reflex_s, period_s)) state.event = ReflexEvent::kReflexDone;
      break;
    case ReflexPhase::kSettling:
      if (is_over(state, config.settling_s, period_s)) include(state, input);
      if (is_over(state, config.settling_s + config.measuring_s, period_s)) state.event = ReflexEvent::kSettled;
      break;
    case ReflexPhase::kShifting:
      if (is_over(state, config.shift_s, period_s)) state.event = ReflexEvent::kShifted;
      break;
    default:
      break;
  }
}

void take_edge(PayloadShiftState& state) noexcept {
  for (const Edge& edge : kPayloadShiftEdges) {
    if (edge.from != state.phase || edge.on != *state.event) continue;
    state.phase = edge.to;
    state.time_in_phase_s = 0.0;
    return;
  }
}

}  // namespace

double balancing_offset_m(double added_kg, double lever_m, double robot_kg) noexcept {
  return added_kg > 0.0 && robot_kg > 0.0 ? -added_kg * lever_m / (robot_kg + added_kg) : 0.0;
}

double step(const PayloadShiftConfig& config, const PayloadDetectorConfig& detector, PayloadShiftState& state,
            const PayloadShiftInput& input, double period_s) noexcept {
  state.event.reset();
  state.is_payload_seen = false;
  if (!(period_s > 0.0) || !std::isfinite(period_s)) return state.offset_m.position;
  state.time_in_phase_s += period_s;
  move(config, state, period_s);
  if (!std::isfinite(input.vertical_force_n) || !std::isfinite(input.filtered_force_n) ||
      !std::isfinite(input.zmp_x_foot_m)) {
    return state.offset_m.position;
  }
  if (state.phase == ReflexPhase::kWalking) {
    watch(detector, state, input, period_s);
  } else {
    follow(config, state, input, period_s);
  }
  if (state.event) {
    act(config, detector, state);
    take_edge(state);
  }
  return state.offset_m.position;
}

}  // namespace surefoot::decision
