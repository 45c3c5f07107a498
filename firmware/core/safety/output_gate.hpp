#pragma once

#include "firmware/core/leg_command.hpp"
#include "firmware/core/safety/fault.hpp"
#include "firmware/core/sensor_snapshot.hpp"

namespace surefoot::safety {

/// Limits that hold whatever the rooms above ask for.
struct OutputGateConfig {
  double torque_limit_nm = 200.0;         ///< per joint, > 0
  double torque_rate_limit_nm_s = 2.0e5;  ///< per joint, > 0; full reversal in two ticks
  double joint_rate_limit_rad_s = 25.0;
  LegVector angle_min_rad{-0.8, -0.8, -2.0, -0.02, -1.5, -0.8};
  LegVector angle_max_rad{0.8, 0.8, 1.0, 2.6, 1.5, 0.8};
  std::uint32_t ride_through_ticks = 10;  ///< a node may be silent, or a board damp, this long
};

/// Everything that lives between two ticks.
struct OutputGateState {
  PerSide<LegVector> last_torque_nm{};
  Fault latched = Fault::kNone;
  bool all_nodes_heard = false;     ///< every node has answered at least once since power-up
  std::uint32_t awaited_ticks = 0;  ///< ticks since power-up in which some node had not yet answered at all
  std::uint32_t damped_ticks = 0;   ///< for so long a leg board has damped since all nodes are heard
};

/// What goes to the leg boards. Until a fault latches: the wanted torque, limited in rate and size.
/// While a node rides through, the last torques are held. Until every node has answered once after
/// power-up: mode kDamp and zero torque, a fault only after `ride_through_ticks` of that. After a
/// latched fault: mode kDamp and zero torque, until a fresh `OutputGateState` is put in place.
/// When one tick shows several faults, silence comes first, then a board that damps against its
/// orders, then the joints, then the torque: the cause before its consequence. Independent of everything that stands
/// above it.
///
/// @param period_s  time since the last call, > 0
[[nodiscard]] PerSide<LegCommand> step(const OutputGateConfig&, OutputGateState&, const PerSide<LegVector>& wanted_nm,
                                       const SensorSnapshot&, double period_s) noexcept;

}  // namespace surefoot::safety
