#pragma once

#include "firmware/core/foot_reference.hpp"
#include "firmware/core/sensor_snapshot.hpp"

namespace surefoot::safety {

/// How near to standing a robot must be before torques may begin.
struct StartPostureConfig {
  double joint_tolerance_rad = 0.15;  ///< each joint's distance from the standing reference
  double max_tilt_rad = 0.2;          ///< of the torso, by the accelerometer
  double min_foot_force_n = 50.0;     ///< on each foot
};

/// True when the robot stands much as the first reference wants it: every node answered this tick, all
/// joints within the tolerance, the torso upright and at rest (specific force of 0.5 to 1.5 g, within the
/// tilt of the body's z axis), both feet loaded. A servo at full gain that starts elsewhere would throw it.
[[nodiscard]] bool is_ready_to_stand(const StartPostureConfig&, const SensorSnapshot&,
                                     const JointReference& standing) noexcept;

}  // namespace surefoot::safety
