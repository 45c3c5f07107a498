#pragma once

#include <algorithm>
#include <cmath>

#include "firmware/core/kinematics/leg_kinematics.hpp"
#include "sim_hw/world/world.hpp"

namespace surefoot::sim_hw::testing {

/// Joint angles with both soles flat at the given place under the hips.
inline PerSide<LegVector> stance(const geometry::RobotGeometry& geometry, double foot_x_body_m = -0.09,
                                 double body_height_m = 0.5) {
  PerSide<LegVector> angle;
  for (const Side side : kSides) {
    kinematics::FootPose pose;
    pose.position_body_m = {foot_x_body_m, lateral_sign(side) * geometry.hip_y_body_m, -body_height_m};
    angle[index(side)] = kinematics::inverse(geometry, side, pose).angle_rad;
  }
  return angle;
}

inline constexpr LegVector kStiffness{30000.0, 30000.0, 30000.0, 30000.0, 30000.0, 20000.0};
inline constexpr LegVector kDamping{120.0, 120.0, 120.0, 120.0, 90.0, 80.0};

/// A joint PD of its own, so that these tests do not lean on the firmware's.
inline PerSide<LegVector> hold(const PerSide<LegVector>& wanted_rad, const PerSide<LegVector>& angle_rad,
                               const PerSide<LegVector>& rate_rad_s) {
  PerSide<LegVector> torque;
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
      const double error = wanted_rad[side][joint] - angle_rad[side][joint];
      torque[side][joint] =
          std::clamp(kStiffness[joint] * error - kDamping[joint] * rate_rad_s[side][joint], -200.0, 200.0);
    }
  }
  return torque;
}

/// A world whose robot is held in a stance by the PD, 1 kHz, torques one millisecond late.
class StandingRobot {
 public:
  explicit StandingRobot(const SimConfig& config, int latency_ticks = 1)
      : config_(config), stance_(stance(config.geometry)), latency_ticks_(latency_ticks), world(config, stance_) {}

  /// One control period.
  void tick() {
    const PerSide<LegVector> wanted = hold(stance_, world.robot().angles_rad(), world.robot().rates_rad_s());
    const PerSide<LegVector> before = torque_nm;
    torque_nm = latency_ticks_ == 0 ? wanted : pending_;
    pending_ = wanted;
    const int steps = static_cast<int>(std::lround(config_.control_period_s / config_.physics_step_s));
    ripple_nm = 0.0;
    for (std::size_t side = 0; side < 2; ++side) {
      for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
        ripple_nm = std::max(ripple_nm, std::abs(torque_nm[side][joint] - before[side][joint]));
      }
    }
    for (int i = 0; i < steps; ++i) world.advance(torque_nm, config_.physics_step_s);
  }

  void stand(double duration_s) {
    for (double t = 0.0; t < duration_s; t += config_.control_period_s) tick();
  }

  [[nodiscard]] double carried_n() const { return world.loads()[0].normal_sum_n() + world.loads()[1].normal_sum_n(); }

  /// Robot is upright to some 1e-4 rad: world and body axes agree.
  [[nodiscard]] double zmp_x_body_m() const {
    const double moment = world.loads()[0].normal_moment_world_nm.x() + world.loads()[1].normal_moment_world_nm.x();
    return moment / carried_n() - world.robot().body_position_world_m().x();
  }

 private:
  SimConfig config_;
  PerSide<LegVector> stance_;
  PerSide<LegVector> pending_{};
  int latency_ticks_;

 public:
  World world;
  PerSide<LegVector> torque_nm{};
  double ripple_nm = 0.0;  ///< largest change of a torque from the tick before
};

}  // namespace surefoot::sim_hw::testing
