#pragma once

#include "firmware/core/safety/encoder_check.hpp"
#include "firmware/core/safety/foot_check.hpp"
#include "firmware/core/safety/imu_check.hpp"
#include "firmware/core/safety/safe_state.hpp"
#include "firmware/core/sensor_snapshot.hpp"

namespace surefoot::safety {

/// Sensors that answer but lie.
struct PlausibilityConfig {
  EncoderCheckConfig encoder{};
  FootCheckConfig foot{};
  ImuCheckConfig imu{};
};

/// Everything that lives between two ticks.
struct PlausibilityState {
  EncoderCheckState encoder{};
  FootCheckState foot{};
  ImuCheckState imu{};
};

/// Fault 8, if any: kDamp for an encoder, without which a leg cannot be held; kStanceHold for a foot or the IMU.
///
/// @param is_moving  the robot walks, or has just ceased to: every sensor must feel something
/// @param weight_n    filtered force of the last standing, 0 while it is not known
/// @param period_s    time since the last call, > 0
[[nodiscard]] Finding check_sensors(const PlausibilityConfig&, PlausibilityState&, const SensorSnapshot&,
                                    bool is_moving, double weight_n, double period_s) noexcept;

}  // namespace surefoot::safety
