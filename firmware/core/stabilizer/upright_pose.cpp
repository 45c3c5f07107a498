#include "firmware/core/stabilizer/upright_pose.hpp"

#include <algorithm>
#include <cmath>

#include "firmware/core/stabilizer/gradual.hpp"

namespace surefoot::stabilizer {
namespace {

constexpr double kLargestError_rad = 0.5;

void update(const UprightPoseConfig& config, UprightPoseAxis& axis, double inclination_rad, double period_s) noexcept {
  if (!are_usable(inclination_rad)) return;
  const double error_rad = std::clamp(inclination_rad, -kLargestError_rad, kLargestError_rad);
  axis.error_rad = lagged(axis.error_rad, error_rad, config.filter_s, period_s);
  axis.integral_rad = std::clamp(axis.integral_rad + config.ki_per_s * axis.error_rad * period_s, -config.max_angle_rad,
                                 config.max_angle_rad);
}

void fade(const UprightPoseConfig& config, UprightPoseAxis& axis, double period_s) noexcept {
  axis.error_rad = lagged(axis.error_rad, 0.0, config.fade_s, period_s);
  axis.integral_rad = lagged(axis.integral_rad, 0.0, config.fade_s, period_s);
}

void limit(const UprightPoseConfig& config, UprightPoseAxis& axis) noexcept {
  axis.angle_rad =
      std::clamp(config.kp * axis.error_rad + axis.integral_rad, -config.max_angle_rad, config.max_angle_rad);
}

}  // namespace

Adjustment step(const UprightPoseConfig& config, UprightPoseState& state, const StabilizerInput& input,
                bool is_active) noexcept {
  if (is_usable_period(input.period_s)) {
    if (is_active) {
      update(config, state.roll, input.measured.torso_roll_rad - input.nominal.torso_roll_rad, input.period_s);
      update(config, state.pitch, input.measured.torso_pitch_rad - input.nominal.torso_pitch_rad, input.period_s);
    } else {
      fade(config, state.roll, input.period_s);
      fade(config, state.pitch, input.period_s);
    }
    limit(config, state.roll);
    limit(config, state.pitch);
  }
  Adjustment adjustment;
  const double right_length_m = 0.5 * config.hip_spacing_m * std::tan(state.roll.angle_rad);  // eq. (9)
  for (const Side side : kSides) {
    adjustment.leg_length_m[index(side)] = -lateral_sign(side) * right_length_m;
    adjustment.ankle_roll_rad[index(side)] = state.roll.angle_rad;  // atan of the lengths' difference over the spacing
    adjustment.ankle_pitch_rad[index(side)] = state.pitch.angle_rad;
  }
  return adjustment;
}

}  // namespace surefoot::stabilizer
