#include "firmware/core/servo/joint_pid.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace surefoot::servo {
namespace {

double uniform(double low, double high) { return low + (high - low) * (*rc::gen::inRange(0, 1'000'001)) * 1e-6; }

// Anti-windup as an invariant: whatever the history, the integral alone never asks for more than the limit
// plus what the other terms took away from it.
RC_GTEST_PROP(JointPid, NeverWindsItsIntegralBeyondTheLimit, ()) {
  ServoConfig config;
  config.gains.fill({uniform(0.0, 1e4), uniform(0.0, 1e4), 0.0});
  ServoState state;
  JointReference reference;
  SensorSnapshot sensors;
  for (LegSensors& leg : sensors.leg) leg.freshness.age_ticks = 0;
  const int segments = *rc::gen::inRange(1, 8);
  for (int segment = 0; segment < segments; ++segment) {
    const double error = uniform(-1.0, 1.0);
    for (LegVector& leg : reference.angle_rad) leg.fill(error);
    const double proportional_nm = config.gains[0].kp_nm_per_rad * error;
    for (int tick = 0; tick < 200; ++tick) {
      const double before_nm = state.integral_nm[0][0];
      const double wanted_nm = step(config, state, reference, sensors, 1e-3)[0][0];
      const double after_nm = state.integral_nm[0][0];
      RC_ASSERT(std::abs(wanted_nm - (proportional_nm + after_nm)) < 1e-9);
      const bool grew_output = std::abs(wanted_nm) > std::abs(proportional_nm + before_nm);
      if (grew_output) RC_ASSERT(std::abs(wanted_nm) <= config.torque_limit_nm);
      RC_ASSERT((after_nm - before_nm) * error >= 0.0);
    }
  }
}

}  // namespace
}  // namespace surefoot::servo
