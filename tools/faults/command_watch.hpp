#pragma once

#include "firmware/core/leg_command.hpp"
#include "firmware/core/safety/output_gate.hpp"
#include "firmware/core/sensor_snapshot.hpp"

namespace surefoot::faults {

/// The largest that left the output gate so far.
struct CommandExtremes {
  double torque_nm = 0.0;       ///< commanded, any joint
  double torque_step_nm = 0.0;  ///< commanded, from tick to tick while torques are on
  double angle_step_rad = 0.0;  ///< commanded, from tick to tick; a board that damped begins at its measured angle
  bool is_within_gate = true;   ///< these, and the angles' range, keep the output gate's limits; all is finite
};

/// Judges commands by the limits of the output gate that sent them, without its arithmetic.
class CommandWatch {
 public:
  CommandWatch(const safety::OutputGateConfig& gate, double period_s) noexcept;

  /// One tick.
  /// @param legs  what the firmware knew of the legs when it decided
  void observe(const PerSide<LegCommand>& command, const PerSide<LegSensors>& legs) noexcept;

  [[nodiscard]] const CommandExtremes& extremes() const noexcept { return extremes_; }

 private:
  void watch_torques(const LegCommand& now, LegVector& last_nm) noexcept;
  void watch_angles(const LegCommand& now, const LegCommand& last, const LegSensors& leg) noexcept;

  safety::OutputGateConfig gate_;
  double period_s_;
  PerSide<LegVector> last_torque_nm_{};
  PerSide<LegCommand> last_{};
  CommandExtremes extremes_{};
};

}  // namespace surefoot::faults
