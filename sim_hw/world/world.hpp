#pragma once

#include <memory>

#include "sim_hw/plant_config.hpp"
#include "sim_hw/world/floor.hpp"
#include "sim_hw/world/robot_model.hpp"

namespace surefoot::sim_hw {

/// Robot and floor. Fresh for every run; holds no global state.
class World {
 public:
  /// The robot stands still and upright, yaw zero, body frame above the world's origin; the lowest
  /// corner of its soles lies at the depth at which the floor carries it.
  World(const SimConfig&, const PerSide<LegVector>& initial_angle_rad);

  /// One physics step with the motor torques held.
  void advance(const PerSide<LegVector>& motor_torque_nm, double step_s) noexcept;

  /// Hangs a box on the trunk, moving with it: no velocity of any body changes.
  void hang(const PayloadConfig&) noexcept;

  [[nodiscard]] RobotModel& robot() noexcept { return robot_; }
  [[nodiscard]] const RobotModel& robot() const noexcept { return robot_; }
  /// Floor forces of the last step.
  [[nodiscard]] const PerSide<SoleLoad>& loads() const noexcept { return floor_->loads(); }
  /// Way the soles have slid, each corner weighted with its share of the load.
  [[nodiscard]] double slip_m() const noexcept { return slip_m_; }
  /// Boxes hung on so far, and their mass.
  [[nodiscard]] int payloads_hung() const noexcept { return payloads_hung_; }
  [[nodiscard]] double payload_kg() const noexcept { return payload_kg_; }

 private:
  RobotModel robot_;
  std::unique_ptr<Floor> floor_;
  double slip_m_ = 0.0;
  int payloads_hung_ = 0;
  double payload_kg_ = 0.0;
};

}  // namespace surefoot::sim_hw
