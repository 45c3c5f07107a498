#include "firmware/core/stabilizer/torso_tilt.hpp"

#include "firmware/core/stabilizer/gradual.hpp"

namespace surefoot::stabilizer {
namespace {

/// The centre after a step in which the torso leaned by `tilt_rad` towards it.
double moved(const TorsoTiltConfig& config, double centre_m, double tilt_rad) noexcept {
  const double against_m = config.gain_m_per_rad * beyond_band(tilt_rad, config.band_rad);
  return within(config.kept_share * centre_m - against_m, config.max_offset_m);
}

}  // namespace

Adjustment step(const TorsoTiltConfig& config, TorsoTiltState& state, const StabilizerInput& input,
                bool is_active) noexcept {
  const WalkView& walk = input.walk;
  if (walk.begins_step) {
    if (is_active && state.time_s > 0.0) {
      // Roll is positive to the right, y to the left.
      state.learned_x_m = moved(config, state.learned_x_m, state.pitch_sum_rad_s / state.time_s);
      state.learned_y_m = moved(config, state.learned_y_m, -state.roll_sum_rad_s / state.time_s);
    }
    state.roll_sum_rad_s = state.pitch_sum_rad_s = state.time_s = 0.0;
  }
  const double roll_rad = input.measured.torso_roll_rad - input.nominal.torso_roll_rad;
  const double pitch_rad = input.measured.torso_pitch_rad - input.nominal.torso_pitch_rad;
  const bool walks = decision::is_lifting(walk.stage) || decision::is_lowering(walk.stage);
  if (walks && are_usable(roll_rad, pitch_rad) && is_usable_period(input.period_s)) {
    state.roll_sum_rad_s += input.period_s * roll_rad;
    state.pitch_sum_rad_s += input.period_s * pitch_rad;
    state.time_s += input.period_s;
  }
  const double share = low_pass_share(input.period_s, config.smoothing_s);
  approach(state.centre_x_m, state.learned_x_m, share);
  approach(state.centre_y_m, state.learned_y_m, share);
  Adjustment adjustment;
  adjustment.sway_centre_x_m = state.centre_x_m;
  adjustment.sway_centre_y_m = state.centre_y_m;
  return adjustment;
}

}  // namespace surefoot::stabilizer
