#include "firmware/core/estimation/attitude.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace surefoot::estimation {
namespace {

constexpr double kLeastForce_m_s2 = 1.0;  // below it the accelerometer knows no direction

}  // namespace

Attitude step(const AttitudeConfig& config, AttitudeState& state, const ImuSensors& imu, double period_s) noexcept {
  const double force_m_s2 = imu.specific_force_body_m_s2.norm();
  const bool has_direction = imu.freshness.is_fresh() && force_m_s2 >= kLeastForce_m_s2;
  if (state.up_body.isZero(0.0)) {
    if (has_direction) state.up_body = imu.specific_force_body_m_s2 / force_m_s2;
  } else {
    state.up_body += period_s * state.up_body.cross(imu.angular_rate_body_rad_s);
    if (has_direction) {
      const double share = -std::expm1(-period_s / config.time_constant_s);
      state.up_body += share * (imu.specific_force_body_m_s2 / force_m_s2 - state.up_body);
    }
    state.up_body.normalize();
  }
  return {std::atan2(state.up_body.y(), state.up_body.z()), -std::asin(std::clamp(state.up_body.x(), -1.0, 1.0)),
          imu.angular_rate_body_rad_s.x(), imu.angular_rate_body_rad_s.y()};
}

}  // namespace surefoot::estimation
