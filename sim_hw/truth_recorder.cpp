#include "sim_hw/truth_recorder.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace surefoot::sim_hw {
namespace {

constexpr double kFallenHeightShare = 0.5;
constexpr double kFallenTiltRad = std::numbers::pi / 4.0;

std::array<double, 3> to_array(const geometry::Vector3& v) noexcept { return {v.x(), v.y(), v.z()}; }

}  // namespace

TruthRecorder::TruthRecorder(const World& world, double time_s, bool has_inertial_legs) noexcept
    : has_inertial_legs_(has_inertial_legs), initial_height_m_(world.robot().body_position_world_m().z()) {
  truth_.time_s = time_s;
  read_pose(world);
  add_step(world.loads());
  read_forces(world.robot(), 1);
  // The robot starts upright on the floor and at rest. A difference from zero, so that no component reads -0.
  torso_.specific_force_body_m_s2 = geometry::Vector3::Zero() - world.robot().gravity_world_m_s2();
  if (has_inertial_legs_) read_legs(world.robot(), 1.0);  // at rest, whatever the period
}

void TruthRecorder::add_step(const PerSide<SoleLoad>& loads) noexcept {
  for (const Side side : kSides) {
    const SoleLoad& load = loads[index(side)];
    for (std::size_t i = 0; i < geometry::kCornersPerFoot; ++i) force_sum_n_[index(side)][i] += load.normal_n[i];
    moment_sum_nm_ += load.normal_moment_world_nm;
  }
}

void TruthRecorder::close_period(const World& world, const PerSide<LegVector>& torque_nm, double time_s, int steps,
                                 double period_s) noexcept {
  const std::array<double, 3> before = truth_.body_velocity_world_m_s;
  read_pose(world);
  truth_.time_s = time_s;
  truth_.torque_nm = torque_nm;
  truth_.payloads_hung = world.payloads_hung();
  truth_.payload_kg = world.payload_kg();
  truth_.payloads_removed = world.payloads_removed();
  truth_.removed_kg = world.removed_kg();
  truth_.push_impulse_world_n_s = to_array(world.push_impulse_n_s());
  truth_.slip_m = world.slip_m();

  const RobotModel& robot = world.robot();
  read_forces(robot, steps);

  const geometry::Vector3 velocity_change =
      robot.body_velocity_world_m_s() - geometry::Vector3(before[0], before[1], before[2]);
  torso_.specific_force_body_m_s2 =
      robot.rotation_world_from_body().transpose() * (velocity_change / period_s - robot.gravity_world_m_s2());
  if (has_inertial_legs_) read_legs(robot, period_s);
}

void TruthRecorder::read_legs(const RobotModel& robot, double period_s) noexcept {
  const auto motions = robot.motions();
  const geometry::Vector3& gravity_world = robot.gravity_world_m_s2();
  for (const Side side : kSides) {
    LegInertialMotion& leg = leg_inertial_[index(side)];
    const BodyMotion& hip = motions[static_cast<std::size_t>(RobotModel::link(side, LegJoint::kHipRoll))];
    leg.hip_roll_rate_rad_s = (hip.rotation_world_from_body.transpose() * hip.angular_rad_s).x();

    const BodyMotion sole = robot.foot_motion(side);
    const geometry::Matrix3 foot_from_world = from_bullet(sole.rotation_world_from_body).transpose();
    const geometry::Vector3 up_foot = foot_from_world * -gravity_world.normalized();
    leg.sole_roll_rad = std::atan2(up_foot.y(), up_foot.z());
    leg.sole_pitch_rad = -std::asin(std::clamp(up_foot.x(), -1.0, 1.0));
    const geometry::Vector3 velocity_world = from_bullet(sole.velocity_m_s);
    const geometry::Vector3 velocity_change = velocity_world - sole_velocity_world_m_s_[index(side)];
    leg.specific_force_foot_m_s2 = foot_from_world * (velocity_change / period_s - gravity_world);
    sole_velocity_world_m_s_[index(side)] = velocity_world;
  }
}

void TruthRecorder::read_forces(const RobotModel& robot, int steps) noexcept {
  double carried_n = 0.0;
  for (const Side side : kSides) {
    for (std::size_t i = 0; i < geometry::kCornersPerFoot; ++i) {
      carried_n += force_sum_n_[index(side)][i];
      truth_.corner_force_n[index(side)][i] = force_sum_n_[index(side)][i] / steps;
    }
  }
  if (carried_n > 0.0) {
    const geometry::Vector3 pressure_centre_world = from_bullet(moment_sum_nm_) / carried_n;
    truth_.zmp_x_body_m =
        (robot.rotation_world_from_body().transpose() * (pressure_centre_world - robot.body_position_world_m())).x();
  }
  force_sum_n_ = {};
  moment_sum_nm_.setZero();
}

void TruthRecorder::read_pose(const World& world) noexcept {
  const RobotModel& robot = world.robot();
  const geometry::Matrix3 rotation = robot.rotation_world_from_body();
  truth_.body_position_world_m = to_array(robot.body_position_world_m());
  truth_.body_velocity_world_m_s = to_array(robot.body_velocity_world_m_s());
  truth_.body_rate_body_rad_s = to_array(robot.body_rate_body_rad_s());
  torso_.angular_rate_body_rad_s = robot.body_rate_body_rad_s();
  truth_.roll_rad = std::atan2(rotation(2, 1), rotation(2, 2));
  truth_.pitch_rad = -std::asin(std::clamp(rotation(2, 0), -1.0, 1.0));
  truth_.yaw_rad = std::atan2(rotation(1, 0), rotation(0, 0));
  truth_.angle_rad = robot.angles_rad();
  truth_.rate_rad_s = robot.rates_rad_s();
  // Written so that NaN counts as fallen.
  const bool stands = truth_.body_position_world_m[2] >= kFallenHeightShare * initial_height_m_ &&
                      rotation(2, 2) >= std::cos(kFallenTiltRad);
  if (!stands) truth_.has_fallen = true;
}

}  // namespace surefoot::sim_hw
