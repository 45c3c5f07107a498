#include "firmware/core/controller.hpp"

#include "firmware/core/gait/motion_plan.hpp"
#include "firmware/core/kinematics/leg_kinematics.hpp"

namespace surefoot {

TickOutput Controller::tick(const SensorSnapshot& sensors) noexcept {
  const double period_s = config_.period_s;
  TickOutput out;
  out.tick = sensors.tick;
  out.estimate = estimation::step(config_.estimator, config_.geometry, estimator_, sensors, period_s);
  out.decision = decision::step(config_.walk, config_.reflex, config_.detector, sequence_, out.estimate, period_s);
  out.foot_reference = gait::foot_reference(config_.walk, out.decision.motion, out.decision.time_in_phase_s);
  out.joint_reference = kinematics::inverse(config_.geometry, out.foot_reference);
  out.wanted_torque_nm = servo::step(config_.servo, servo_, out.joint_reference, sensors, period_s);
  out.command = safety::step(config_.gate, gate_, out.wanted_torque_nm, sensors, period_s);
  out.fault = gate_.latched;
  return out;
}

}  // namespace surefoot
