#include "tools/run/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "firmware/core/gait/nominal_walk.hpp"
#include "surefoot/event_t.hpp"

namespace surefoot::run {
namespace {

constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;
constexpr double kStandingWindow_s = 0.5;

}  // namespace

Judge::Judge(const scenario::Scenario& scenario)
    : limits_(scenario.limits),
      walk_(scenario.firmware.walk),
      method_(scenario.firmware.reflex.method),
      torque_limit_nm_(std::min(scenario.sim.drive.torque_limit_nm, scenario.firmware.gate.torque_limit_nm)),
      period_s_(scenario.firmware.period_s),
      standing_s_(scenario.firmware.reflex.standing_s),
      time_zero_s_(scenario.sim.time_zero_s),
      payload_count_(scenario.sim.payloads.size()) {
  partial_.ended_at_s = -time_zero_s_;
  partial_.events.reserve(kMaxEvents);
}

void Judge::observe(const TickOutput& output, const sim_hw::GroundTruth& truth,
                    std::span<const RunEvent> events) noexcept {
  const double time_s = output.tick * period_s_ - time_zero_s_;
  partial_.ended_at_s = time_s;
  const bool is_scored = time_s >= 0.0;
  (is_scored ? partial_.torso_pitch_deg : partial_.start_up_pitch_deg).include(truth.pitch_rad * kDegreesPerRadian);
  (is_scored ? partial_.torso_roll_deg : partial_.start_up_roll_deg).include(truth.roll_rad * kDegreesPerRadian);

  if (is_scored) {
    observe_torques(truth);
  } else {
    slip_at_zero_m_ = truth.slip_m;
    start_x_m_ = truth.body_position_world_m[0];
    const double since_power_up_s = output.tick * period_s_;
    if (since_power_up_s < standing_s_ && since_power_up_s >= standing_s_ - kStandingWindow_s) {
      standing_zmp_sum_m_ += truth.zmp_x_body_m;
      ++standing_zmp_ticks_;
    }
  }
  slip_m_ = truth.slip_m;
  partial_.distance_m = truth.body_position_world_m[0] - start_x_m_;
  partial_.threshold_n = output.decision.threshold_n;
  if (!output.joint_reference.is_reachable) ++partial_.unreachable_ticks;

  observe_gait(output, time_s);

  has_fallen_ = truth.has_fallen;
  fault_ = output.fault;
  partial_.payloads_attached = truth.payloads_hung;
  for (const RunEvent& event : events) {
    if (partial_.events.size() < kMaxEvents) partial_.events.push_back({event.name, time_s});
    count_detections(event);
  }
}

void Judge::count_detections(const RunEvent& event) noexcept {
  const bool is_answered = event.code == event_t::PAYLOAD_DETECTED;
  if (!is_answered && event.code != event_t::PAYLOAD_SEEN) return;
  if (partial_.payloads_detected < partial_.payloads_attached) {
    ++partial_.payloads_detected;
  } else if (is_answered || partial_.payloads_attached == 0) {
    ++partial_.false_alarms;  // with the reflex off the load's own ripple crosses the threshold again and again
  }
}

void Judge::observe_torques(const sim_hw::GroundTruth& truth) noexcept {
  for (const Side side : kSides) {
    for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
      const double torque_nm = truth.torque_nm[index(side)][joint];
      const double magnitude_nm = std::abs(torque_nm);
      partial_.peak_torque_nm[joint] = std::max(partial_.peak_torque_nm[joint], magnitude_nm);
      if (magnitude_nm >= 0.999 * torque_limit_nm_) ++joint_ticks_at_limit_;
      if (has_last_torque_) {
        const double change_nm = torque_nm - last_torque_nm_[index(side)][joint];
        ripple_square_sum_ += change_nm * change_nm;
        ++joint_changes_;
      }
      ++joint_ticks_;
    }
  }
  last_torque_nm_ = truth.torque_nm;
  has_last_torque_ = true;
}

void Judge::observe_gait(const TickOutput& output, double time_s) noexcept {
  const decision::Decision& decision = output.decision;
  const bool starts_walking = decision.phase == decision::ReflexPhase::kWalking && phase_ != decision.phase;
  if (starts_walking) walking_since_s_ = std::max(time_s, 0.0);
  phase_ = decision.phase;

  if (phase_ != decision::ReflexPhase::kWalking) {
    partial_.cycles_after_recovery = 0.0;
    is_single_support_ = false;
    return;
  }
  partial_.cycles_after_recovery = std::max(0.0, time_s + period_s_ - walking_since_s_) / walk_.cycle_s();
  const bool is_single = !gait::is_double_support(walk_, decision.walk_phase_s);
  if (is_single_support_ && !is_single && time_s >= 0.0) ++partial_.steps_walked;
  is_single_support_ = is_single;
}

void Judge::decide_outcome(Verdict& verdict, bool was_interrupted) const {
  const auto decide = [&verdict](Outcome outcome, std::string reason) {
    verdict.outcome = outcome;
    verdict.reason = std::move(reason);
  };
  const double largest_pitch_deg = verdict.torso_pitch_deg.largest_magnitude();
  const double largest_roll_deg = verdict.torso_roll_deg.largest_magnitude();
  const bool needs_recovery = method_ != decision::ReflexMethod::kOff && verdict.payloads_detected > 0;
  const auto payload_count = static_cast<int>(payload_count_);
  if (has_fallen_) {
    decide(Outcome::kFell, fmt::format("the robot fell at {:.3f} s", verdict.ended_at_s));
  } else if (fault_ != safety::Fault::kNone) {
    decide(Outcome::kFault, fmt::format("fault {} ({}) latched at {:.3f} s; see firmware/FAULTS.md",
                                        static_cast<int>(fault_), safety::name(fault_), verdict.ended_at_s));
  } else if (was_interrupted) {
    decide(Outcome::kInterrupted, fmt::format("stopped at {:.3f} s; what was recorded is kept", verdict.ended_at_s));
  } else if (limits_.max_abs_pitch_deg > 0.0 && largest_pitch_deg > limits_.max_abs_pitch_deg) {
    decide(Outcome::kLimit, fmt::format("torso pitch reached {:.3f} deg, limits.max_abs_pitch_deg is {}",
                                        largest_pitch_deg, limits_.max_abs_pitch_deg));
  } else if (limits_.max_abs_roll_deg > 0.0 && largest_roll_deg > limits_.max_abs_roll_deg) {
    decide(Outcome::kLimit, fmt::format("torso roll reached {:.3f} deg, limits.max_abs_roll_deg is {}",
                                        largest_roll_deg, limits_.max_abs_roll_deg));
  } else if (verdict.payloads_attached < payload_count) {
    decide(Outcome::kLimit, fmt::format("only {} of {} payloads were hung on before the end; raise duration_s",
                                        verdict.payloads_attached, payload_count));
  } else if (verdict.false_alarms > 0) {
    decide(Outcome::kLimit,
           fmt::format("the payload detector fired {} time(s) without a payload", verdict.false_alarms));
  } else if (needs_recovery && verdict.cycles_after_recovery < limits_.min_cycles_after_recovery) {
    decide(Outcome::kLimit,
           fmt::format("{:.4f} cycles walked after recovery, limits.min_cycles_after_recovery is {}; a longer "
                       "duration_s may be all it needs",
                       verdict.cycles_after_recovery, limits_.min_cycles_after_recovery));
  } else {
    decide(Outcome::kWalked, fmt::format("walks until the end at {:.3f} s{}", verdict.ended_at_s + period_s_,
                                         payload_count == 0 ? ""
                                                            : fmt::format("; {} of {} payloads noticed",
                                                                          verdict.payloads_detected, payload_count)));
  }
}

Verdict Judge::verdict(bool was_interrupted) const {
  Verdict verdict = partial_;
  const double joint_ticks = static_cast<double>(std::max<std::uint64_t>(joint_ticks_, 1));
  verdict.torque_ripple_nm =
      std::sqrt(ripple_square_sum_ / static_cast<double>(std::max<std::uint64_t>(joint_changes_, 1)));
  verdict.time_at_torque_limit_percent = 100.0 * static_cast<double>(joint_ticks_at_limit_) / joint_ticks;
  verdict.foot_slip_mm = 1e3 * (slip_m_ - slip_at_zero_m_) / std::max(verdict.steps_walked, 1);
  if (standing_zmp_ticks_ > 0) {
    verdict.standing_zmp_x_body_m = standing_zmp_sum_m_ / static_cast<double>(standing_zmp_ticks_);
  }
  decide_outcome(verdict, was_interrupted);
  return verdict;
}

}  // namespace surefoot::run
