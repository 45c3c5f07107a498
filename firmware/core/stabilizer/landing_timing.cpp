#include "firmware/core/stabilizer/landing_timing.hpp"

#include <algorithm>

#include "firmware/core/stabilizer/gradual.hpp"

namespace surefoot::stabilizer {
namespace {

void observe(double hysteresis_rad_s, ZeroCrossing& crossing, double rate_rad_s, double now_s) noexcept {
  if (crossing.is_confirmed) return;
  if (rate_rad_s < -hysteresis_rad_s) {
    crossing.is_armed = true;
    crossing.has_candidate = false;
  } else if (crossing.is_armed && crossing.before_rad_s < 0.0 && rate_rad_s >= 0.0) {
    const double share = crossing.before_rad_s / (crossing.before_rad_s - rate_rad_s);
    crossing.last_s = crossing.before_s + share * (now_s - crossing.before_s);
    if (!crossing.has_candidate) crossing.first_s = crossing.last_s;
    crossing.has_candidate = true;
  }
  crossing.is_confirmed = crossing.has_candidate && rate_rad_s > hysteresis_rad_s;
  crossing.before_s = now_s;
  crossing.before_rad_s = rate_rad_s;
}

void record(const LandingTimingConfig& config, LandingTimingState& state, const StabilizerInput& input) noexcept {
  const WalkView& walk = input.walk;
  const double now_s = walk.step_time_s;
  const Side foot = walk.moving;
  observe(config.hysteresis_rad_s, state.measured, toward(foot, input.measured.support_roll_rate_rad_s), now_s);
  observe(config.hysteresis_rad_s, state.nominal, toward(foot, input.nominal.support_roll_rate_rad_s), now_s);
  if (decision::is_lifting(walk.stage)) state.top_s = now_s;
  if (state.nominal.is_confirmed) {
    state.nominal_crossing_s[index(foot)] = state.nominal.time_s();
    state.is_nominal_known[index(foot)] = true;
  }
}

/// E, or 0 while nothing is known.
double wanted_earlier_s(const LandingTimingConfig& config, const LandingTimingState& state, Side foot) noexcept {
  if (!state.measured.is_confirmed) return 0.0;
  if (config.uses_nominal && !state.is_nominal_known[index(foot)]) return 0.0;
  const double centre_s = config.uses_nominal ? state.nominal_crossing_s[index(foot)] : state.top_s;
  return std::clamp(centre_s - config.before_s - state.measured.time_s(), 0.0, config.max_earlier_s);
}

}  // namespace

Adjustment step(const LandingTimingConfig& config, LandingTimingState& state, const StabilizerInput& input,
                bool is_active) noexcept {
  const WalkView& walk = input.walk;
  if (decision::is_lifting(walk.stage) && walk.stage != state.stage) {
    state.measured = {};
    state.nominal = {};
  }
  state.stage = walk.stage;
  if (is_usable_period(input.period_s)) {
    const bool is_sane =
        are_usable(input.measured.support_roll_rate_rad_s, input.nominal.support_roll_rate_rad_s, walk.step_time_s);
    if (walk.is_swinging() && !walk.has_landed && is_sane) record(config, state, input);
    const double wanted_s = is_active ? wanted_earlier_s(config, state, walk.moving) : 0.0;
    state.earlier_s = slewed(state.earlier_s, wanted_s, config.max_rate_s_per_s, input.period_s);
  }
  Adjustment adjustment;
  adjustment.earlier_landing_s = state.earlier_s;
  adjustment.waits_for_contact = is_active;
  return adjustment;
}

}  // namespace surefoot::stabilizer
