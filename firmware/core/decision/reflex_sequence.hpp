#pragma once

#include <cstdint>
#include <optional>

#include "firmware/core/decision/balance_watch.hpp"
#include "firmware/core/decision/payload_detector.hpp"
#include "firmware/core/decision/reflex_config.hpp"
#include "firmware/core/decision/reflex_phase.hpp"
#include "firmware/core/estimation/estimator.hpp"
#include "firmware/core/gait/motion_plan.hpp"
#include "firmware/core/gait/safe_stop.hpp"
#include "firmware/core/gait/walk_parameters.hpp"

namespace surefoot::decision {

/// What the robot does in this tick and why: everything the gait needs, and what telemetry shows.
struct Decision {
  ReflexPhase phase = ReflexPhase::kStanding;
  double time_in_phase_s = 0.0;      ///< since the exact begin of the phase, which may lie between two ticks
  std::optional<ReflexEvent> event;  ///< what moved the sequence on in this tick
  gait::MotionPlan motion{};         ///< what the feet do, since `time_in_phase_s`

  bool is_detector_armed = false;
  bool is_payload_seen = false;          ///< the detector fired in this tick, whatever the method makes of it
  double threshold_n = 0.0;              ///< of the detector; 0 until it is armed
  std::optional<double> trigger_time_s;  ///< since power-up: when the detector last fired

  double walk_phase_s = 0.0;            ///< in [0, T); keeps its last value while not walking
  double reference_x_body_m = 0.0;      ///< x_ref_as with all adaptations so far
  double balance_zmp_x_body_m = 0.0;    ///< what the adaptation steers to; measured at the end of the first standing
  double adaptation_m = 0.0;            ///< a, (3.19): last shift of the feet
  double reference_y_body_m = 0.0;      ///< y_ref_as with all lateral adaptations; the capture method alone has any
  double balance_zmp_y_body_m = 0.0;    ///< what those steer to
  CaptureStep capture{};                ///< the last one that was planned
  int refused_adaptations = 0;          ///< shifts left out because the ZMP lay outside the feet
  gait::StepRestoration restoration{};  ///< the last restoring step that was planned
};

/// Everything that lives between two ticks.
///
/// Instants are exact numbers of seconds after an origin tick (power-up, trigger, start of walking);
/// ticks are counted in integers. A phase begins with the first tick that is not before its instant.
struct ReflexSequenceState {
  std::int64_t tick = 0;          ///< since power-up: the tick that comes next
  std::int64_t origin_tick = 0;   ///< instants count from here
  double phase_begin_s = 0.0;     ///< exact begin of the phase after the origin tick
  double phase_duration_s = 0.0;  ///< exact; unused while walking
  PayloadDetectorState detector{};
  BalanceWatchState balance{};
  double standing_force_n = 0.0;  ///< filtered force of the last standing: the robot's weight
  Decision decision{};            ///< of the last tick
};

/// One tick of the payload reflex and adaptation sequence.
/// Source: El-Kahlout 2003, section 3.3, eqs. (3.11)-(3.40), (4.5)(4.6).
///
/// Start-up uses the same machinery: the feet stand side by side for `standing_s`, at whose end
/// weight and balance ZMP are measured; then comes a restoring step of half a nominal step (the left
/// foot swings), then the rest of `settling_s / 2`, then the walk at phase T/2.
///
/// After a trigger, with T1 = t_refl, T2 = T1 + t_set, T3 = T2 + t_x, T6 = T3 + t_ss_a + t_ds_a,
/// T7 = T6 + t_set / 2 (exact instants, not rounded to ticks), each phase begins with the first tick
/// not before its instant. Walking, at start-up and after T7, begins on a whole tick with a phase of
/// exactly T/2 or 0. A skipped step (f < 1e-3) shows as one tick of `kRestoring`.
///
/// At T2 the adaptation a = filtered ZMP - balance ZMP, (3.19), moves x_ref_as, (3.20), and the
/// detector's threshold is carried to the new standing weight: it is armed from the first step on. A
/// filtered ZMP outside the feet cannot be: then the feet stay where they are, and it is counted.
///
/// The capture method (ours) triggers on tipping, too, plans its own end of the reflex (`plan_capture`), adapts y
/// as x, and shifts the feet's middle, which its step has moved, to the reference, no faster than is gentle.
///
/// Calls must come once a period, from power-up on.
///
/// @param stop  not null: the robot must stop, in this way, whatever it is doing, and for good
[[nodiscard]] Decision step(const gait::WalkParameters&, const ReflexConfig&, const PayloadDetectorConfig&,
                            ReflexSequenceState&, const estimation::Estimate&, double period_s,
                            const gait::SafeStopConfig* stop = nullptr) noexcept;

/// From power-up to the begin of the walk: standing, first step, rest. Exact, not rounded to ticks.
[[nodiscard]] double start_up_s(const gait::WalkParameters&, const ReflexConfig&) noexcept;

/// From power-up to "time zero" of a scenario: the begin of the first gait cycle (phase 0, right foot
/// in front) in which the detector is armed. With the defaults start-up ends at phase 2.4, the warm-up
/// of 2.4 s brings the walk to phase 0, learning over one cycle brings it there again: 12.0 s.
///
/// Walking begins on a whole tick; the caller rounds the result up to a whole tick, and phase 0 falls
/// there to one tick.
[[nodiscard]] double time_zero_s(const gait::WalkParameters&, const ReflexConfig&,
                                 const PayloadDetectorConfig&) noexcept;

}  // namespace surefoot::decision
