#include "sim_hw/world/world.hpp"

#include <algorithm>
#include <array>
#include <functional>

#include "sim_hw/world/bullet_floor.hpp"
#include "sim_hw/world/slope.hpp"
#include "sim_hw/world/spring_floor.hpp"
#include "sim_hw/world/terrain.hpp"

namespace surefoot::sim_hw {
namespace {

constexpr std::size_t kHipRoll = index(LegJoint::kHipRoll);
constexpr std::size_t kCorners = kSides.size() * geometry::kCornersPerFoot;

std::unique_ptr<Floor> make_floor(const SimConfig& config, RobotModel& robot) {
  if (config.contact.model == ContactModel::kBullet) {
    return std::make_unique<BulletFloor>(config.geometry, config.contact, config.terrain, robot);
  }
  return std::make_unique<SpringFloor>(config.geometry, config.contact, config.terrain);
}

/// Both soles' corners in the world.
std::array<btVector3, kCorners> corners_world_m(const RobotModel& robot, const geometry::RobotGeometry& geometry) {
  std::array<btVector3, kCorners> corner;
  for (const Side side : kSides) {
    const BodyMotion foot = robot.foot_motion(side);
    for (std::size_t i = 0; i < geometry::kCornersPerFoot; ++i) {
      const btVector3 corner_foot_m = to_bullet(geometry.corner_foot_m(static_cast<geometry::Corner>(i)));
      corner[index(side) * geometry::kCornersPerFoot + i] =
          foot.position_m + foot.rotation_world_from_body * corner_foot_m;
    }
  }
  return corner;
}

/// Height of the body at which the corners that touch carry the robot.
/// @param corner_m  with the body at height 0
double resting_height_m(const Terrain& terrain, std::array<btVector3, kCorners> corner_m, double depth_m) {
  if (terrain.is_plane()) {
    double lowest_m = 0.0;
    for (const btVector3& corner : corner_m) lowest_m = std::min(lowest_m, corner.z());
    return -lowest_m - depth_m;
  }
  std::array<double, kCorners> touches_at_m;  // height of the body at which each corner touches
  std::ranges::transform(corner_m, touches_at_m.begin(), [&](const btVector3& corner) {
    return terrain.height_m(corner.x(), corner.y()) - corner.z();
  });
  std::ranges::sort(touches_at_m, std::greater<>());
  // Depths of all that touch add up to those of eight corners at rest.
  double sum_m = -static_cast<double>(kCorners) * depth_m;
  double height_m = 0.0;
  for (std::size_t touching = 0; touching < kCorners; ++touching) {
    if (touching > 0 && touches_at_m[touching] <= height_m) break;
    sum_m += touches_at_m[touching];
    height_m = sum_m / static_cast<double>(touching + 1);
  }
  return height_m;
}

}  // namespace

World::World(const SimConfig& config, const PerSide<LegVector>& initial_angle_rad)
    : robot_(config.geometry, config.mass, config.drive, gravity_floor_m_s2(config.contact)),
      floor_(make_floor(config, robot_)),
      hip_roll_{HipSpring(config.drive, initial_angle_rad[0][kHipRoll]),
                HipSpring(config.drive, initial_angle_rad[1][kHipRoll])},
      has_flexible_hips_(HipSpring::is_flexible(config.drive)),
      unloaded_trunk_(robot_.trunk()) {
  reserve_boxes(config.payloads.size());
  robot_.set_joints(initial_angle_rad, {});
  const double height =
      resting_height_m(Terrain(config.terrain, config.contact.friction), corners_world_m(robot_, config.geometry),
                       floor_->resting_depth_m(robot_.total_mass_kg()));
  robot_.place_body({0.0, 0.0, height}, geometry::Matrix3::Identity(), geometry::Vector3::Zero(),
                    geometry::Vector3::Zero());
  floor_->touch(robot_);
}

void World::advance(const PerSide<LegVector>& motor_torque_nm, double step_s) noexcept {
  if (has_flexible_hips_) {
    const PerSide<LegVector> angle_rad = robot_.angles_rad();
    const PerSide<LegVector> rate_rad_s = robot_.rates_rad_s();
    PerSide<LegVector> joint_torque_nm = motor_torque_nm;
    for (std::size_t side = 0; side < kSides.size(); ++side) {
      joint_torque_nm[side][kHipRoll] = hip_roll_[side].step(motor_torque_nm[side][kHipRoll], angle_rad[side][kHipRoll],
                                                             rate_rad_s[side][kHipRoll], step_s);
    }
    floor_->step(robot_, joint_torque_nm, step_s);
  } else {
    floor_->step(robot_, motor_torque_nm, step_s);
  }
  push_impulse_n_s_ += step_s * push_force_n_;
  push_force_n_.setZero();
  const PerSide<SoleLoad>& load = floor_->loads();
  const double carried_n = load[0].normal_sum_n() + load[1].normal_sum_n();
  if (carried_n > 0.0) slip_m_ += (load[0].sliding_n_m + load[1].sliding_n_m) / carried_n;
}

PerSide<LegVector> World::motor_angles_rad() const noexcept {
  PerSide<LegVector> angle = robot_.angles_rad();
  if (has_flexible_hips_) {
    for (std::size_t side = 0; side < kSides.size(); ++side) angle[side][kHipRoll] = hip_roll_[side].angle_rad();
  }
  return angle;
}

PerSide<LegVector> World::motor_rates_rad_s() const noexcept {
  PerSide<LegVector> rate = robot_.rates_rad_s();
  if (has_flexible_hips_) {
    for (std::size_t side = 0; side < kSides.size(); ++side) rate[side][kHipRoll] = hip_roll_[side].rate_rad_s();
  }
  return rate;
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
