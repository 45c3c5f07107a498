#pragma once

#include "firmware/core/foot_reference.hpp"
#include "firmware/core/joints.hpp"
#include "firmware/core/sensor_snapshot.hpp"

namespace surefoot::servo {

/// Gains of one joint. Sampled at 1 kHz with one tick of latency, kd/J <= 300 1/s and
/// kp/J <= 75000 1/s2 stay clear of chatter (J: reflected rotor inertia, kg m2).
struct JointGains {
  double kp_nm_per_rad = 30000.0;
  double ki_nm_per_rad_s = 0.0;
  double kd_nm_s_per_rad = 120.0;
};

/// Independent joint PID (El-Kahlout 2003, section 3.2); gains are not printed there.
struct ServoConfig {
  std::array<JointGains, kJointsPerLeg> gains{{{30000.0, 0.0, 120.0},
                                               {30000.0, 0.0, 120.0},
                                               {30000.0, 0.0, 120.0},
                                               {30000.0, 0.0, 120.0},
                                               {30000.0, 0.0, 90.0},
                                               {20000.0, 0.0, 80.0}}};
  double torque_limit_nm = 200.0;  ///< the integrator stops where the output would pass this
};

/// Integral part of each joint's output; everything that lives between two ticks.
struct ServoState {
  PerSide<LegVector> integral_nm{};
};

/// Wanted torques, not yet gated: kp e + integral + kd de/dt. Anti-windup by conditional
/// integration: a joint at its limit integrates only towards smaller output, and no joint
/// integrates over a measurement that did not arrive in this tick.
///
/// @param period_s  time since the last call, > 0
[[nodiscard]] PerSide<LegVector> step(const ServoConfig&, ServoState&, const JointReference&, const SensorSnapshot&,
                                      double period_s) noexcept;

}  // namespace surefoot::servo
