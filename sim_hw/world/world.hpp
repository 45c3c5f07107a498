#pragma once

#include <memory>
#include <vector>

#include "sim_hw/plant_config.hpp"
#include "sim_hw/world/floor.hpp"
#include "sim_hw/world/hip_spring.hpp"
#include "sim_hw/world/robot_model.hpp"

namespace surefoot::sim_hw {

/// Robot and floor. Fresh for every run; holds no global state. With `SpringFloor` a copy goes on as the original
/// does, to the last bit.
class World {
 public:
  /// The robot stands still and upright, yaw zero, body frame above the world's origin, at the height at which the
  /// corners of its soles that touch carry it: all of them on a plane, the highest ones on a rough floor.
  World(const SimConfig&, const PerSide<LegVector>& initial_angle_rad);

  /// Makes room for so many boxes in all, so that `hang` does not allocate.
  void reserve_boxes(std::size_t count) { boxes_.reserve(count); }

  /// One physics step with the motor torques held. They act on the joints, or on the rotor behind a flexible hip.
  void advance(const PerSide<LegVector>& motor_torque_nm, double step_s) noexcept;

  /// Hangs a box on the trunk, moving with it: no velocity of any body changes.
  void hang(const PayloadConfig&) noexcept;

  /// Takes a box off again: the trunk is what it would be had that box never hung there, and no velocity of any body
  /// changes.
  /// @param place  of the boxes ever hung on, counted from 0
  void take_off(std::size_t place) noexcept;

  /// Pushes the trunk during the next `advance`; several pushes add up.
  /// @param point_body_m  where, body frame
  void push(const geometry::Vector3& force_world_n, const geometry::Vector3& point_body_m) noexcept;

  [[nodiscard]] RobotModel& robot() noexcept { return robot_; }
  [[nodiscard]] const RobotModel& robot() const noexcept { return robot_; }
  /// What encoders see: the joints, but for a flexible hip roll drive its motor behind the gear.
  [[nodiscard]] PerSide<LegVector> motor_angles_rad() const noexcept;
  [[nodiscard]] PerSide<LegVector> motor_rates_rad_s() const noexcept;
  /// Floor forces of the last step.
  [[nodiscard]] const PerSide<SoleLoad>& loads() const noexcept { return floor_->loads(); }
  /// Way the soles have slid, each corner weighted with its share of the load.
  [[nodiscard]] double slip_m() const noexcept { return slip_m_; }
  /// Boxes hung on so far, and their mass, whether they hang still or not.
  [[nodiscard]] int payloads_hung() const noexcept { return static_cast<int>(boxes_.size()); }
  [[nodiscard]] double payload_kg() const noexcept { return payload_kg_; }
  /// Boxes taken off so far, and their mass.
  [[nodiscard]] int payloads_removed() const noexcept { return payloads_removed_; }
  [[nodiscard]] double removed_kg() const noexcept { return removed_kg_; }
  /// Sum of force times step of all pushes so far, world frame.
  [[nodiscard]] const geometry::Vector3& push_impulse_n_s() const noexcept { return push_impulse_n_s_; }

 private:
  struct Box {
    PayloadConfig payload;
    bool hangs = true;
  };

  RobotModel robot_;
  OwnFloor floor_;
  PerSide<HipSpring> hip_roll_;
  bool has_flexible_hips_;
  double slip_m_ = 0.0;
  TrunkMass unloaded_trunk_;
  std::vector<Box> boxes_;  ///< as they were hung on
  int payloads_removed_ = 0;
  double payload_kg_ = 0.0;
  double removed_kg_ = 0.0;
  geometry::Vector3 push_force_n_ = geometry::Vector3::Zero();  ///< of the next step
  geometry::Vector3 push_impulse_n_s_ = geometry::Vector3::Zero();
};

}  // namespace surefoot::sim_hw
