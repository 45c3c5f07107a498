#include "firmware/core/stabilizer/step_adjustment.hpp"

namespace surefoot::stabilizer {
namespace {

constexpr double kGravity_m_s2 = 9.81;

/// Until the planned landing; the step's duration follows from its time and share.
double until_landing_s(const WalkView& walk) noexcept {
  const double duration_s = walk.step_share > 0.0 ? walk.step_time_s / walk.step_share : 0.0;
  return std::max(0.0, sound_or_zero(duration_s - walk.step_time_s));
}

/// Deviation of the divergent component at the landing, forward and to the left; tilt is positive forward and right.
LandingShift wanted(const StepAdjustmentConfig& config, const StabilizerInput& input, double ahead_s) noexcept {
  const double omega_per_s = std::sqrt(kGravity_m_s2 / config.com_height_m);
  const double growth_m_per_rad =
      config.gain * config.com_height_m * std::exp(omega_per_s * std::min(ahead_s, config.horizon_s));
  const PhaseSample& now = input.measured;
  const PhaseSample& flat = input.nominal;
  const double pitch_rad = deviation(now.torso_pitch_rad, flat.torso_pitch_rad) +
                           deviation(now.torso_pitch_rate_rad_s, flat.torso_pitch_rate_rad_s) / omega_per_s;
  const double roll_rad = deviation(now.torso_roll_rad, flat.torso_roll_rad) +
                          deviation(now.torso_roll_rate_rad_s, flat.torso_roll_rate_rad_s) / omega_per_s;
  const LandingShift shift{beyond_band(growth_m_per_rad * pitch_rad, config.band_m),
                           beyond_band(-growth_m_per_rad * roll_rad, config.band_m)};
  return clipped(shift, {config.max_shift_x_m, config.max_outward_m, config.max_inward_m}, input.walk.moving);
}

}  // namespace

Adjustment step(const StepAdjustmentConfig& config, StepAdjustmentState& state, const StabilizerInput& input,
                bool is_active) noexcept {
  if (stands_on_shift(input.walk)) return with_landing(state.shift);

  const double share = low_pass_share(input.period_s, config.smoothing_s);
  const double ahead_s = until_landing_s(input.walk);
  if (!is_active || !input.walk.is_swinging()) {
    approach(state.shift, {}, share);
  } else if (ahead_s > config.freeze_s) {
    approach(state.shift, wanted(config, input, ahead_s), share);
  }
  return with_landing(state.shift);
}

}  // namespace surefoot::stabilizer
