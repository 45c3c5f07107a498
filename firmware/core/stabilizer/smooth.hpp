#pragma once

#include <cmath>

#include "firmware/core/stabilizer/gradual.hpp"

namespace surefoot::stabilizer {

/// A first-order lag, exact for an input that holds over the period; never overshoots.
[[nodiscard]] inline double lagged(double value, double target, double time_constant_s, double period_s) noexcept {
  return value + low_pass_share(period_s, time_constant_s) * (target - value);
}

/// Whether every value may enter a filter: a number, and not so large that arithmetic with it could overflow.
template <typename... Values>
[[nodiscard]] bool are_usable(Values... values) noexcept {
  return ((std::abs(values) < 1e6) && ...);
}

/// Whether a period may enter a filter: positive, and no gap in the control.
[[nodiscard]] inline bool is_usable_period(double period_s) noexcept { return period_s > 0.0 && period_s <= 0.1; }

/// A roll angle, rate or moment of the torso's sign (positive to the right) as one toward `foot`; its own inverse.
[[nodiscard]] constexpr double toward(Side foot, double roll) noexcept { return -lateral_sign(foot) * roll; }

}  // namespace surefoot::stabilizer
