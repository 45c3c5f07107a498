#include "firmware/core/decision/reflex_sequence.hpp"

#include <algorithm>

#include "firmware/core/decision/reflex_offset.hpp"
#include "firmware/core/decision/tick_time.hpp"
#include "firmware/core/gait/nominal_walk.hpp"
#include "firmware/core/gait/stance.hpp"

namespace surefoot::decision {
namespace {

/// The step function's arguments, and what each event does to the state.
struct Sequence {
  const gait::WalkParameters& walk;
  const ReflexConfig& reflex;
  const PayloadDetectorConfig& detector;
  ReflexSequenceState& state;
  const estimation::Estimate& estimate;
  double period_s;
  const gait::SafeStopConfig* stop;

  [[nodiscard]] std::int64_t ticks_since_origin() const noexcept { return state.tick - state.origin_tick; }

  [[nodiscard]] double time_in_phase_s() const noexcept {
    return std::max(0.0, time_of_tick(ticks_since_origin(), period_s) - state.phase_begin_s);
  }

  /// Where the feet stand when the current motion is over.
  [[nodiscard]] FootReference end_of_motion() const noexcept {
    return gait::foot_reference(walk, state.decision.motion, state.phase_duration_s);
  }

  [[nodiscard]] bool is_capture() const noexcept { return reflex.method == ReflexMethod::kCapture; }

  [[nodiscard]] double offset_y_m() const noexcept {
    return state.decision.reference_y_body_m - walk.reference_y_body_m;
  }

  /// The walk with its feet where the lateral adaptations have put them.
  [[nodiscard]] gait::WalkParameters walk_aside() const noexcept {
    gait::WalkParameters placed = walk;
    placed.reference_y_body_m = state.decision.reference_y_body_m;
    return placed;
  }

  void power_up() noexcept {
    state.decision.reference_y_body_m = walk.reference_y_body_m;
    state.decision.reference_x_body_m = walk.reference_x_body_m;
    state.decision.motion = gait::stand(gait::stance(walk, {walk.reference_x_body_m, walk.reference_x_body_m}));
    state.phase_duration_s = reflex.standing_s;
  }

  /// The next phase begins exactly when the last one was over, wherever the tick lies.
  void follow(const gait::MotionPlan& motion, double duration_s) noexcept {
    state.phase_begin_s += state.phase_duration_s;
    state.phase_duration_s = duration_s;
    state.decision.motion = motion;
  }

  /// The next phase begins with this tick.
  void restart(const gait::MotionPlan& motion, double duration_s) noexcept {
    state.origin_tick = state.tick;
    state.phase_begin_s = 0.0;
    state.phase_duration_s = duration_s;
    state.decision.motion = motion;
  }

  void take_step_from(const FootReference& stance) noexcept {
    const gait::StepRestoration plan = gait::plan_restoration(walk, reflex.timing, state.decision.reference_x_body_m,
                                                              stance[index(Side::kRight)].position_body_m.x(),
                                                              stance[index(Side::kLeft)].position_body_m.x());
    state.decision.restoration = plan;
    follow(gait::restore(plan, offset_y_m()), plan.duration_s());
  }

  void measure_balance() noexcept {
    state.decision.balance_zmp_x_body_m = estimate.filtered_zmp_x_body_m - reflex.balance_offset_m;
    state.decision.balance_zmp_y_body_m = estimate.filtered_zmp_y_body_m;
    state.standing_force_n = estimate.filtered_force_n;
  }

  [[nodiscard]] FootReference now() const noexcept {
    return gait::foot_reference(walk, state.decision.motion, time_in_phase_s());
  }

  void capture() noexcept {
    Decision& decision = state.decision;
    const CaptureState falling{.feet = now(),
                               .com_x_body_m = decision.balance_zmp_x_body_m + reflex.balance_offset_m,
                               .tilt_rate_rise_rad_s = estimate.pitch_rate_rise_rad_s};
    decision.capture = plan_capture(walk_aside(), reflex.capture, falling, reflex.reflex_s);
    restart(gait::move(falling.feet, decision.capture.end, gait::MotionProfile::kQuintic, reflex.reflex_s),
            reflex.reflex_s);
  }

  void react() noexcept {
    if (is_capture()) return capture();
    const FootReference at_trigger = now();
    const PerSide<double> offset_x_m = reflex_offset_x_m(walk, reflex, at_trigger, state.decision.walk_phase_s);
    const FootReference stance = gait::reflex_stance(walk, at_trigger, offset_x_m);
    restart(gait::move(at_trigger, stance, reflex.profile, reflex.reflex_s), reflex.reflex_s);
  }

  /// The capture method's part of the adaptation: y as (3.19) does x, and the feet's middle, which the step has
  /// moved, goes to the reference.
  void shift_to_reference() noexcept {
    Decision& decision = state.decision;
    const double bound_m = reflex.capture.max_lateral_shift_m;
    const double error_y_m = estimate.filtered_zmp_y_body_m - decision.balance_zmp_y_body_m;
    const double shift_y_m = estimate.is_zmp_within_feet ? std::clamp(error_y_m, -bound_m, bound_m) : 0.0;
    decision.reference_y_body_m += shift_y_m;
    decision.balance_zmp_y_body_m += shift_y_m;
    const FootReference start = end_of_motion();
    FootReference end = start;
    const double middle_x_m = 0.5 * (start[0].position_body_m.x() + start[1].position_body_m.x());
    const geometry::Vector3 shift_m{decision.reference_x_body_m - middle_x_m, shift_y_m, 0.0};
    for (FootPath& foot : end) foot.position_body_m += shift_m;
    const double shift_s = gentle_shift_s(reflex.capture, shift_m.norm(), reflex.shift_s);
    follow(gait::move(start, end, gait::MotionProfile::kQuintic, shift_s), shift_s);
  }

  void adapt() noexcept {
    const double error_m = estimate.filtered_zmp_x_body_m - state.decision.balance_zmp_x_body_m;
    const bool is_possible = estimate.is_zmp_within_feet;
    if (!is_possible) ++state.decision.refused_adaptations;
    const double shift_m = is_possible ? std::clamp(error_m, -reflex.max_shift_m, reflex.max_shift_m) : 0.0;
    state.decision.adaptation_m = shift_m;
    state.decision.reference_x_body_m += shift_m;
    // What balances the robot is the ZMP's place between the feet, and they move by a: without this line, which the
    // thesis with its single load does not need, each load would be answered again for all earlier ones.
    state.decision.balance_zmp_x_body_m += shift_m;
    rearm(detector, state.detector, estimate.filtered_force_n - state.standing_force_n);
    state.standing_force_n = estimate.filtered_force_n;
    if (is_capture()) return shift_to_reference();
    const FootReference start = end_of_motion();
    FootReference end = start;
    for (FootPath& foot : end) foot.position_body_m.x() += shift_m;
    follow(gait::move(start, end, reflex.profile, reflex.shift_s), reflex.shift_s);
  }

  void rest() noexcept {
    // A step that was skipped may leave up to 2e-3 b_s: it is made up for while resting.
    const double spread_m = lateral_sign(state.decision.restoration.swing) * walk.half_step_m;
    const double reference_x_m = state.decision.reference_x_body_m;
    const FootReference stance = gait::stance(walk_aside(), {reference_x_m - spread_m, reference_x_m + spread_m});
    const double rest_s = 0.5 * reflex.settling_s;
    follow(gait::move(end_of_motion(), stance, gait::MotionProfile::kQuintic, rest_s), rest_s);
  }

  void walk_on() noexcept {
    const double phase_s = state.decision.restoration.resume_phase_s(walk);
    restart(gait::walk_on(phase_s, state.decision.reference_x_body_m, offset_y_m()), 0.0);
  }

  void act(ReflexEvent event) noexcept {
    switch (event) {
      case ReflexEvent::kStandingDone:
        measure_balance();
        return take_step_from(end_of_motion());
      case ReflexEvent::kPayloadDetected:
      case ReflexEvent::kBalanceLost:
        return react();
      case ReflexEvent::kReflexDone:
        return follow(gait::stand(end_of_motion()), reflex.settling_s);
      case ReflexEvent::kSettled:
        return adapt();
      case ReflexEvent::kShifted:
        return take_step_from(end_of_motion());
      case ReflexEvent::kRestored:
        return rest();
      case ReflexEvent::kRested:
        return walk_on();
      case ReflexEvent::kStopOrdered:
        return restart(gait::safe_stop(walk_aside(), *stop, now()), stop->duration_s);
    }
  }

  void follow_walk() noexcept {
    Decision& decision = state.decision;
    const double phase_s = decision.motion.start_phase_s + time_in_phase_s();
    const gait::HalfCycle half = gait::half_cycle(walk, phase_s);
    decision.walk_phase_s = half.time_s + (half.swing == Side::kRight ? walk.step_s() : 0.0);
  }

  [[nodiscard]] std::optional<ReflexEvent> event_of_tick() noexcept {
    const ReflexPhase phase = state.decision.phase;
    if (phase == ReflexPhase::kStopped) return std::nullopt;
    if (stop != nullptr) return ReflexEvent::kStopOrdered;
    return phase == ReflexPhase::kWalking ? event_of_walking() : event_at_end_of(phase);
  }

  [[nodiscard]] std::optional<ReflexEvent> event_of_walking() noexcept {
    Decision& decision = state.decision;
    decision.is_payload_seen =
        decision::step(detector, state.detector, estimate.filtered_force_n, ticks_since_origin(), period_s);
    const bool is_tipping =
        is_capture() && is_balance_lost(reflex.capture.tilt_margin_rad_s, state.balance, state.detector.stage,
                                        estimate.roll_rate_rad_s, estimate.pitch_rate_rad_s);
    if (!decision.is_payload_seen) return is_tipping ? std::optional(ReflexEvent::kBalanceLost) : std::nullopt;
    decision.trigger_time_s = time_of_tick(state.tick, period_s);
    if (reflex.method == ReflexMethod::kOff) return std::nullopt;
    return ReflexEvent::kPayloadDetected;
  }

  [[nodiscard]] std::optional<ReflexEvent> event_at_end_of(ReflexPhase phase) const noexcept {
    if (ticks_since_origin() < first_tick_at(state.phase_begin_s + state.phase_duration_s, period_s)) {
      return std::nullopt;
    }
    // The timed phases have one edge each beside the stop: the event that ends them.
    for (const Edge& edge : kReflexEdges) {
      if (edge.from == phase && edge.on != ReflexEvent::kStopOrdered) return edge.on;
    }
    return std::nullopt;
  }
};

}  // namespace

Decision step(const gait::WalkParameters& walk, const ReflexConfig& reflex, const PayloadDetectorConfig& detector,
              ReflexSequenceState& state, const estimation::Estimate& estimate, double period_s,
              const gait::SafeStopConfig* stop) noexcept {
  Sequence sequence{walk, reflex, detector, state, estimate, period_s, stop};
  Decision& decision = state.decision;
  if (state.tick == 0) sequence.power_up();

  decision.is_payload_seen = false;
  if (decision.phase == ReflexPhase::kWalking) sequence.follow_walk();
  decision.event = sequence.event_of_tick();
  if (decision.event) {
    if (const std::optional<ReflexPhase> next = next_phase(decision.phase, *decision.event)) {
      sequence.act(*decision.event);
      decision.phase = *next;
      if (decision.phase == ReflexPhase::kWalking) sequence.follow_walk();
    }
  }
  decision.time_in_phase_s = sequence.time_in_phase_s();
  decision.is_detector_armed = state.detector.threshold_n > 0.0;
  decision.threshold_n = state.detector.threshold_n;
  ++state.tick;
  return decision;
}

double start_up_s(const gait::WalkParameters& walk, const ReflexConfig& reflex) noexcept {
  const double x_m = walk.reference_x_body_m;
  return reflex.standing_s + gait::plan_restoration(walk, reflex.timing, x_m, x_m, x_m).duration_s() +
         0.5 * reflex.settling_s;
}

double time_zero_s(const gait::WalkParameters& walk, const ReflexConfig& reflex,
                   const PayloadDetectorConfig& detector) noexcept {
  const double first_phase_zero_s = walk.step_s();  // the walk starts at phase T/2
  const double armed_s = detector.warm_up_s + detector.learning_s;
  const auto cycles = std::max<std::int64_t>(0, first_tick_at(armed_s - first_phase_zero_s, walk.cycle_s()));
  return start_up_s(walk, reflex) + first_phase_zero_s + static_cast<double>(cycles) * walk.cycle_s();
}

}  // namespace surefoot::decision
