#include "firmware/core/controller.hpp"

#include <algorithm>

#include "firmware/core/gait/motion_plan.hpp"
#include "firmware/core/gait/stance.hpp"
#include "firmware/core/kinematics/leg_kinematics.hpp"

namespace surefoot {
namespace {

constexpr double kTrembling_s = 1.0;  // a robot that comes to rest is not still at once

/// Whether every sensor must feel something.
/// @param walks_on  the robot does not stand still while a reflex settles
bool is_moving(const decision::Decision& decision, bool walks_on) noexcept {
  using decision::ReflexPhase;
  if (decision.phase == ReflexPhase::kStanding || decision.phase == ReflexPhase::kStopped) return false;
  return walks_on || decision.phase == ReflexPhase::kWalking || decision.time_in_phase_s < kTrembling_s;
}

/// The floor walk in the words of the sequence, for logs and verdicts.
decision::Decision as_decision(const gait::WalkParameters& walk, const FloorWalkerState& walker) noexcept {
  using decision::ReflexPhase;
  const gait::FloorWalkState& state = walker.walk;
  const decision::PayloadShiftState& payload = walker.payload;
  decision::Decision decision;
  const bool stands = state.stage == decision::WalkStage::kStanding;
  decision.phase = !stands ? payload.phase : state.stops ? ReflexPhase::kStopped : ReflexPhase::kStanding;
  decision.time_in_phase_s =
      decision.phase == ReflexPhase::kWalking || stands ? state.time_in_stage_s : payload.time_in_phase_s;
  decision.event = payload.event;
  decision.is_detector_armed = payload.detector.threshold_n > 0.0;
  decision.is_payload_seen = payload.is_payload_seen;
  decision.threshold_n = payload.detector.threshold_n;
  decision.reference_x_body_m = 0.0 - payload.offset_m.position;
  decision.balance_zmp_x_body_m = payload.balance_zmp_x_m;
  decision.adaptation_m = payload.adaptation_m;
  if (!stands) {
    decision.walk_phase_s =
        std::clamp(state.step_time_s, 0.0, walk.step_s()) + (state.moving == Side::kRight ? walk.step_s() : 0.0);
  }
  return decision;
}

}  // namespace

Controller::Controller(const ControllerConfig& config) noexcept
    : config_(config), standing_(standing_reference(config)) {
  config_.reflex.capture.geometry = config.geometry;
}

TickOutput Controller::tick(const SensorSnapshot& sensors, safety::Finding reported) noexcept {
  const double period_s = config_.period_s;
  const bool stops = gate_.latched.fault != safety::Fault::kNone;
  const bool servoes_here = config_.method == WalkMethod::kPayloadWalk;
  TickOutput out;
  out.tick = sensors.tick;
  out.is_waiting_for_posture = is_waiting_for_posture(sensors);
  out.estimate = estimation::step(config_.estimator, config_.geometry, estimator_, sensors, period_s);
  servoes_here ? walk_with_payload(sensors, stops, out) : walk_over_floor(sensors, stops, out);
  const double standing_force_n = servoes_here ? sequence_.standing_force_n : floor_.standing_force_n;
  const safety::Finding implausible = safety::check_sensors(
      config_.plausibility, plausibility_, sensors, is_moving(out.decision, !servoes_here), standing_force_n, period_s);
  const safety::GateOrders orders{followed_by(reported, implausible), out.is_waiting_for_posture};
  const WantedMotion wanted{.mode = servoes_here ? LegMode::kTorque : LegMode::kPosition,
                            .torque_nm = out.wanted_torque_nm,
                            .angle_rad = out.joint_reference.angle_rad};
  out.command = safety::step(config_.gate, gate_, wanted, sensors, orders, period_s);
  out.fault = gate_.latched.fault;
  out.safe_state = gate_.latched.needs;
  return out;
}

void Controller::walk_with_payload(const SensorSnapshot& sensors, bool stops, TickOutput& out) noexcept {
  out.decision = decision::step(config_.walk, config_.reflex, config_.detector, sequence_, out.estimate,
                                config_.period_s, stops ? &config_.stop : nullptr);
  out.foot_reference = gait::foot_reference(config_.walk, out.decision.motion, out.decision.time_in_phase_s);
  out.joint_reference = kinematics::inverse(config_.geometry, out.foot_reference);
  out.wanted_torque_nm = servo::step(config_.servo, servo_, out.joint_reference, sensors, config_.period_s);
}

void Controller::walk_over_floor(const SensorSnapshot& sensors, bool stops, TickOutput& out) noexcept {
  out.floor = step(config_.floor, config_.walk, config_.geometry, config_.detector,
                   config_.reflex.method != decision::ReflexMethod::kOff, floor_, sensors, out.estimate, stops,
                   config_.period_s);
  out.decision = as_decision(config_.walk, floor_);
  out.foot_reference = out.floor.foot_reference;
  out.joint_reference = out.floor.joint_reference;
}

bool Controller::is_waiting_for_posture(const SensorSnapshot& sensors) noexcept {
  if (is_up_ || gate_.latched.fault != safety::Fault::kNone) return false;
  estimator_ = {};  // everything begins in the tick in which the robot stands
  sequence_ = {};
  servo_ = {};
  floor_ = {};
  is_up_ = safety::is_ready_to_stand(config_.posture, sensors, standing_);
  return !is_up_;
}

double time_zero_s(const ControllerConfig& config) noexcept {
  if (config.method == WalkMethod::kFloorWalk) return gait::start_up_s(config.walk, config.floor.pattern);
  return decision::time_zero_s(config.walk, config.reflex, config.detector);
}

JointReference standing_reference(const ControllerConfig& config) noexcept {
  const double x_m =
      config.method == WalkMethod::kFloorWalk ? -config.floor.pattern.pelvis_x_m : config.walk.reference_x_body_m;
  return kinematics::inverse(config.geometry, gait::stance(config.walk, {x_m, x_m}));
}

}  // namespace surefoot
