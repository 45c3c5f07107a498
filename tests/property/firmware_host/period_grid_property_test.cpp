#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <vector>

#include "firmware/host/realtime/period_grid.hpp"

namespace surefoot::host {
namespace {

constexpr std::int64_t kDayNs = 86'400'000'000'000;

/// Each tick's duration in thousandths of a period: mostly short, now and then many periods.
rc::Gen<std::vector<std::int64_t>> durations_permille() {
  return rc::gen::container<std::vector<std::int64_t>>(
      rc::gen::weightedOneOf<std::int64_t>({{4, rc::gen::inRange<std::int64_t>(0, 1000)},
                                            {1, rc::gen::element<std::int64_t>(1000, 1001, 2000, 2001)},
                                            {1, rc::gen::inRange<std::int64_t>(1000, 50'000)}}));
}

RC_GTEST_PROP(PeriodGrid, KeepsItsPhaseNeverWaitsForThePastAndAccountsForEveryTick, ()) {
  const auto start_ns = *rc::gen::inRange<std::int64_t>(-kDayNs, kDayNs);
  const auto period_ns = *rc::gen::inRange<std::int64_t>(1, 10'000'000);
  PeriodGrid grid(start_ns, period_ns);
  std::int64_t ran = 0;
  std::int64_t missed = 0;
  for (const std::int64_t permille : *durations_permille()) {
    const std::int64_t tick = grid.tick();
    const std::int64_t now_ns = grid.due_ns() + permille * period_ns / 1000;
    const Wake wake = grid.advance(now_ns);
    ++ran;
    missed += wake.missed;
    RC_ASSERT((wake.due_ns - start_ns) % period_ns == 0);
    RC_ASSERT(wake.due_ns >= now_ns);
    RC_ASSERT(wake.tick == tick + 1 || wake.due_ns - now_ns < period_ns);  // the first that can be met, no later
    RC_ASSERT(wake.missed == wake.tick - tick - 1);
    RC_ASSERT(wake.tick == grid.tick() && wake.due_ns == grid.due_ns());
  }
  RC_ASSERT(ran + missed == (grid.due_ns() - start_ns) / period_ns);
  RC_ASSERT(missed == grid.missed_ticks());
  RC_ASSERT(grid.overruns() <= grid.missed_ticks());
}

/// The policy as it reads, over a list of all missed ticks.
bool is_too_much(const std::vector<std::int64_t>& missed, const OverrunPolicy& policy) {
  return std::any_of(missed.begin(), missed.end(), [&](std::int64_t last) {
    const auto counted = std::count_if(missed.begin(), missed.end(), [&](std::int64_t tick) {
      return tick <= last && tick > last - policy.window_ticks;
    });
    return counted >= policy.degrade_after_missed_ticks;
  });
}

RC_GTEST_PROP(PeriodGrid, IsDegradedWhenAndOnlyWhenAWindowHoldsTooManyMissedTicks, ()) {
  OverrunPolicy policy;
  policy.degrade_after_missed_ticks = *rc::gen::inRange(1, 30);
  policy.window_ticks = policy.degrade_after_missed_ticks + *rc::gen::inRange<std::int64_t>(0, 60);
  PeriodGrid grid(0, 1000, policy);
  std::vector<std::int64_t> missed;
  for (const std::int64_t permille : *durations_permille()) {
    const std::int64_t tick = grid.tick();
    const Wake wake = grid.advance(grid.due_ns() + permille);
    for (std::int64_t skipped = tick + 1; skipped < wake.tick; ++skipped) missed.push_back(skipped);
    RC_ASSERT(grid.is_degraded() == is_too_much(missed, policy));
  }
}

}  // namespace
}  // namespace surefoot::host
