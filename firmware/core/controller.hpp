#pragma once

#include <cstdint>

#include "firmware/core/decision/reflex_config.hpp"
#include "firmware/core/decision/reflex_sequence.hpp"
#include "firmware/core/estimation/estimator.hpp"
#include "firmware/core/gait/walk_parameters.hpp"
#include "firmware/core/geometry/robot_geometry.hpp"
#include "firmware/core/safety/output_gate.hpp"
#include "firmware/core/servo/joint_pid.hpp"

namespace surefoot {

/// All parameters of the controller; constant while the loop runs.
struct ControllerConfig {
  double period_s = 1.0e-3;
  geometry::RobotGeometry geometry{};
  gait::WalkParameters walk{};
  estimation::EstimatorConfig estimator{};
  decision::PayloadDetectorConfig detector{};
  decision::ReflexConfig reflex{};
  servo::ServoConfig servo{};
  safety::OutputGateConfig gate{};
};

/// Everything one tick produced: the commands, and what telemetry shows of the way to them.
struct TickOutput {
  std::uint32_t tick = 0;
  PerSide<LegCommand> command{};
  estimation::Estimate estimate{};
  decision::Decision decision{};
  FootReference foot_reference{};
  JointReference joint_reference{};
  PerSide<LegVector> wanted_torque_nm{};
  safety::Fault fault = safety::Fault::kNone;
};

/// The firmware: one call a tick, no clock, heap, lock, exception or log.
class Controller {
 public:
  explicit Controller(const ControllerConfig& config) noexcept : config_(config) {}

  /// One tick. Calls must come once a period; `sensors.tick` counts them.
  [[nodiscard]] TickOutput tick(const SensorSnapshot& sensors) noexcept;

 private:
  ControllerConfig config_;
  estimation::EstimatorState estimator_{};
  decision::ReflexSequenceState sequence_{};
  servo::ServoState servo_{};
  safety::OutputGateState gate_{};
};

}  // namespace surefoot
