#include "firmware/core/safety/encoder_check.hpp"

#include <cmath>

namespace surefoot::safety {
namespace {

/// Across a longer gap two rates say little of the way between them.
constexpr std::uint32_t kLongestGapTicks = 5;

}  // namespace

bool are_encoders_plausible(const EncoderCheckConfig& config, EncoderCheckState& state, const PerSide<LegSensors>& legs,
                            double period_s) noexcept {
  const double kept = 1.0 - period_s / config.time_constant_s;
  bool plausible = true;
  for (std::size_t leg = 0; leg < legs.size(); ++leg) {
    const LegSensors& now = legs[leg];
    ++state.elapsed_ticks[leg];
    const double elapsed_s = state.elapsed_ticks[leg] * period_s;
    for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
      double& residual_rad = state.residual_rad[leg][joint];
      residual_rad *= kept;
      if (!now.freshness.is_fresh()) continue;
      if (state.was_heard[leg] && state.elapsed_ticks[leg] <= kLongestGapTicks) {
        const double rate_rad_s = 0.5 * (now.rate_rad_s[joint] + state.last_rate_rad_s[leg][joint]);
        residual_rad += now.angle_rad[joint] - state.last_angle_rad[leg][joint] - rate_rad_s * elapsed_s;
      }
      plausible = plausible && std::abs(residual_rad) <= config.residual_limit_rad;
    }
    if (!now.freshness.is_fresh()) continue;
    state.last_angle_rad[leg] = now.angle_rad;
    state.last_rate_rad_s[leg] = now.rate_rad_s;
    state.elapsed_ticks[leg] = 0;
    state.was_heard[leg] = true;
  }
  return plausible;
}

}  // namespace surefoot::safety
