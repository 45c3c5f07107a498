#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

#include "tools/floor/criteria_quantities.hpp"

namespace surefoot::floor {
namespace {

constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;
constexpr double kSettled_s = 15.0;  // after power-up; the issue's
constexpr double kMean_s = 0.5;
constexpr double kAfterPush_s = 2.0;
constexpr double kTwoCycles_s = 4 * 0.95;

using Ticks = std::span<const ObservedTick>;

/// The part of a walk in the times [from, to), s on the scenario's clock; empty when the walk ended before.
Ticks between(const ObservedWalk& walk, double from_s, double to_s) {
  const auto place = [&](double time_s) {
    return std::ranges::partition_point(
        walk.ticks, [&](const ObservedTick& tick) { return tick.time_s < time_s - 0.5 * walk.period_s; });
  };
  const auto end = place(to_s);
  if (end == walk.ticks.end() && walk.has_fallen) return {};
  return {place(from_s), end};
}

template <typename Value>
double mean(Ticks ticks, Value value) {
  double sum = 0.0;
  for (const ObservedTick& tick : ticks) sum += value(tick);
  return sum / static_cast<double>(ticks.size());
}

template <typename Value>
Samples when_settled(const ObservedWalk& walk, Value value) {
  const std::size_t end = walk.ticks_in(kSettled_s);
  const std::size_t length = walk.ticks_in(kMean_s);
  if (walk.ticks.size() < end) return {};
  return {mean(Ticks(walk.ticks).subspan(end - length, length), value)};
}

}  // namespace

Samples commanded_leg_correction_mm(const ObservedWalk& walk) {
  return when_settled(walk, [](const ObservedTick& tick) {
    const PerSide<double>& length_m = tick.total.leg_length_m;
    return 500.0 * (length_m[index(Side::kRight)] - length_m[index(Side::kLeft)]);
  });
}

Samples commanded_ankle_roll_deg(const ObservedWalk& walk) {
  return when_settled(walk, [](const ObservedTick& tick) {
    const PerSide<double>& roll_rad = tick.total.ankle_roll_rad;
    return 0.5 * kDegreesPerRadian * (roll_rad[0] + roll_rad[1]);
  });
}

Samples true_leg_correction_mm(const ObservedWalk& walk) {
  return when_settled(walk, [](const ObservedTick& tick) {
    return 500.0 * (tick.foot_body_m[index(Side::kLeft)].z() - tick.foot_body_m[index(Side::kRight)].z());
  });
}

Samples true_ankle_roll_deg(const ObservedWalk& walk) {
  return when_settled(walk, [](const ObservedTick& tick) {
    return 0.5 * kDegreesPerRadian * (tick.ankle_roll_rad[0] + tick.ankle_roll_rad[1]);
  });
}

Samples torso_lean_deg(const ObservedWalk& walk) {
  return when_settled(walk, [](const ObservedTick& tick) { return kDegreesPerRadian * std::abs(tick.torso.roll_rad); });
}

Samples zmp_error_mm(const ObservedWalk& walk) {
  double squares_m2 = 0.0;
  std::size_t count = 0;
  for (const ObservedTick& tick : walk.ticks) {
    if (tick.time_s < 0.0 || !tick.walk.is_swinging() || !tick.ankle[index(tick.walk.support())].carries()) continue;
    const double x_m = tick.measured.zmp_x_foot_m - tick.nominal.zmp_x_foot_m;
    const double y_m = tick.measured.zmp_y_foot_m - tick.nominal.zmp_y_foot_m;
    squares_m2 += x_m * x_m + y_m * y_m;
    ++count;
  }
  return count == 0 ? Samples{} : Samples{1e3 * std::sqrt(squares_m2 / static_cast<double>(count))};
}

Samples zmp_peak_error_mm(const ObservedWalk& walk) {
  if (walk.ticks.empty()) return {};
  Samples samples;
  std::optional<std::pair<double, double>> outermost_m;  // measured, nominal
  for (const ObservedTick& tick : walk.ticks) {
    if (tick.walk.begins_step) {
      if (outermost_m) samples.push_back(1e3 * std::abs(outermost_m->first - outermost_m->second));
      outermost_m.reset();
    }
    const bool is_middle = tick.walk.is_swinging() && tick.walk.swing_share > 0.25 && tick.walk.swing_share < 0.75;
    if (!is_middle || tick.time_s < 0.5 * walk.ticks.back().time_s) continue;
    const double outwards = lateral_sign(tick.walk.support());
    const double measured_m = outwards * tick.measured.zmp_y_foot_m;
    const double nominal_m = outwards * tick.nominal.zmp_y_foot_m;
    if (!outermost_m) outermost_m = {measured_m, nominal_m};
    outermost_m = {std::max(outermost_m->first, measured_m), std::max(outermost_m->second, nominal_m)};
  }
  return samples;
}

Samples mean_tilt_deg(const ObservedWalk& walk) {
  if (walk.ticks.empty() || walk.has_fallen) return {};
  const double end_s = walk.ticks.back().time_s;
  const Ticks last = between(walk, end_s - kTwoCycles_s, end_s);
  const double roll_rad = mean(last, [](const ObservedTick& tick) { return tick.torso.roll_rad; });
  const double pitch_rad = mean(last, [](const ObservedTick& tick) { return tick.torso.pitch_rad; });
  return {kDegreesPerRadian * std::hypot(roll_rad, pitch_rad)};
}

Samples rate_after_push_deg_s(const ObservedWalk& walk) {
  const Ticks after = between(walk, walk.push_s, walk.push_s + kAfterPush_s);
  if (after.empty()) return {};
  const double square = mean(after, [](const ObservedTick& tick) {
    const double rate_rad_s = tick.measured.torso_roll_rate_rad_s - tick.nominal.torso_roll_rate_rad_s;
    return rate_rad_s * rate_rad_s;
  });
  return {kDegreesPerRadian * std::sqrt(square)};
}

Samples roll_after_push_deg(const ObservedWalk& walk) {
  double most_rad = 0.0;
  const Ticks after = between(walk, walk.push_s, walk.push_s + kAfterPush_s);
  if (after.empty()) return {};
  for (const ObservedTick& tick : after) {
    most_rad = std::max(most_rad, std::abs(tick.torso.roll_rad - tick.nominal.torso_roll_rad));
  }
  return {kDegreesPerRadian * most_rad};
}

}  // namespace surefoot::floor
