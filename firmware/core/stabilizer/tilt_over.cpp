#include "firmware/core/stabilizer/tilt_over.hpp"

namespace surefoot::stabilizer {

Adjustment step(const TiltOverConfig& config, TiltOverState& state, const StabilizerInput& input,
                bool is_active) noexcept {
  const PhaseSample& now = input.measured;
  const PhaseSample& flat = input.nominal;
  const double roll_rad = beyond_band(deviation(now.torso_roll_rad, flat.torso_roll_rad), config.band_rad);
  const double rate_rad_s =
      beyond_band(deviation(now.torso_roll_rate_rad_s, flat.torso_roll_rate_rad_s), config.rate_band_rad_s);
  const double against_rad = within(config.gain * roll_rad + config.rate_gain_s * rate_rad_s, config.max_angle_rad);

  Adjustment adjustment;
  for (const Side side : kSides) {
    const bool acts = is_active && side == input.walk.support() && input.ankle[index(side)].carries();
    approach(state.added_roll_rad[index(side)], acts ? against_rad : 0.0,
             low_pass_share(input.period_s, config.smoothing_s));
    adjustment.ankle_roll_rad[index(side)] = state.added_roll_rad[index(side)];
  }
  return adjustment;
}

}  // namespace surefoot::stabilizer
