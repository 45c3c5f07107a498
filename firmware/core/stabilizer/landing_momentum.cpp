#include "firmware/core/stabilizer/landing_momentum.hpp"

#include <algorithm>
#include <cmath>

#include "firmware/core/stabilizer/gradual.hpp"

namespace surefoot::stabilizer {
namespace {

bool is_in_range(const LandingMomentumConfig& config, double desired_nms, double rate_toward_rad_s) noexcept {
  return std::abs(config.inertia_kg_m2 * rate_toward_rad_s - desired_nms) <= config.range_nms;
}

void judge(const LandingMomentumConfig& config, LandingMomentumState& state, const StabilizerInput& input,
           double rate_toward_rad_s) noexcept {
  const double nominal_rad_s = toward(input.walk.moving, input.nominal.support_roll_rate_rad_s);
  state.desired_nms = config.uses_nominal ? config.inertia_kg_m2 * nominal_rad_s : config.printed_momentum_nms;
  state.wanted_moment_nm = landing_moment_nm(config, state.desired_nms, rate_toward_rad_s);
  state.acting_s = 0.0;
  state.has_judged = true;
  state.is_acting = !is_in_range(config, state.desired_nms, rate_toward_rad_s);
  if (state.is_acting) state.integral_rad = state.ankle_roll_rad[index(input.walk.moving)];
}

void act(const LandingMomentumConfig& config, LandingMomentumState& state, const StabilizerInput& input) noexcept {
  const Side foot = input.walk.moving;
  const estimation::AnkleLoad& load = input.ankle[index(foot)];
  const double possible_nm = std::min(config.max_moment_nm, std::max(load.normal_force_n, 0.0) * config.half_width_m);
  const double wanted_nm = std::clamp(state.wanted_moment_nm, -possible_nm, possible_nm);
  // The floor turns the body the other way than the ankle turns the sole.
  const double error_nm = -toward(foot, wanted_nm - toward(foot, load.roll_moment_nm));
  const double most_rad = config.max_angle_rad;
  state.integral_rad =
      std::clamp(state.integral_rad + config.ki_rad_per_nms * error_nm * input.period_s, -most_rad, most_rad);
  const double target_rad = std::clamp(state.integral_rad + config.kp_rad_per_nm * error_nm, -most_rad, most_rad);
  double& angle_rad = state.ankle_roll_rad[index(foot)];
  angle_rad = slewed(angle_rad, target_rad, config.max_rate_rad_s, input.period_s);
  state.acting_s += input.period_s;
}

void bleed(const LandingMomentumConfig& config, LandingMomentumState& state, const StabilizerInput& input) noexcept {
  const WalkView& walk = input.walk;
  const bool is_walking = decision::is_lifting(walk.stage) || decision::is_lowering(walk.stage);
  for (const Side side : kSides) {
    const bool is_acted_on = state.is_acting && side == walk.moving;
    if (is_acted_on) continue;
    const bool stands = is_walking && (side != walk.moving || walk.has_landed);
    double& angle_rad = state.ankle_roll_rad[index(side)];
    angle_rad = lagged(angle_rad, 0.0, stands ? config.standing_fade_s : config.fade_s, input.period_s);
  }
}

}  // namespace

double landing_moment_nm(const LandingMomentumConfig& config, double desired_nms, double rate_toward_rad_s) noexcept {
  return (desired_nms - config.inertia_kg_m2 * rate_toward_rad_s) / config.window_s;
}

Adjustment step(const LandingMomentumConfig& config, LandingMomentumState& state, const StabilizerInput& input,
                bool is_active) noexcept {
  const WalkView& walk = input.walk;
  const estimation::AnkleLoad& load = input.ankle[index(walk.moving)];
  if (is_usable_period(input.period_s)) {
    if (!walk.has_landed) state.has_judged = false;
    if (!is_active || !walk.has_landed) state.is_acting = false;
    const bool is_sane = are_usable(input.measured.support_roll_rate_rad_s, input.nominal.support_roll_rate_rad_s,
                                    load.normal_force_n, load.roll_moment_nm);
    if (is_active && walk.has_landed && is_sane) {
      const double rate_rad_s = toward(walk.moving, input.measured.support_roll_rate_rad_s);
      if (!state.has_judged) judge(config, state, input, rate_rad_s);
      if (is_in_range(config, state.desired_nms, rate_rad_s)) state.is_acting = false;
      if (state.acting_s + 0.5 * input.period_s > config.window_s) state.is_acting = false;
      if (state.is_acting) act(config, state, input);
    }
    bleed(config, state, input);
  }
  Adjustment adjustment;
  adjustment.ankle_roll_rad = state.ankle_roll_rad;
  return adjustment;
}

}  // namespace surefoot::stabilizer
