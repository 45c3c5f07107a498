#include "firmware/core/decision/payload_detector.hpp"

#include <algorithm>

#include "firmware/core/decision/tick_time.hpp"

namespace surefoot::decision {

bool step(const PayloadDetectorConfig& config, PayloadDetectorState& state, double filtered_force_n,
          std::int64_t walked_ticks, double period_s) noexcept {
  if (state.stage == DetectorStage::kWarmUp && walked_ticks >= first_tick_at(config.warm_up_s, period_s)) {
    state.stage = DetectorStage::kLearning;
    state.largest_force_n = filtered_force_n;
  }
  if (state.stage == DetectorStage::kLearning) {
    if (walked_ticks < first_tick_at(config.warm_up_s + config.learning_s, period_s)) {
      state.largest_force_n = std::max(state.largest_force_n, filtered_force_n);
    } else {
      state.stage = DetectorStage::kArmed;
      state.threshold_n = state.largest_force_n + config.margin_n;
    }
  }
  if (state.stage != DetectorStage::kArmed) return false;

  const bool was_above = state.is_above;
  state.is_above = filtered_force_n > state.threshold_n;
  return state.is_above && !was_above;
}

void carry_threshold(PayloadDetectorState& state, double weight_change_n) noexcept {
  state.threshold_n += weight_change_n;
  state.is_above = false;
}

}  // namespace surefoot::decision
