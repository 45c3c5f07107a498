#include "firmware/core/safety/foot_check.hpp"

#include <cmath>
#include <numeric>

namespace surefoot::safety {
namespace {

bool are_alive(const FootCheckConfig& config, FootCheckState& state, const PerSide<FootSensors>& feet, bool is_moving,
               double period_s) noexcept {
  bool alive = true;
  for (std::size_t foot = 0; foot < feet.size(); ++foot) {
    if (!feet[foot].freshness.is_fresh()) continue;
    for (std::size_t corner = 0; corner < geometry::kCornersPerFoot; ++corner) {
      const double force_n = feet[foot].corner_force_n[corner];
      std::uint32_t& ticks = state.frozen_ticks[foot][corner];
      ticks = is_moving && force_n == state.last_force_n[foot][corner] ? ticks + 1 : 0;
      const double allowed_s = std::abs(force_n) >= config.loaded_n ? config.frozen_loaded_s : config.frozen_s;
      alive = alive && ticks * period_s <= allowed_s;
    }
    state.last_force_n[foot] = feet[foot].corner_force_n;
  }
  return alive;
}

bool do_they_weigh(const FootCheckConfig& config, FootCheckState& state, const PerSide<FootSensors>& feet,
                   double weight_n, double period_s) noexcept {
  if (!feet[0].freshness.is_fresh() || !feet[1].freshness.is_fresh()) return true;
  double force_n = 0.0;
  for (const FootSensors& foot : feet) {
    force_n = std::accumulate(foot.corner_force_n.begin(), foot.corner_force_n.end(), force_n);
  }
  const bool right = force_n >= config.min_weight_share * weight_n && force_n <= config.max_weight_share * weight_n;
  state.wrong_weight_ticks = right || weight_n <= 0.0 ? 0 : state.wrong_weight_ticks + 1;
  return state.wrong_weight_ticks * period_s <= config.weight_s;
}

}  // namespace

bool are_feet_plausible(const FootCheckConfig& config, FootCheckState& state, const PerSide<FootSensors>& feet,
                        bool is_moving, double weight_n, double period_s) noexcept {
  const bool alive = are_alive(config, state, feet, is_moving, period_s);
  return do_they_weigh(config, state, feet, weight_n, period_s) && alive;
}

}  // namespace surefoot::safety
