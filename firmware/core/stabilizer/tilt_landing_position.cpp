#include "firmware/core/stabilizer/tilt_landing_position.hpp"

namespace surefoot::stabilizer {
namespace {

double shift_m(const TiltLandingPositionConfig& config, double tilt_rad, double rate_rad_s) noexcept {
  return beyond_band(config.gain_m_per_rad * tilt_rad + config.rate_gain_m_s_rad * rate_rad_s, config.band_m);
}

/// Where the torso leans and falls to. Roll is positive to the right, y to the left.
LandingShift wanted(const TiltLandingPositionConfig& config, const StabilizerInput& input) noexcept {
  const PhaseSample& now = input.measured;
  const PhaseSample& flat = input.nominal;
  const LandingShift shift{shift_m(config, deviation(now.torso_pitch_rad, flat.torso_pitch_rad),
                                   deviation(now.torso_pitch_rate_rad_s, flat.torso_pitch_rate_rad_s)),
                           -shift_m(config, deviation(now.torso_roll_rad, flat.torso_roll_rad),
                                    deviation(now.torso_roll_rate_rad_s, flat.torso_roll_rate_rad_s))};
  return clipped(shift, {config.max_shift_m, config.max_shift_m, config.max_inward_m}, input.walk.moving);
}

}  // namespace

Adjustment step(const TiltLandingPositionConfig& config, TiltLandingPositionState& state, const StabilizerInput& input,
                bool is_active) noexcept {
  const double share = low_pass_share(input.period_s, config.smoothing_s);
  if (!is_active) {
    approach(state.shift, {}, share);
  } else if (!stands_on_shift(input.walk) && input.walk.swing_share < config.settled_share) {
    approach(state.shift, wanted(config, input), share);
  }
  return with_landing(state.shift);
}

}  // namespace surefoot::stabilizer
