#include "firmware/core/stabilizer/ground_seeking.hpp"

#include <algorithm>

#include "firmware/core/stabilizer/gradual.hpp"

namespace surefoot::stabilizer {

Adjustment step(const GroundSeekingConfig& config, GroundSeekingState& state, const StabilizerInput& input,
                bool is_active) noexcept {
  const WalkView& walk = input.walk;
  const Side landing = walk.moving;  // in the double support that begins a step: the foot that was to land
  if (walk.begins_step) state.seeks[index(landing)] = true;
  if (walk.is_swinging()) state.seeks[index(walk.moving)] = false;

  Adjustment adjustment;
  for (const Side side : kSides) {
    bool& seeks = state.seeks[index(side)];
    seeks = seeks && is_active && !input.ankle[index(side)].carries();
    double& length_m = state.length_m[index(side)];
    length_m = seeks ? slewed(length_m, config.max_length_m, config.speed_m_s, input.period_s)
                     : lagged(length_m, 0.0, config.settling_s, input.period_s);
    adjustment.leg_length_m[index(side)] = length_m;
  }
  return adjustment;
}

}  // namespace surefoot::stabilizer
