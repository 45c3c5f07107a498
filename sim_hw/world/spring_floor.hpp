#pragma once

#include "sim_hw/world/corner_contact.hpp"
#include "sim_hw/world/floor.hpp"

namespace surefoot::sim_hw {

/// The default floor: spring-dampers under eight corners, the tree driven without a Bullet world.
/// Does not allocate.
class SpringFloor final : public Floor {
 public:
  SpringFloor(const geometry::RobotGeometry&, const ContactConfig&, const TerrainConfig& = {});

  void step(RobotModel&, const PerSide<LegVector>& motor_torque_nm, double step_s) noexcept override;
  void touch(const RobotModel&) noexcept override;
  [[nodiscard]] const PerSide<SoleLoad>& loads() const noexcept override { return load_; }
  [[nodiscard]] double resting_depth_m(double total_mass_kg) const noexcept override;
  [[nodiscard]] std::unique_ptr<Floor> copy() const override { return std::make_unique<SpringFloor>(*this); }

 private:
  double normal_gravity_m_s2_;
  double normal_stiffness_n_per_m_;
  PerSide<CornerContact> contact_;
  PerSide<SoleLoad> load_{};
};

}  // namespace surefoot::sim_hw
