#include "sim_hw/world/spring_floor.hpp"

#include "sim_hw/world/slope.hpp"

namespace surefoot::sim_hw {

SpringFloor::SpringFloor(const geometry::RobotGeometry& geometry, const ContactConfig& config,
                         const TerrainConfig& terrain)
    : normal_gravity_m_s2_(-gravity_floor_m_s2(config).z()),
      normal_stiffness_n_per_m_(config.normal_stiffness_n_per_m),
      contact_{CornerContact(geometry, config, terrain), CornerContact(geometry, config, terrain)} {}

void SpringFloor::step(RobotModel& robot, const PerSide<LegVector>& motor_torque_nm, double step_s) noexcept {
  for (const Side side : kSides) {
    const BodyMotion foot = robot.foot_motion(side);
    const SoleWrench wrench = contact_[index(side)].step(foot);
    load_[index(side)] = wrench.load;
    robot.push_foot(side, foot, wrench.force_world_n, wrench.torque_world_nm);
  }
  robot.drive_joints(motor_torque_nm);
  robot.integrate(step_s);
}

void SpringFloor::touch(const RobotModel& robot) noexcept {
  for (const Side side : kSides) load_[index(side)] = contact_[index(side)].step(robot.foot_motion(side)).load;
}

double SpringFloor::resting_depth_m(double total_mass_kg) const noexcept {
  return total_mass_kg * normal_gravity_m_s2_ / (2.0 * geometry::kCornersPerFoot * normal_stiffness_n_per_m_);
}

}  // namespace surefoot::sim_hw
