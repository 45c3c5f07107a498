#pragma once

#include <cmath>
#include <cstdint>

namespace surefoot::decision {

/// The first tick whose time is not before `time_s`. A millionth of a tick early counts as on time,
/// so that 0.1 s at 1 ms is 100 ticks however the two were rounded.
[[nodiscard]] inline std::int64_t first_tick_at(double time_s, double period_s) noexcept {
  constexpr double kTolerance_ticks = 1.0e-6;
  return static_cast<std::int64_t>(std::ceil(time_s / period_s - kTolerance_ticks));
}

/// Time of a tick: one product, so that nothing accumulates.
[[nodiscard]] inline double time_of_tick(std::int64_t tick, double period_s) noexcept {
  return static_cast<double>(tick) * period_s;
}

}  // namespace surefoot::decision
