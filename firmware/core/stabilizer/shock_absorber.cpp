#include "firmware/core/stabilizer/shock_absorber.hpp"

#include <algorithm>
#include <cmath>

#include "firmware/core/stabilizer/gradual.hpp"

namespace surefoot::stabilizer {
namespace {

constexpr double kLongestStep_s = 1e-3;

/// The trapezoidal rule: stable for every period, mass and stiffness.
void advance(const ShockAbsorberConfig& config, ShockAbsorberState& state, double force_n, double step_s) noexcept {
  const double half_damping = 0.5 * step_s * config.damping_ns_per_m;
  const double quarter_stiffness = 0.25 * step_s * step_s * config.stiffness_n_per_m;
  const double velocity_m_s = (state.velocity_m_s * (config.mass_kg - half_damping - quarter_stiffness) -
                               step_s * (force_n + config.stiffness_n_per_m * state.offset_m)) /
                              (config.mass_kg + half_damping + quarter_stiffness);
  const double offset_m = state.offset_m + 0.5 * step_s * (state.velocity_m_s + velocity_m_s);
  state.offset_m = std::clamp(offset_m, -config.max_offset_m, 0.0);
  state.velocity_m_s = state.offset_m == offset_m ? velocity_m_s : 0.0;
}

void absorb(const ShockAbsorberConfig& config, ShockAbsorberState& state, double force_n, double period_s) noexcept {
  const int steps = std::max(1, static_cast<int>(std::ceil(period_s / kLongestStep_s - 1e-6)));
  for (int i = 0; i < steps; ++i) advance(config, state, force_n, period_s / steps);
}

void wash_out(const ShockAbsorberConfig& config, ShockAbsorberState& state, double period_s) noexcept {
  state.offset_m = lagged(state.offset_m, 0.0, config.washout_s, period_s);
  state.velocity_m_s = 0.0;
}

}  // namespace

Adjustment step(const ShockAbsorberConfig& config, ShockAbsorberState& state, const StabilizerInput& input,
                bool is_active) noexcept {
  const WalkView& walk = input.walk;
  const estimation::AnkleLoad& load = input.ankle[index(walk.moving)];
  if (is_usable_period(input.period_s) && are_usable(load.normal_force_n)) {
    const bool is_early = decision::is_lowering(walk.stage) && !walk.is_double_support && load.carries() &&
                          walk.swing_share < config.latest_share;
    state.is_absorbing = is_active && (state.is_absorbing || is_early);
    if (state.is_absorbing) {
      absorb(config, state, std::max(load.normal_force_n, 0.0), input.period_s);
    } else {
      wash_out(config, state, input.period_s);
    }
  }
  Adjustment adjustment;
  adjustment.pelvis_z_m = state.offset_m;
  adjustment.holds_lowering = state.is_absorbing;
  return adjustment;
}

}  // namespace surefoot::stabilizer
