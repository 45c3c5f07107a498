#pragma once

#include <functional>
#include <vector>

#include "firmware/core/decision/reflex_sequence.hpp"
#include "firmware/core/gait/motion_plan.hpp"

namespace surefoot::decision {

/// One tick of a run, as the gait would see it.
struct SequenceTick {
  double time_s = 0.0;
  Decision decision{};
  FootReference feet{};
};

/// The decision and the gait alone, fed with made-up estimates: no robot, no kinematics.
struct SequenceRun {
  gait::WalkParameters walk{};
  ReflexConfig reflex{};
  PayloadDetectorConfig detector{};
  double period_s = 1.0e-3;
  ReflexSequenceState state{};
  std::vector<SequenceTick> ticks{};

  using Sensed = std::function<estimation::Estimate(double time_s)>;

  SequenceTick next(const Sensed& sensed) {
    SequenceTick tick{.time_s = static_cast<double>(state.tick) * period_s};
    tick.decision = step(walk, reflex, detector, state, sensed(tick.time_s), period_s);
    tick.feet = gait::foot_reference(walk, tick.decision.motion, tick.decision.time_in_phase_s);
    return tick;
  }

  /// Runs and keeps every tick.
  void run_until(double end_s, const Sensed& sensed) {
    while (static_cast<double>(state.tick) * period_s < end_s) ticks.push_back(next(sensed));
  }

  /// The first tick from `from_s` on in which `event` moved the sequence, or the end.
  [[nodiscard]] std::vector<SequenceTick>::const_iterator find(ReflexEvent event, double from_s = 0.0) const {
    auto it = ticks.begin();
    while (it != ticks.end() && !(it->time_s >= from_s && it->decision.event == event)) ++it;
    return it;
  }
};

/// An 80 kg robot that stands with its ZMP at -0.035 m, given `added_n` of load at `load_s`, whose weight
/// the filter shows at once and which moves the ZMP to `loaded_zmp_m`.
inline SequenceRun::Sensed with_load(double load_s, double added_n, double loaded_zmp_m) {
  return [=](double time_s) {
    const bool is_loaded = time_s >= load_s - 1.0e-9;
    return estimation::Estimate{.filtered_force_n = 784.8 + (is_loaded ? added_n : 0.0),
                                .filtered_zmp_x_body_m = is_loaded ? loaded_zmp_m : -0.035};
  };
}

}  // namespace surefoot::decision
