#include "sim_hw/world/world.hpp"

#include <algorithm>

#include "sim_hw/world/bullet_floor.hpp"
#include "sim_hw/world/slope.hpp"
#include "sim_hw/world/spring_floor.hpp"

namespace surefoot::sim_hw {
namespace {

std::unique_ptr<Floor> make_floor(const SimConfig& config, RobotModel& robot) {
  if (config.contact.model == ContactModel::kBullet) {
    return std::make_unique<BulletFloor>(config.geometry, config.contact, robot);
  }
  return std::make_unique<SpringFloor>(config.geometry, config.contact);
}

/// Height of the lowest corner of both soles.
double lowest_corner_m(const RobotModel& robot, const geometry::RobotGeometry& geometry) {
  double lowest = 0.0;
  for (const Side side : kSides) {
    const BodyMotion foot = robot.foot_motion(side);
    for (std::size_t i = 0; i < geometry::kCornersPerFoot; ++i) {
      const btVector3 corner = to_bullet(geometry.corner_foot_m(static_cast<geometry::Corner>(i)));
      lowest = std::min(lowest, (foot.position_m + foot.rotation_world_from_body * corner).z());
    }
  }
  return lowest;
}

}  // namespace

World::World(const SimConfig& config, const PerSide<LegVector>& initial_angle_rad)
    : robot_(config.geometry, config.mass, config.drive, gravity_floor_m_s2(config.contact)),
      floor_(make_floor(config, robot_)),
      unloaded_trunk_(robot_.trunk()) {
  reserve_boxes(config.payloads.size());
  robot_.set_joints(initial_angle_rad, {});
  const double height = -lowest_corner_m(robot_, config.geometry) - floor_->resting_depth_m(robot_.total_mass_kg());
  robot_.place_body({0.0, 0.0, height}, geometry::Matrix3::Identity(), geometry::Vector3::Zero(),
                    geometry::Vector3::Zero());
  floor_->touch(robot_);
}

void World::advance(const PerSide<LegVector>& motor_torque_nm, double step_s) noexcept {
  floor_->step(robot_, motor_torque_nm, step_s);
  push_impulse_n_s_ += step_s * push_force_n_;
  push_force_n_.setZero();
  const PerSide<SoleLoad>& load = floor_->loads();
  const double carried_n = load[0].normal_sum_n() + load[1].normal_sum_n();
  if (carried_n > 0.0) slip_m_ += (load[0].sliding_n_m + load[1].sliding_n_m) / carried_n;
}

void World::hang(const PayloadConfig& payload) noexcept {
  robot_.set_trunk(hang_payload(robot_.trunk(), payload));
  boxes_.push_back({payload});
  payload_kg_ += payload.mass_kg;
}

void World::take_off(std::size_t place) noexcept {
  Box& taken = boxes_[place];
  if (!taken.hangs) return;
  taken.hangs = false;
  TrunkMass trunk = unloaded_trunk_;  // from the start, so that no rounding adds up
  for (const Box& box : boxes_) {
    if (box.hangs) trunk = hang_payload(trunk, box.payload);
  }
  robot_.set_trunk(trunk);
  ++payloads_removed_;
  removed_kg_ += taken.payload.mass_kg;
}

void World::push(const geometry::Vector3& force_world_n, const geometry::Vector3& point_body_m) noexcept {
  robot_.push_trunk(force_world_n, point_body_m);
  push_force_n_ += force_world_n;
}

}  // namespace surefoot::sim_hw
