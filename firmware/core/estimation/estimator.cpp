#include "firmware/core/estimation/estimator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "firmware/core/kinematics/leg_kinematics.hpp"

namespace surefoot::estimation {
namespace {

void set_factors(const EstimatorConfig& config, EstimatorState& state, double period_s) noexcept {
  if (state.factor_period_s == period_s) return;
  state.factor_period_s = period_s;
  state.force_factor = -std::expm1(-period_s / config.force_time_constant_s);
  state.zmp_factor = -std::expm1(-period_s / config.zmp_time_constant_s);
}

/// First-order low pass that starts at its first value.
void filter(double& filtered, bool& has_value, double factor, double value) noexcept {
  filtered = has_value ? filtered + factor * (value - filtered) : value;
  has_value = true;
}

/// Sum of force times position over the corners of one foot, body frame.
geometry::Vector3 moment_sum(const geometry::RobotGeometry& robot, const kinematics::FootPose& pose,
                             const FootSensors& foot) noexcept {
  double force_n = 0.0;
  geometry::Vector3 weighted_foot = geometry::Vector3::Zero();
  for (std::size_t corner = 0; corner < geometry::kCornersPerFoot; ++corner) {
    force_n += foot.corner_force_n[corner];
    weighted_foot += foot.corner_force_n[corner] * robot.corner_foot_m(static_cast<geometry::Corner>(corner));
  }
  return force_n * pose.position_body_m + pose.rotation_body_from_foot * weighted_foot;
}

bool are_fresh(const auto& nodes) noexcept {
  return std::all_of(nodes.begin(), nodes.end(), [](const auto& node) { return node.freshness.is_fresh(); });
}

}  // namespace

Estimate step(const EstimatorConfig& config, const geometry::RobotGeometry& robot, EstimatorState& state,
              const SensorSnapshot& sensors, double period_s) noexcept {
  set_factors(config, state, period_s);
  Estimate estimate;
  for (const Side side : kSides) {
    const auto& corners = sensors.foot[index(side)].corner_force_n;
    estimate.foot_force_n[index(side)] = std::accumulate(corners.begin(), corners.end(), 0.0);
    estimate.vertical_force_n += estimate.foot_force_n[index(side)];
  }

  if (are_fresh(sensors.foot)) {
    filter(state.filtered_force_n, state.has_force, state.force_factor, estimate.vertical_force_n);
    if (estimate.vertical_force_n >= config.min_force_for_zmp_n && are_fresh(sensors.leg)) {
      geometry::Vector3 sum = geometry::Vector3::Zero();
      double heel_x_m = std::numeric_limits<double>::infinity();
      double toe_x_m = -heel_x_m;
      for (const Side side : kSides) {
        const kinematics::FootPose pose = kinematics::forward(robot, side, sensors.leg[index(side)].angle_rad);
        sum += moment_sum(robot, pose, sensors.foot[index(side)]);
        heel_x_m = std::min(heel_x_m, pose.position_body_m.x() - robot.sole_heel_m);
        toe_x_m = std::max(toe_x_m, pose.position_body_m.x() + robot.sole_toe_m);
      }
      state.zmp_x_body_m = sum.x() / estimate.vertical_force_n;
      state.zmp_y_body_m = sum.y() / estimate.vertical_force_n;
      bool has_zmp_y = state.has_zmp;
      filter(state.filtered_zmp_y_body_m, has_zmp_y, state.zmp_factor, state.zmp_y_body_m);
      filter(state.filtered_zmp_x_body_m, state.has_zmp, state.zmp_factor, state.zmp_x_body_m);
      state.is_zmp_within_feet = state.filtered_zmp_x_body_m >= heel_x_m && state.filtered_zmp_x_body_m <= toe_x_m;
    }
  }
  if (sensors.torso.freshness.is_fresh()) {
    state.roll_rate_rad_s = sensors.torso.angular_rate_body_rad_s.x();
    state.pitch_rate_rad_s = sensors.torso.angular_rate_body_rad_s.y();
    filter(state.mean_pitch_rate_rad_s, state.has_pitch_rate, state.force_factor, state.pitch_rate_rad_s);
  }
  estimate.filtered_force_n = state.filtered_force_n;
  estimate.zmp_x_body_m = state.zmp_x_body_m;
  estimate.zmp_y_body_m = state.zmp_y_body_m;
  estimate.filtered_zmp_x_body_m = state.filtered_zmp_x_body_m;
  estimate.filtered_zmp_y_body_m = state.filtered_zmp_y_body_m;
  estimate.roll_rate_rad_s = state.roll_rate_rad_s;
  estimate.pitch_rate_rad_s = state.pitch_rate_rad_s;
  estimate.pitch_rate_rise_rad_s = state.pitch_rate_rad_s - state.mean_pitch_rate_rad_s;
  estimate.is_zmp_within_feet = state.is_zmp_within_feet;
  return estimate;
}

}  // namespace surefoot::estimation
