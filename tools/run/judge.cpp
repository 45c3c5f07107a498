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
      floor_(scenario.sim.contact),
      against_vertical_(scenario.firmware.method == WalkMethod::kFloorWalk),
      method_(scenario.firmware.reflex.method),
      torque_limit_nm_(std::min(scenario.sim.drive.torque_limit_nm, scenario.firmware.gate.torque_limit_nm)),
      period_s_(scenario.firmware.period_s),
      standing_s_(against_vertical_ ? scenario.firmware.floor.pattern.standing_s : scenario.firmware.reflex.standing_s),
      time_zero_s_(scenario.sim.time_zero_s),
      payload_count_(scenario.sim.payloads.size()),
      removal_count_(static_cast<std::size_t>(std::ranges::count_if(
          scenario.sim.payloads, [](const auto& payload) { return payload.removed_at_s < sim_hw::kNever_s; }))),
      push_count_(scenario.sim.pushes.size()),
      has_faults_(!scenario.sim.faults.empty()),
      aftermath_s_(0.5 * walk_.cycle_s()),
      disturbed_until_s_(-sim_hw::kNever_s) {
  partial_.ended_at_s = -time_zero_s_;
  partial_.events.reserve(kMaxEvents);
}

void Judge::go_on_with(const scenario::Scenario& scenario) {
  const Judge asked(scenario);
  limits_ = asked.limits_;
  payload_count_ = asked.payload_count_;
  removal_count_ = asked.removal_count_;
  push_count_ = asked.push_count_;
  partial_.events.reserve(kMaxEvents);
}

void Judge::observe(const TickOutput& output, const sim_hw::GroundTruth& truth,
                    std::span<const RunEvent> events) noexcept {
  const double time_s = output.tick * period_s_ - time_zero_s_;
  partial_.ended_at_s = time_s;
  const bool is_scored = time_s >= 0.0;
  const sim_hw::Inclination torso =
      against_vertical_ ? sim_hw::inclination(truth, floor_) : sim_hw::Inclination{truth.roll_rad, truth.pitch_rad};
  (is_scored ? partial_.torso_pitch_deg : partial_.start_up_pitch_deg).include(torso.pitch_rad * kDegreesPerRadian);
  (is_scored ? partial_.torso_roll_deg : partial_.start_up_roll_deg).include(torso.roll_rad * kDegreesPerRadian);

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

  count_payloads(truth);
  if (pushes_acting_ > 0) disturbed_until_s_ = time_s;
  for (const RunEvent& event : events) take(event, time_s);
  observe_gait(output, time_s);
  if (is_scored && phase_ == decision::ReflexPhase::kWalking && truth.payloads_hung == 0) {
    partial_.unloaded_margin_n.include(output.decision.threshold_n - output.estimate.filtered_force_n);
  }

  has_fallen_ = truth.has_fallen;
  fault_ = output.fault;
}

void Judge::count_payloads(const sim_hw::GroundTruth& truth) noexcept {
  unnoticed_payloads_ += truth.payloads_hung - partial_.payloads_attached;
  unnoticed_payloads_ = std::min(unnoticed_payloads_, truth.payloads_hung - truth.payloads_removed);
  partial_.payloads_attached = truth.payloads_hung;
  partial_.payloads_removed = truth.payloads_removed;
}

void Judge::take(const RunEvent& event, double time_s) noexcept {
  if (partial_.events.size() < kMaxEvents) partial_.events.push_back({event.name, time_s});
  switch (event.code) {
    case event_t::PAYLOAD_REMOVED:
      disturbed_until_s_ = time_s;
      break;
    case event_t::PUSH_BEGINS:
      ++pushes_acting_;
      disturbed_until_s_ = time_s;
      break;
    case event_t::PUSH_ENDS:
      --pushes_acting_;
      ++partial_.pushes;
      disturbed_until_s_ = time_s;
      break;
    case event_t::PAYLOAD_DETECTED:
    case event_t::BALANCE_LOST:  // answers a load as well, should it be felt sooner than weighed
    case event_t::PAYLOAD_SEEN:
      count_detection(event.code != event_t::PAYLOAD_SEEN, time_s);
      break;
    default:
      break;
  }
}

void Judge::count_detection(bool is_answered, double time_s) noexcept {
  const bool was_disturbed = partial_.payloads_attached > 0 || disturbed_until_s_ > -sim_hw::kNever_s;
  if (unnoticed_payloads_ > 0) {
    --unnoticed_payloads_;
    ++partial_.payloads_detected;
  } else if (time_s <= disturbed_until_s_ + aftermath_s_) {
    ++partial_.disturbance_triggers;
  } else if (is_answered || !was_disturbed) {
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
  const double since_s = std::max(walking_since_s_, pushes_acting_ > 0 ? time_s + period_s_ : disturbed_until_s_);
  partial_.cycles_after_recovery = std::max(0.0, time_s + period_s_ - since_s) / walk_.cycle_s();
  const bool is_single = !gait::is_double_support(walk_, decision.walk_phase_s);
  if (is_single_support_ && !is_single && time_s >= 0.0) ++partial_.steps_walked;
  is_single_support_ = is_single;
}

bool Judge::has_recovered() const noexcept {
  if (has_faults_ || payload_count_ + push_count_ == 0) return false;
  if (method_ == decision::ReflexMethod::kOff && payload_count_ > 0) return false;  // its load never is answered
  const auto has_seen_all = [](int count, std::size_t all) { return static_cast<std::size_t>(count) >= all; };
  return has_seen_all(partial_.payloads_detected, payload_count_) &&
         has_seen_all(partial_.payloads_removed, removal_count_) && has_seen_all(partial_.pushes, push_count_) &&
         phase_ == decision::ReflexPhase::kWalking &&
         partial_.cycles_after_recovery >= limits_.min_cycles_after_recovery;
}

void Judge::decide_outcome(Verdict& verdict, bool was_interrupted) const {
  const auto decide = [&verdict](Outcome outcome, std::string reason) {
    verdict.outcome = outcome;
    verdict.reason = std::move(reason);
  };
  const double largest_pitch_deg = verdict.torso_pitch_deg.largest_magnitude();
  const double largest_roll_deg = verdict.torso_roll_deg.largest_magnitude();
  const bool is_answered =
      method_ != decision::ReflexMethod::kOff && (verdict.payloads_detected > 0 || verdict.disturbance_triggers > 0);
  const bool needs_recovery = is_answered || removal_count_ > 0 || push_count_ > 0;
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
  } else if (static_cast<std::size_t>(verdict.payloads_removed) < removal_count_) {
    decide(Outcome::kLimit, fmt::format("only {} of {} payloads were taken off before the end; raise duration_s",
                                        verdict.payloads_removed, removal_count_));
  } else if (static_cast<std::size_t>(verdict.pushes) < push_count_) {
    decide(Outcome::kLimit,
           fmt::format("only {} of {} pushes were over before the end; raise duration_s", verdict.pushes, push_count_));
  } else if (verdict.false_alarms > 0) {
    decide(Outcome::kLimit,
           fmt::format("the payload detector fired {} time(s) without a payload", verdict.false_alarms));
  } else if (needs_recovery && verdict.cycles_after_recovery < limits_.min_cycles_after_recovery) {
    decide(Outcome::kLimit,
           fmt::format("{:.4f} cycles walked after {}, limits.min_cycles_after_recovery is {}; a longer "
                       "duration_s may be all it needs",
                       verdict.cycles_after_recovery, is_answered ? "recovery" : "the last removal or push",
                       limits_.min_cycles_after_recovery));
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
