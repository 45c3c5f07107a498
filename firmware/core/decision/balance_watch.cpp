#include "firmware/core/decision/balance_watch.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot::decision {

bool is_balance_lost(double margin_rad_s, BalanceWatchState& state, DetectorStage stage, double roll_rate_rad_s,
                     double pitch_rate_rad_s) noexcept {
  const double rate_rad_s = std::max(std::abs(roll_rate_rad_s), std::abs(pitch_rate_rad_s));
  const bool is_learning = stage == DetectorStage::kLearning || stage == DetectorStage::kResuming;
  if (is_learning) state.largest_rate_rad_s = std::max(state.largest_rate_rad_s, rate_rad_s);
  return stage == DetectorStage::kArmed && rate_rad_s > state.largest_rate_rad_s + margin_rad_s;
}

}  // namespace surefoot::decision
