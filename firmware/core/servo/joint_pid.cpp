#include "firmware/core/servo/joint_pid.hpp"

#include <cmath>

namespace surefoot::servo {

PerSide<LegVector> step(const ServoConfig& config, ServoState& state, const JointReference& reference,
                        const SensorSnapshot& sensors, double period_s) noexcept {
  PerSide<LegVector> wanted_nm{};
  for (const Side side : kSides) {
    const std::size_t leg = index(side);
    const LegSensors& measured = sensors.leg[leg];
    for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
      const JointGains& gains = config.gains[joint];
      const double error_rad = reference.angle_rad[leg][joint] - measured.angle_rad[joint];
      const double rate_error_rad_s = reference.rate_rad_s[leg][joint] - measured.rate_rad_s[joint];
      const double without_integral_nm = gains.kp_nm_per_rad * error_rad + gains.kd_nm_s_per_rad * rate_error_rad_s;

      double& integral_nm = state.integral_nm[leg][joint];
      if (measured.freshness.is_fresh()) {
        const double gain_nm = gains.ki_nm_per_rad_s * error_rad * period_s;
        const double output_nm = without_integral_nm + integral_nm + gain_nm;
        if (std::abs(output_nm) <= config.torque_limit_nm || gain_nm * output_nm < 0.0) {
          integral_nm += gain_nm;  // never true for NaN: the integral stays clean
        }
      }
      wanted_nm[leg][joint] = without_integral_nm + integral_nm;
    }
  }
  return wanted_nm;
}

}  // namespace surefoot::servo
