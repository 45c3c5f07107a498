#pragma once

#include <atomic>
#include <cstdint>

namespace surefoot::host {

/// CLOCK_MONOTONIC: steps of wall time (NTP, daylight saving) do not reach it.
class MonotonicClock {
 public:
  /// @param stop  set from outside, also by a signal handler, to end a wait early; outlives the clock
  explicit MonotonicClock(const std::atomic<bool>& stop) noexcept : stop_(stop) {}

  [[nodiscard]] static std::int64_t now_ns() noexcept;

  /// Waits for an instant; returns at once when it has passed. Signals that do not set `stop` do not
  /// shorten the wait.
  ///
  /// @return false when `stop` is set, before the wait or through a signal during it
  [[nodiscard]] bool sleep_until_ns(std::int64_t instant_ns) const noexcept;

 private:
  const std::atomic<bool>& stop_;
};

}  // namespace surefoot::host
