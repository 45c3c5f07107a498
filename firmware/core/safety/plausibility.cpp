#include "firmware/core/safety/plausibility.hpp"

namespace surefoot::safety {

Finding check_sensors(const PlausibilityConfig& config, PlausibilityState& state, const SensorSnapshot& sensors,
                      bool is_moving, double weight_n, double period_s) noexcept {
  const bool encoders = are_encoders_plausible(config.encoder, state.encoder, sensors.leg, period_s);
  const bool feet = are_feet_plausible(config.foot, state.foot, sensors.foot, is_moving, weight_n, period_s);
  const bool imu = is_imu_plausible(config.imu, state.imu, sensors.torso, is_moving, period_s);
  if (encoders && feet && imu) return {};
  return finding_of_node(Fault::kSensorImplausible, !encoders);
}

}  // namespace surefoot::safety
