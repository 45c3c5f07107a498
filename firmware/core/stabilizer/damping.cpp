#include "firmware/core/stabilizer/damping.hpp"

namespace surefoot::stabilizer {
namespace {

/// One axis, lean and ankle angle positive to the same side.
struct Axis {
  double& lagged_rad;
  double& filtered_rad;
  double output_rad;
  double moment_nm;  ///< deviation from flat walking
};

/// Follows the lean and returns the ankle angle against its rate. The first tick of a foot only takes the lean over.
double against_rate(const DampingConfig& config, Axis axis, double period_s, bool is_first) noexcept {
  axis.lagged_rad += low_pass_share(period_s, config.command_lag_s) * (axis.output_rad - axis.lagged_rad);
  const double lean_rad = axis.lagged_rad + axis.moment_nm / config.stiffness_nm_per_rad;
  const double before_rad = is_first ? lean_rad : axis.filtered_rad;
  axis.filtered_rad = before_rad + low_pass_share(period_s, config.time_constant_s) * (lean_rad - before_rad);
  const double rate_rad_s = period_s > 0.0 ? (axis.filtered_rad - before_rad) / period_s : 0.0;
  return within(-config.gain_s * rate_rad_s, config.max_angle_rad);
}

}  // namespace

Adjustment step(const DampingConfig& config, DampingState& state, const StabilizerInput& input,
                bool is_active) noexcept {
  const Side support = input.walk.support();
  const auto& ankle = input.ankle[index(support)];
  const bool is_first = !state.is_estimating || support != state.support;
  state.support = support;
  state.is_estimating = ankle.carries();

  AnkleAngles wanted;
  if (state.is_estimating) {
    AnkleAngles& own = state.added_angle[index(support)];
    if (is_first) state.lagged_command = own;
    const PhaseSample& now = input.measured;
    const PhaseSample& flat = input.nominal;
    const double roll_nm = sound_or_zero(ankle.normal_force_n * deviation(now.zmp_y_foot_m, flat.zmp_y_foot_m));
    const double pitch_nm = sound_or_zero(-ankle.normal_force_n * deviation(now.zmp_x_foot_m, flat.zmp_x_foot_m));
    const Axis roll{state.lagged_command.roll_rad, state.filtered_lean.roll_rad, own.roll_rad, roll_nm};
    const Axis pitch{state.lagged_command.pitch_rad, state.filtered_lean.pitch_rad, own.pitch_rad, pitch_nm};
    wanted.roll_rad = against_rate(config, roll, input.period_s, is_first);
    wanted.pitch_rad = against_rate(config, pitch, input.period_s, is_first);
  }

  for (const Side side : kSides) {
    const AnkleAngles target = is_active && side == support ? wanted : AnkleAngles{};
    approach(state.added_angle[index(side)], target, low_pass_share(input.period_s, config.smoothing_s));
  }
  return with_ankles(state.added_angle);
}

}  // namespace surefoot::stabilizer
