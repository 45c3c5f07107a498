#include "firmware/core/stabilizer/vibration_reduction.hpp"

#include <cmath>

#include "firmware/core/stabilizer/gradual.hpp"

namespace surefoot::stabilizer {
namespace {

constexpr double kGravity_m_s2 = 9.81;

void damp(const VibrationReductionConfig& config, SwayingLeg& leg, double acceleration_m_s2, double period_s) noexcept {
  if (!leg.is_running) leg.slow_m_s2 = acceleration_m_s2;  // no step into the integral
  leg.is_running = true;
  const double acceleration_rad_s2 = (acceleration_m_s2 - leg.slow_m_s2) / config.leg_length_m;
  leg.slow_m_s2 += low_pass_share(period_s, 1.0 / config.high_pass_rad_s) * (acceleration_m_s2 - leg.slow_m_s2);
  leg.rate_rad_s = lagged(leg.rate_rad_s, acceleration_rad_s2 / config.leak_rad_s, 1.0 / config.leak_rad_s, period_s);
  const double wanted_rad = within(-config.gain_s * leg.rate_rad_s, config.max_angle_rad);
  leg.hip_roll_rad = slewed(leg.hip_roll_rad, wanted_rad, config.max_rate_rad_s, period_s);
}

void fade(const VibrationReductionConfig& config, SwayingLeg& leg, double period_s) noexcept {
  leg.is_running = false;
  leg.rate_rad_s = 0.0;
  leg.hip_roll_rad = lagged(leg.hip_roll_rad, 0.0, config.fade_s, period_s);
}

}  // namespace

Adjustment step(const VibrationReductionConfig& config, VibrationReductionState& state, const StabilizerInput& input,
                bool is_active) noexcept {
  Adjustment adjustment;
  for (const Side side : kSides) {
    SwayingLeg& leg = state.leg[index(side)];
    if (is_usable_period(input.period_s)) {
      const double force_m_s2 = input.foot_lateral_force_m_s2[index(side)];
      const double tilt_rad = input.foot_roll_rad[index(side)];
      const bool swings = is_active && side == input.walk.moving && !input.ankle[index(side)].carries();
      if (!swings) {
        fade(config, leg, input.period_s);
      } else if (are_usable(force_m_s2, tilt_rad)) {
        damp(config, leg, force_m_s2 - kGravity_m_s2 * std::sin(tilt_rad), input.period_s);
      }
    }
    adjustment.hip_roll_rad[index(side)] = leg.hip_roll_rad;
  }
  return adjustment;
}

}  // namespace surefoot::stabilizer
