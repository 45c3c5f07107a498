#include "firmware/core/decision/payload_detector.hpp"

#include <algorithm>

#include "firmware/core/decision/tick_time.hpp"

namespace surefoot::decision {

namespace {

/// Between two instants of walking: `begin_s <= walked < end_s`.
bool is_within(double begin_s, double end_s, std::int64_t walked_ticks, double period_s) noexcept {
  return walked_ticks >= first_tick_at(begin_s, period_s) && walked_ticks < first_tick_at(end_s, period_s);
}

void arm(PayloadDetectorState& state, double threshold_n) noexcept {
  state.stage = DetectorStage::kArmed;
  state.threshold_n = threshold_n;
  state.carried_n = threshold_n;
}

void learn(const PayloadDetectorConfig& config, PayloadDetectorState& state, double filtered_force_n,
           std::int64_t walked_ticks, double period_s) noexcept {
  const bool is_first = state.stage != DetectorStage::kResuming;
  const double end_s = config.warm_up_s + (is_first ? config.learning_s : config.relearning_s);
  if (is_within(config.warm_up_s, end_s, walked_ticks, period_s)) {
    if (is_first) state.stage = DetectorStage::kLearning;
    state.largest_force_n = std::max(state.largest_force_n, filtered_force_n);
  } else if (walked_ticks >= first_tick_at(end_s, period_s)) {
    const double learned_n = state.largest_force_n + config.margin_n;
    arm(state, is_first ? learned_n : std::clamp(learned_n, state.carried_n, state.threshold_n));
  }
}

}  // namespace

bool step(const PayloadDetectorConfig& config, PayloadDetectorState& state, double filtered_force_n,
          std::int64_t walked_ticks, double period_s) noexcept {
  if (state.stage != DetectorStage::kArmed) learn(config, state, filtered_force_n, walked_ticks, period_s);
  if (state.stage == DetectorStage::kWarmUp || state.stage == DetectorStage::kLearning) return false;

  const bool was_above = state.is_above;
  state.is_above = filtered_force_n > state.threshold_n;
  return state.is_above && !was_above;
}

void rearm(const PayloadDetectorConfig& config, PayloadDetectorState& state, double weight_change_n) noexcept {
  state.stage = DetectorStage::kResuming;
  state.carried_n += weight_change_n;
  state.threshold_n = state.carried_n + config.resume_margin_n;
  state.largest_force_n = 0.0;
  state.is_above = false;
}

}  // namespace surefoot::decision
