#include "firmware/core/safety/imu_check.hpp"

namespace surefoot::safety {

bool is_imu_plausible(const ImuCheckConfig& config, ImuCheckState& state, const ImuSensors& imu, bool is_moving,
                      double period_s) noexcept {
  if (imu.freshness.is_fresh()) {
    const bool is_frozen =
        imu.angular_rate_body_rad_s == state.last_rate_rad_s && imu.specific_force_body_m_s2 == state.last_force_m_s2;
    state.frozen_ticks = is_moving && is_frozen ? state.frozen_ticks + 1 : 0;
    state.last_rate_rad_s = imu.angular_rate_body_rad_s;
    state.last_force_m_s2 = imu.specific_force_body_m_s2;
    const double factor = period_s / config.force_time_constant_s;
    state.filtered_force_m_s2 += factor * (imu.specific_force_body_m_s2 - state.filtered_force_m_s2);
  }
  return state.frozen_ticks * period_s <= config.frozen_s && state.filtered_force_m_s2.norm() <= config.max_force_m_s2;
}

}  // namespace surefoot::safety
