#include "firmware/core/controller.hpp"

#include "firmware/core/gait/motion_plan.hpp"
#include "firmware/core/gait/stance.hpp"
#include "firmware/core/kinematics/leg_kinematics.hpp"

namespace surefoot {
namespace {

constexpr double kTrembling_s = 1.0;  // a robot that comes to rest is not still at once

/// Whether every sensor must feel something.
bool is_moving(const decision::Decision& decision) noexcept {
  using decision::ReflexPhase;
  if (decision.phase == ReflexPhase::kStanding || decision.phase == ReflexPhase::kStopped) return false;
  return decision.phase == ReflexPhase::kWalking || decision.time_in_phase_s < kTrembling_s;
}

}  // namespace

Controller::Controller(const ControllerConfig& config) noexcept
    : config_(config),
      standing_(kinematics::inverse(config.geometry, gait::stance(config.walk, {config.walk.reference_x_body_m,
                                                                                config.walk.reference_x_body_m}))) {
  config_.reflex.capture.geometry = config.geometry;
}

TickOutput Controller::tick(const SensorSnapshot& sensors, safety::Finding reported) noexcept {
  const double period_s = config_.period_s;
  const gait::SafeStopConfig* stop = gate_.latched.fault != safety::Fault::kNone ? &config_.stop : nullptr;
  TickOutput out;
  out.tick = sensors.tick;
  out.is_waiting_for_posture = is_waiting_for_posture(sensors);
  out.estimate = estimation::step(config_.estimator, config_.geometry, estimator_, sensors, period_s);
  out.decision =
      decision::step(config_.walk, config_.reflex, config_.detector, sequence_, out.estimate, period_s, stop);
  out.foot_reference = gait::foot_reference(config_.walk, out.decision.motion, out.decision.time_in_phase_s);
  out.joint_reference = kinematics::inverse(config_.geometry, out.foot_reference);
  out.wanted_torque_nm = servo::step(config_.servo, servo_, out.joint_reference, sensors, period_s);
  const safety::Finding implausible = safety::check_sensors(
      config_.plausibility, plausibility_, sensors, is_moving(out.decision), sequence_.standing_force_n, period_s);
  const safety::GateOrders orders{followed_by(reported, implausible), out.is_waiting_for_posture};
  out.command = safety::step(config_.gate, gate_, out.wanted_torque_nm, sensors, orders, period_s);
  out.fault = gate_.latched.fault;
  out.safe_state = gate_.latched.needs;
  return out;
}

bool Controller::is_waiting_for_posture(const SensorSnapshot& sensors) noexcept {
  if (is_up_ || gate_.latched.fault != safety::Fault::kNone) return false;
  estimator_ = {};  // everything begins in the tick in which the robot stands
  sequence_ = {};
  servo_ = {};
  is_up_ = safety::is_ready_to_stand(config_.posture, sensors, standing_);
  return !is_up_;
}

}  // namespace surefoot
