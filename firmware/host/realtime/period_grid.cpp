#include "firmware/host/realtime/period_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace surefoot::host {

PeriodGrid::PeriodGrid(std::int64_t start_ns, std::int64_t period_ns, const OverrunPolicy& policy)
    : start_ns_(start_ns), period_ns_(period_ns), policy_(policy) {
  if (period_ns <= 0) throw std::invalid_argument(fmt::format("period is {} ns; expected more than 0", period_ns));
  const int limit = policy.degrade_after_missed_ticks;
  if (limit < 0 || limit > OverrunPolicy::kMostMissedTicks) {
    throw std::invalid_argument(
        fmt::format("degrade_after_missed_ticks is {}; expected 0 to {}", limit, OverrunPolicy::kMostMissedTicks));
  }
  if (policy.window_ticks < limit) {
    throw std::invalid_argument(fmt::format(
        "window_ticks is {}; expected at least the {} missed ticks that it shall count", policy.window_ticks, limit));
  }
}

Wake PeriodGrid::advance(std::int64_t now_ns) noexcept {
  const std::int64_t next_due_ns = due_ns() + period_ns_;
  std::int64_t missed = 0;
  if (now_ns > next_due_ns) {
    missed = (now_ns - next_due_ns - 1) / period_ns_ + 1;  // rounded up: the next instant is not in the past
    ++overruns_;
    missed_ticks_ += missed;
    judge(tick_ + 1, missed);
  }
  tick_ += missed + 1;
  return {tick_, due_ns(), missed};
}

void PeriodGrid::judge(std::int64_t first_missed_tick, std::int64_t missed) noexcept {
  const auto limit = static_cast<std::size_t>(policy_.degrade_after_missed_ticks);
  if (limit == 0 || is_degraded_) return;
  // More than the ring's length in one go is as bad as exactly that.
  const std::int64_t counted = std::min<std::int64_t>(missed, policy_.degrade_after_missed_ticks);
  for (std::int64_t i = 0; i < counted; ++i) {
    const std::int64_t tick = first_missed_tick + i;
    latest_missed_[noted_ % limit] = tick;
    ++noted_;
    if (noted_ < limit) continue;
    const std::int64_t oldest = latest_missed_[noted_ % limit];
    if (tick - oldest < policy_.window_ticks) is_degraded_ = true;
  }
}

}  // namespace surefoot::host
