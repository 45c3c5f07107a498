#pragma once

#include <memory>

#include "sim_hw/plant_config.hpp"
#include "sim_hw/world/floor.hpp"

namespace surefoot::sim_hw {

/// The second opinion: Bullet's own contact solver, rigid contact and a friction pyramid, on four
/// small spheres a sole and a plane, or boxes for a rough floor. Takes friction from the configuration and ignores its
/// stiffness and damping. Several times slower than `SpringFloor`; Bullet allocates at will.
class BulletFloor final : public Floor {
 public:
  /// @param robot  becomes part of the world; outlives this object
  BulletFloor(const geometry::RobotGeometry&, const ContactConfig&, const TerrainConfig&, RobotModel& robot);
  ~BulletFloor() override;
  BulletFloor(const BulletFloor&) = delete;
  BulletFloor& operator=(const BulletFloor&) = delete;

  void step(RobotModel&, const PerSide<LegVector>& motor_torque_nm, double step_s) noexcept override;
  void touch(const RobotModel&) noexcept override {}
  [[nodiscard]] const PerSide<SoleLoad>& loads() const noexcept override { return load_; }
  [[nodiscard]] double resting_depth_m(double total_mass_kg) const noexcept override;

 private:
  struct BulletWorld;
  std::unique_ptr<BulletWorld> world_;
  PerSide<SoleLoad> load_{};
};

}  // namespace surefoot::sim_hw
