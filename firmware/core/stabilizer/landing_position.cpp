#include "firmware/core/stabilizer/landing_position.hpp"

#include <algorithm>

#include "firmware/core/stabilizer/gradual.hpp"

namespace surefoot::stabilizer {
namespace {

constexpr double kGravity_m_s2 = 9.81;

double wanted_outward_m(const LandingPositionConfig& config, const StabilizerInput& input) noexcept {
  const auto distance_m = [&](const PhaseSample& sample) {
    return landing_distance_m(config, input.body_mass_kg, toward(input.walk.moving, sample.support_roll_rate_rad_s));
  };
  const double expected_m = config.uses_nominal ? distance_m(input.nominal) : config.printed_distance_m;
  return within(config.kp * (distance_m(input.measured) - expected_m), config.max_shift_m);  // eq. (15)
}

}  // namespace

double landing_distance_m(const LandingPositionConfig& config, double body_mass_kg, double rate_toward_rad_s) noexcept {
  const double stopped_nms = config.inertia_kg_m2 * rate_toward_rad_s - config.printed_momentum_nms;
  return stopped_nms / (config.contact_s * body_mass_kg * kGravity_m_s2);
}

Adjustment step(const LandingPositionConfig& config, LandingPositionState& state, const StabilizerInput& input,
                bool is_active) noexcept {
  const WalkView& walk = input.walk;
  if (is_usable_period(input.period_s)) {
    if (!is_active) {
      state.shift_y_m = lagged(state.shift_y_m, 0.0, config.fade_s, input.period_s);
    } else if (are_usable(input.measured.support_roll_rate_rad_s, input.nominal.support_roll_rate_rad_s,
                          walk.swing_share, input.body_mass_kg) &&
               input.body_mass_kg > 1.0) {
      const bool is_frozen = walk.is_double_support || walk.has_landed ||
                             (1.0 - walk.swing_share) * config.single_support_s < config.freeze_s;
      if (!is_frozen) {
        const double wanted_m = lateral_sign(walk.moving) * wanted_outward_m(config, input);
        const double eased_m = lagged(state.shift_y_m, wanted_m, config.smoothing_s, input.period_s);
        state.shift_y_m = slewed(state.shift_y_m, eased_m, config.max_rate_m_s, input.period_s);
      }
    }
  }
  Adjustment adjustment;
  adjustment.landing_y_m = state.shift_y_m;
  return adjustment;
}

}  // namespace surefoot::stabilizer
