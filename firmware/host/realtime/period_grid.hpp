#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace surefoot::host {

/// When missed ticks become too many to walk on.
struct OverrunPolicy {
  static constexpr int kMostMissedTicks = 256;

  int degrade_after_missed_ticks = 50;  ///< so many within the window; 0: never. 0 to kMostMissedTicks.
                                        ///< By default 5 %: the walk bears 10 % of lost frames
  std::int64_t window_ticks = 1000;     ///< ticks looked back over, >= degrade_after_missed_ticks
};

/// Which tick comes next.
struct Wake {
  std::int64_t tick;    ///< counted from the grid's start
  std::int64_t due_ns;  ///< its instant; not before the `now_ns` that was asked with
  std::int64_t missed;  ///< ticks skipped before it: their instants passed while the last one was at work
};

/// The loop's absolute time grid: tick k is due at start + k * period, in integers, for all time. A tick
/// that ends late costs the ticks whose instants it covered, and never shifts the phase of the others.
/// Pure: the clock is the caller's.
class PeriodGrid {
 public:
  /// @param start_ns   instant of tick 0, on any clock that does not jump
  /// @param period_ns  > 0
  /// @throws std::invalid_argument on a period or policy out of range
  PeriodGrid(std::int64_t start_ns, std::int64_t period_ns, const OverrunPolicy& policy = {});

  /// The tick that is being waited for, or at work.
  [[nodiscard]] std::int64_t tick() const noexcept { return tick_; }

  /// Its instant.
  [[nodiscard]] std::int64_t due_ns() const noexcept { return start_ns_ + tick_ * period_ns_; }

  /// Goes on to the next tick that can still be met: one due at `now_ns` or later.
  ///
  /// @param now_ns  when the current tick's work ended; before its instant is fine
  Wake advance(std::int64_t now_ns) noexcept;

  /// Ticks whose work ended after the next one was due.
  [[nodiscard]] std::int64_t overruns() const noexcept { return overruns_; }

  /// Ticks skipped so far; at least one for each overrun.
  [[nodiscard]] std::int64_t missed_ticks() const noexcept { return missed_ticks_; }

  /// True from the moment that the policy's number of ticks was missed within its window, for good.
  /// The loop then has to ask for a safe stop.
  [[nodiscard]] bool is_degraded() const noexcept { return is_degraded_; }

 private:
  void judge(std::int64_t first_missed_tick, std::int64_t missed) noexcept;

  std::int64_t start_ns_;
  std::int64_t period_ns_;
  OverrunPolicy policy_;
  std::int64_t tick_ = 0;
  std::int64_t overruns_ = 0;
  std::int64_t missed_ticks_ = 0;
  bool is_degraded_ = false;
  /// The last `degrade_after_missed_ticks` missed ticks, as a ring: full, its oldest one decides.
  std::array<std::int64_t, OverrunPolicy::kMostMissedTicks> latest_missed_{};
  std::size_t noted_ = 0;
};

}  // namespace surefoot::host
