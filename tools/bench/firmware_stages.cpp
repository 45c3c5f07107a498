#include "tools/bench/firmware_stages.hpp"

#include "firmware/core/gait/motion_plan.hpp"
#include "firmware/core/kinematics/leg_kinematics.hpp"
#include "tools/bench/stopwatch.hpp"

namespace surefoot::bench {

std::vector<Stage> firmware_stages(const ControllerConfig& config, const SensorSnapshot& sensors, double seconds) {
  const double budget_s = seconds / 7.0;
  const double period_s = config.period_s;
  std::vector<Stage> stages;
  const auto time = [&](const char* name, const auto& action) {
    stages.push_back({name, least_us_per_call(budget_s, action)});
  };

  estimation::EstimatorState estimator;
  estimation::Estimate estimate;
  time("firmware: estimate", [&] {
    estimate = estimation::step(config.estimator, config.geometry, estimator, sensors, period_s);
    keep(estimate);
  });
  decision::ReflexSequenceState sequence;
  decision::Decision decision;
  time("firmware: decide", [&] {
    decision = decision::step(config.walk, config.reflex, config.detector, sequence, estimate, period_s, nullptr);
    keep(decision);
  });
  FootReference feet;
  time("firmware: gait", [&] {
    feet = gait::foot_reference(config.walk, decision.motion, decision.time_in_phase_s);
    keep(feet);
  });
  JointReference joints;
  time("firmware: inverse kinematics", [&] {
    joints = kinematics::inverse(config.geometry, feet);
    keep(joints);
  });
  servo::ServoState servo;
  PerSide<LegVector> torque_nm{};
  time("firmware: servo", [&] {
    torque_nm = servo::step(config.servo, servo, joints, sensors, period_s);
    keep(torque_nm);
  });
  safety::PlausibilityState plausibility;
  time("firmware: plausibility", [&] {
    keep(safety::check_sensors(config.plausibility, plausibility, sensors, true, sequence.standing_force_n, period_s));
  });
  safety::OutputGateState gate;
  time("firmware: output gate", [&] {
    keep(safety::step(config.gate, gate, {.torque_nm = torque_nm}, sensors, safety::GateOrders{}, period_s));
  });
  return stages;
}

}  // namespace surefoot::bench
