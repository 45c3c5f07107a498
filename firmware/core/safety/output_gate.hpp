#pragma once

#include "firmware/core/leg_command.hpp"
#include "firmware/core/safety/safe_state.hpp"
#include "firmware/core/sensor_snapshot.hpp"

namespace surefoot::safety {

/// Limits that hold whatever the rooms above ask for.
struct OutputGateConfig {
  double torque_limit_nm = 200.0;         ///< per joint, > 0
  double torque_rate_limit_nm_s = 2.0e5;  ///< per joint, > 0; full reversal in two ticks
  double joint_rate_limit_rad_s = 25.0;
  double reference_rate_limit_rad_s = 12.0;  ///< of the angles sent to a board that servoes by itself, per joint, > 0
  LegVector angle_min_rad{-0.8, -0.8, -2.0, -0.02, -1.5, -0.8};
  LegVector angle_max_rad{0.8, 0.8, 1.0, 2.6, 1.5, 0.8};
  std::uint32_t ride_through_ticks = 10;  ///< a node may be silent, or a board damp, this long
};

/// Everything that lives between two ticks.
struct OutputGateState {
  PerSide<LegVector> last_torque_nm{};
  PerSide<LegVector> last_angle_rad{};  ///< while `holds_angles`
  bool holds_angles = false;            ///< the last command was one of angles
  Finding latched{};                    ///< the first fault, and the safe state that all so far ask for
  bool all_nodes_heard = false;         ///< every node has answered at least once since power-up
  std::uint32_t awaited_ticks = 0;      ///< ticks since power-up in which some node had not yet answered at all
  std::uint32_t damped_ticks = 0;       ///< for so long a leg board has damped since all nodes are heard
};

/// What the rooms above tell the gate beside the motion that they want.
struct GateOrders {
  Finding reported{};                   ///< a fault found outside the gate in this tick
  bool is_waiting_for_posture = false;  ///< the robot does not stand as it must before motion may begin
};

/// What goes to the leg boards.
///
/// Without a fault, and in the safe state kStanceHold: the wanted torques, limited in rate and size, or the wanted
/// angles, limited in rate and to the joints' ranges; a leg whose board did not answer this tick keeps what it was
/// given last. Angles begin at the joints as measured, in a tick in which both boards answered (until then: kDamp), and
/// anew for a leg whose board damps. In the safe state kDamp,
/// until every node has answered once after power-up, while waiting for the posture, and where kDamp is wanted: mode
/// kDamp and zero torque. A node may be awaited for `ride_through_ticks`; a fault before the first motion always
/// damps, for there is no stance to hold. A safe state lasts, or grows worse, until a fresh `OutputGateState` is put in
/// place.
///
/// When one tick shows several faults, what was reported comes first, then silence, then a board that damps
/// against its orders, then the joints, then torques or angles that are not finite: the cause before its consequence.
/// Independent of everything that stands above it.
///
/// @param period_s  time since the last call, > 0
[[nodiscard]] PerSide<LegCommand> step(const OutputGateConfig&, OutputGateState&, const WantedMotion&,
                                       const SensorSnapshot&, const GateOrders&, double period_s) noexcept;

}  // namespace surefoot::safety
