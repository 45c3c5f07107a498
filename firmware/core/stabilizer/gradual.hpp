#pragma once

#include <algorithm>
#include <cmath>

#include "firmware/core/stabilizer/walk_view.hpp"

/// What keeps the controllers' outputs from jumping and one bad value from staying in a state.
namespace surefoot::stabilizer {

/// One joint angle for each axis of a foot.
struct AnkleAngles {
  double roll_rad = 0.0;
  double pitch_rad = 0.0;
};

/// Share of the way to its input that a first-order low pass goes in one period, 1 - exp(-T / tau): 0 for a period that
/// is no number or not positive, 1 without a time constant.
[[nodiscard]] inline double low_pass_share(double period_s, double time_constant_s) noexcept {
  if (!(period_s > 0.0)) return 0.0;
  return time_constant_s > 0.0 ? -std::expm1(-period_s / time_constant_s) : 1.0;
}

/// Largest magnitude that may enter a filter: arithmetic with it does not overflow.
inline constexpr double kLargestUsable = 1e6;

/// Whether every value may enter a filter: a number, and not so large that arithmetic with it could overflow.
template <typename... Values>
[[nodiscard]] bool are_usable(Values... values) noexcept {
  return ((std::abs(values) < kLargestUsable) && ...);
}

/// Whether a period may enter a filter: positive, and no gap in the control.
[[nodiscard]] inline bool is_usable_period(double period_s) noexcept { return period_s > 0.0 && period_s <= 0.1; }

/// `value`, or 0 where it is not usable.
[[nodiscard]] inline double sound_or_zero(double value) noexcept { return are_usable(value) ? value : 0.0; }

/// How far a measurement is from flat walking; 0 where either is no sound number.
[[nodiscard]] inline double deviation(double measured, double nominal) noexcept {
  return sound_or_zero(measured - nominal);
}

/// What of `value` exceeds `band` to either side; 0 within it, without a step at its edge.
[[nodiscard]] inline double beyond_band(double value, double band) noexcept {
  return value - std::clamp(value, -band, band);
}

/// Clips to `limit` to either side.
[[nodiscard]] inline double within(double value, double limit) noexcept { return std::clamp(value, -limit, limit); }

/// Goes from `value` towards `target`, at most by `rate_per_s` times the period.
[[nodiscard]] inline double slewed(double value, double target, double rate_per_s, double period_s) noexcept {
  const double most = period_s > 0.0 ? rate_per_s * period_s : 0.0;
  return value + std::clamp(target - value, -most, most);
}

/// Goes `share` of the way to `target`.
inline void approach(double& value, double target, double share) noexcept { value += share * (target - value); }

inline void approach(AnkleAngles& value, const AnkleAngles& target, double share) noexcept {
  approach(value.roll_rad, target.roll_rad, share);
  approach(value.pitch_rad, target.pitch_rad, share);
}

/// A first-order lag, exact for an input that holds over the period; never overshoots.
[[nodiscard]] inline double lagged(double value, double target, double time_constant_s, double period_s) noexcept {
  approach(value, target, low_pass_share(period_s, time_constant_s));
  return value;
}

/// A roll angle, rate or moment of the torso's sign (positive to the right) as one toward `foot`; its own inverse.
[[nodiscard]] constexpr double toward(Side foot, double roll) noexcept { return -lateral_sign(foot) * roll; }

/// An adjustment of the ankles alone.
[[nodiscard]] inline Adjustment with_ankles(const PerSide<AnkleAngles>& ankle) noexcept {
  Adjustment adjustment;
  for (const Side side : kSides) {
    adjustment.ankle_roll_rad[index(side)] = ankle[index(side)].roll_rad;
    adjustment.ankle_pitch_rad[index(side)] = ankle[index(side)].pitch_rad;
  }
  return adjustment;
}

}  // namespace surefoot::stabilizer
