#include "firmware/core/stabilizer/soft_landing.hpp"

namespace surefoot::stabilizer {
namespace {

/// Where the ankle's spring and damper would come to rest under a moment.
double yielded_rad(const SoftLandingConfig& config, double moment_nm) noexcept {
  const double acting_nm = beyond_band(sound_or_zero(moment_nm), config.band_nm);
  return within(acting_nm / config.stiffness_nm_per_rad, config.max_angle_rad);
}

}  // namespace

Adjustment step(const SoftLandingConfig& config, SoftLandingState& state, const StabilizerInput& input,
                bool is_active) noexcept {
  for (const Side side : kSides) {
    AnkleAngles& angle = state.added_angle[index(side)];
    const auto& load = input.ankle[index(side)];
    if (is_active && side == input.walk.moving && load.carries()) {
      const AnkleAngles rest{yielded_rad(config, load.roll_moment_nm), yielded_rad(config, load.pitch_moment_nm)};
      approach(angle, rest, low_pass_share(input.period_s, config.damping_nm_s_per_rad / config.stiffness_nm_per_rad));
    } else {
      approach(angle, AnkleAngles{}, low_pass_share(input.period_s, config.fade_s));
    }
  }
  Adjustment adjustment = with_ankles(state.added_angle);
  adjustment.waits_for_contact = decision::is_lowering(input.walk.stage);
  return adjustment;
}

}  // namespace surefoot::stabilizer
