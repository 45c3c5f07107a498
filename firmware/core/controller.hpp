#pragma once

#include <cstdint>

#include "firmware/core/decision/reflex_config.hpp"
#include "firmware/core/decision/reflex_sequence.hpp"
#include "firmware/core/estimation/estimator.hpp"
#include "firmware/core/floor_walker.hpp"
#include "firmware/core/gait/safe_stop.hpp"
#include "firmware/core/gait/walk_parameters.hpp"
#include "firmware/core/geometry/robot_geometry.hpp"
#include "firmware/core/safety/output_gate.hpp"
#include "firmware/core/safety/plausibility.hpp"
#include "firmware/core/safety/start_posture.hpp"
#include "firmware/core/servo/joint_pid.hpp"

namespace surefoot {

/// How the robot walks.
enum class WalkMethod : std::uint8_t {
  kPayloadWalk,  ///< El-Kahlout's gait and payload reflex; torques to the leg boards
  kFloorWalk,    ///< KHR-2's pattern and online controllers; joint angles to the leg boards' servos
};

/// All parameters of the controller; constant while the loop runs.
struct ControllerConfig {
  WalkMethod method = WalkMethod::kPayloadWalk;
  double period_s = 1.0e-3;
  geometry::RobotGeometry geometry{};
  gait::WalkParameters walk{};
  estimation::EstimatorConfig estimator{};
  decision::PayloadDetectorConfig detector{};
  decision::ReflexConfig reflex{};  ///< of `kPayloadWalk`, as servo; `kFloorWalk` asks only whether there is one
  FloorWalkerConfig floor{};        ///< of `kFloorWalk`
  servo::ServoConfig servo{};
  gait::SafeStopConfig stop{};
  safety::StartPostureConfig posture{};
  safety::PlausibilityConfig plausibility{};
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
  FloorWalkerOutput floor{};                                ///< of `kFloorWalk`
  safety::Fault fault = safety::Fault::kNone;               ///< the first one; it lasts
  safety::SafeState safe_state = safety::SafeState::kNone;  ///< the worst that was needed so far
  bool is_waiting_for_posture = false;  ///< torques and sequence begin when the robot stands as the first reference
};

/// The firmware: one call a tick, no clock, heap, lock, exception or log.
class Controller {
 public:
  explicit Controller(const ControllerConfig& config) noexcept;

  /// One tick. Calls must come once a period; `sensors.tick` counts them.
  ///
  /// @param reported  a fault that was found outside (`safety::finding_of`): it latches like the controller's own.
  ///                  The feet begin to stop in the tick after the one that latched
  [[nodiscard]] TickOutput tick(const SensorSnapshot& sensors, safety::Finding reported = {}) noexcept;

 private:
  [[nodiscard]] bool is_waiting_for_posture(const SensorSnapshot& sensors) noexcept;
  void walk_with_payload(const SensorSnapshot& sensors, bool stops, TickOutput& out) noexcept;
  void walk_over_floor(const SensorSnapshot& sensors, bool stops, TickOutput& out) noexcept;

  ControllerConfig config_;
  JointReference standing_;  ///< where the sequence begins
  bool is_up_ = false;       ///< the robot has stood as it must, once
  estimation::EstimatorState estimator_{};
  decision::ReflexSequenceState sequence_{};
  servo::ServoState servo_{};
  FloorWalkerState floor_{};
  safety::PlausibilityState plausibility_{};
  safety::OutputGateState gate_{};
};

/// From power-up to "time zero" of a scenario. Payload walk: `decision::time_zero_s`; floor walk: the first lift.
[[nodiscard]] double time_zero_s(const ControllerConfig&) noexcept;

/// Feet side by side, as the walk begins.
[[nodiscard]] JointReference standing_reference(const ControllerConfig&) noexcept;

}  // namespace surefoot
