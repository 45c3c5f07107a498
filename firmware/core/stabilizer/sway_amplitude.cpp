#include "firmware/core/stabilizer/sway_amplitude.hpp"

#include "firmware/core/stabilizer/gradual.hpp"

namespace surefoot::stabilizer {
namespace {

void learn(const SwayAmplitudeConfig& config, SwayAmplitudeState& state) noexcept {
  const double error_m = beyond_band(state.outermost_nominal_m - state.outermost_measured_m, config.band_m);
  const double wanted_m = config.kept_share * state.learned_m + config.gain * error_m / config.zmp_per_sway;
  const double least_m = std::min(0.0, config.min_sway_m - config.pattern_sway_m);
  const double most_m = std::max(0.0, config.max_sway_m - config.pattern_sway_m);
  state.learned_m = std::clamp(wanted_m, least_m, most_m);
}

void see(const SwayAmplitudeConfig& config, SwayAmplitudeState& state, const StabilizerInput& input) noexcept {
  const double outwards = lateral_sign(input.walk.support());
  const double measured_m = outwards * input.measured.zmp_y_foot_m;
  const double nominal_m = outwards * input.nominal.zmp_y_foot_m;
  if (!are_usable(measured_m, nominal_m)) return;

  const double share = low_pass_share(input.period_s, config.time_constant_s);
  if (!state.has_sample) {
    state.measured_zmp_m = state.outermost_measured_m = measured_m;
    state.nominal_zmp_m = state.outermost_nominal_m = nominal_m;
  }
  state.has_sample = true;
  approach(state.measured_zmp_m, measured_m, share);
  approach(state.nominal_zmp_m, nominal_m, share);
  state.outermost_measured_m = std::max(state.outermost_measured_m, state.measured_zmp_m);
  state.outermost_nominal_m = std::max(state.outermost_nominal_m, state.nominal_zmp_m);
}

}  // namespace

Adjustment step(const SwayAmplitudeConfig& config, SwayAmplitudeState& state, const StabilizerInput& input,
                bool is_active) noexcept {
  const WalkView& walk = input.walk;
  if (walk.begins_step) {
    if (is_active && state.has_sample) learn(config, state);
    state.has_sample = false;
  } else if (walk.is_swinging() && input.ankle[index(walk.support())].carries()) {
    see(config, state, input);
  }
  approach(state.added_sway_m, state.learned_m, low_pass_share(input.period_s, config.smoothing_s));
  Adjustment adjustment;
  adjustment.sway_m = state.added_sway_m;
  return adjustment;
}

}  // namespace surefoot::stabilizer
