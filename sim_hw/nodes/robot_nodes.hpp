#pragma once

#include <array>
#include <cstdint>

#include "firmware/can/identifiers.hpp"
#include "sim_hw/nodes/foot_node.hpp"
#include "sim_hw/nodes/imu_node.hpp"
#include "sim_hw/nodes/leg_board.hpp"

namespace surefoot::sim_hw {

/// What the sensors of all nodes see at one instant.
struct SensedState {
  PerSide<LegVector> angle_rad;
  PerSide<LegVector> rate_rad_s;
  PerSide<std::array<double, geometry::kCornersPerFoot>> corner_force_n;
  TorsoMotion torso;
  PerSide<LegInertialMotion> leg_inertial;
};

/// The robot's five nodes, each with the faults of its sensors.
class RobotNodes {
 public:
  explicit RobotNodes(const SimConfig& config)
      : leg{LegBoard(Side::kRight, config), LegBoard(Side::kLeft, config)},
        foot{FootNode(Side::kRight, config.sensor, config.seed, faults_of(FaultTarget::kFootRight, config)),
             FootNode(Side::kLeft, config.sensor, config.seed, faults_of(FaultTarget::kFootLeft, config))},
        imu(config.sensor, config.seed, faults_of(FaultTarget::kTorso, config)) {}

  /// Answers SYNC.
  /// @param hears  bool(can::Node): whether SYNC reached a node
  template <typename Hears>
  void on_sync(std::uint32_t tick, const SensedState& sensed, const Hears& hears, FrameOutbox& outbox) noexcept {
    for (const Side side : kSides) {
      const std::size_t i = index(side);
      if (hears(can::leg_node(side))) {
        leg[i].on_sync(tick, sensed.angle_rad[i], sensed.rate_rad_s[i], sensed.leg_inertial[i], outbox);
      }
      if (hears(can::foot_node(side))) foot[i].on_sync(tick, sensed.corner_force_n[i], sensed.leg_inertial[i], outbox);
    }
    if (hears(can::Node::kTorsoImu)) imu.on_sync(tick, sensed.torso, outbox);
  }

  /// A tick of the sensors' faults begins.
  void begin_fault_tick(double time_s, std::int64_t period) noexcept {
    for (LegBoard& one : leg) one.faults().begin_tick(time_s, period);
    for (FootNode& one : foot) one.faults().begin_tick(time_s, period);
    imu.faults().begin_tick(time_s, period);
  }

  /// Calls `action(can::Node, node)` for each node.
  template <typename Action>
  void for_each(const Action& action) {
    for (const Side side : kSides) {
      action(can::leg_node(side), leg[index(side)]);
      action(can::foot_node(side), foot[index(side)]);
    }
    action(can::Node::kTorsoImu, imu);
  }

  PerSide<LegBoard> leg;
  PerSide<FootNode> foot;
  ImuNode imu;

 private:
  static SensorFaults faults_of(FaultTarget target, const SimConfig& config) {
    return SensorFaults(config.faults, target, config.seed, config.control_period_s);
  }
};

}  // namespace surefoot::sim_hw
