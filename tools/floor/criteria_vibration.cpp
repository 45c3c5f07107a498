#include <algorithm>
#include <cmath>
#include <numeric>

#include "tools/floor/criteria_quantities.hpp"

namespace surefoot::floor {
namespace {

constexpr double kLegPeriod_s = 0.23;  // 2 pi / sqrt(746.2 / s2), Kim, Park, Oh 2007, eq. (17)
constexpr double kVibrates_s = 1.0;

/// The series without its mean over `length` samples about each; shorter by as many.
std::vector<double> without_mean(const std::vector<double>& values, std::size_t length) {
  std::vector<double> rest;
  for (std::size_t i = 0; i + length < values.size(); ++i) {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(i);
    const double sum = std::accumulate(begin, begin + static_cast<std::ptrdiff_t>(length), 0.0);
    rest.push_back(values[i + length / 2] - sum / static_cast<double>(length));
  }
  return rest;
}

double largest(const std::vector<double>& values, std::size_t from, std::size_t count) {
  double magnitude = 0.0;
  for (std::size_t i = from; i < from + count; ++i) magnitude = std::max(magnitude, std::abs(values[i]));
  return magnitude;
}

}  // namespace

Samples vibration_left_percent(const ObservedWalk& walk) {
  const auto swings = [](const ObservedTick& tick) { return decision::is_lifting(tick.walk.stage); };
  const auto lift = std::ranges::find_if(walk.ticks, swings);
  const auto top = std::find_if_not(lift, walk.ticks.end(), swings);
  if (lift == top) return {};
  const std::size_t foot = index(lift->walk.moving);
  const auto carries = [&](const ObservedTick& tick) { return tick.force_n[foot] > 0.0; };
  auto free = top;  // from here on the foot touches nothing
  while (free != lift && !carries(*std::prev(free))) --free;

  const std::size_t period = walk.ticks_in(kLegPeriod_s);
  const auto since_lift = static_cast<std::size_t>(free - lift);
  std::vector<double> rate_rad_s;
  const auto before = static_cast<std::ptrdiff_t>(period);
  if (lift - walk.ticks.begin() < before) return {};
  for (auto tick = lift - before; tick != top; ++tick) rate_rad_s.push_back(tick->hip_joint_rate_rad_s[foot]);
  // The first sample belongs to the lift: two means take half a period each from the begin.
  const std::vector<double> vibration = without_mean(without_mean(rate_rad_s, period), period);
  const std::size_t later = since_lift + walk.ticks_in(kVibrates_s);
  if (vibration.size() < later + period) return {};
  const double first = largest(vibration, since_lift, period);
  return first > 0.0 ? Samples{100.0 * largest(vibration, later, period) / first} : Samples{};
}

}  // namespace surefoot::floor
