#include "firmware/core/decision/capture_step.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "firmware/core/gait/stance.hpp"

namespace surefoot::decision {
namespace {

constexpr double kGravity_m_s2 = 9.81;

/// Largest x of a foot on the floor that the leg reaches, body frame; never behind the hip.
double farthest_x_m(const gait::WalkParameters& walk, const CaptureConfig& config, Side side,
                    const FootPath& end) noexcept {
  const geometry::RobotGeometry& robot = config.geometry;
  const double leg_m = config.leg_use * (robot.thigh_m + robot.calf_m);
  const double down_m = walk.body_height_m - robot.ankle_height_m;
  const double aside_m = end.position_body_m.y() - robot.hip_body_m(side).y();
  return robot.hip_x_body_m + std::sqrt(std::max(0.0, leg_m * leg_m - down_m * down_m - aside_m * aside_m));
}

}  // namespace

double pendulum_rate_per_s(const CaptureConfig& config) noexcept {
  return std::sqrt(kGravity_m_s2 / config.com_height_m);
}

double capture_point_after_m(const CaptureConfig& config, double capture_point_m, double time_s) noexcept {
  const double pressure_m = std::min(capture_point_m, config.geometry.sole_toe_m);
  return pressure_m + (capture_point_m - pressure_m) * std::exp(pendulum_rate_per_s(config) * time_s);
}

CaptureStep plan_capture(const gait::WalkParameters& walk, const CaptureConfig& config, const CaptureState& state,
                         double duration_s) noexcept {
  const bool is_right_up = gait::is_airborne(walk, state.feet[index(Side::kRight)]);
  const bool is_left_up = gait::is_airborne(walk, state.feet[index(Side::kLeft)]);
  const Side swing = is_right_up ? Side::kRight : Side::kLeft;
  const FootPath& standing = state.feet[index(opposite(swing))];
  const double standing_x_m = standing.position_body_m.x();
  const double ahead_m = state.feet[index(swing)].position_body_m.x() - standing_x_m;
  const double speed_m_s = -standing.velocity_body_m_s.x();

  const bool tips_back = state.tilt_rate_rise_rad_s < -config.tilt_back_rad_s;
  const double com_m = state.com_x_body_m + (tips_back ? 0.0 : config.load_shift_m);
  const double capture_m =
      capture_point_after_m(config, com_m + speed_m_s / pendulum_rate_per_s(config) - standing_x_m, duration_s);

  CaptureStep step;
  const bool is_known = std::isfinite(capture_m);
  step.capture_point_x_body_m = standing_x_m + (is_known ? capture_m : 0.0);
  step.end = gait::stance(walk, {0.0, 0.0});
  const double braked_x_m = standing_x_m - 0.5 * speed_m_s * duration_s;
  const double sole_middle_m = 0.5 * (config.geometry.sole_toe_m - config.geometry.sole_heel_m);
  const double wanted_m = capture_m - sole_middle_m;  // of the foremost foot, from the standing one
  if (is_known && (is_right_up || is_left_up) && wanted_m > std::max(0.0, ahead_m)) {
    const double leg_m = farthest_x_m(walk, config, swing, step.end[index(swing)]) - braked_x_m - ahead_m;
    step.step_m = std::max(0.0, std::min({wanted_m - ahead_m, config.max_step_m, leg_m}));
  }
  step.end[index(opposite(swing))].position_body_m.x() = braked_x_m;
  step.end[index(swing)].position_body_m.x() = braked_x_m + ahead_m + step.step_m;
  return step;
}

double gentle_shift_s(const CaptureConfig& config, double distance_m, double least_s) noexcept {
  const double peak = 10.0 / std::numbers::sqrt3;  // of the quintic's acceleration, in d / T^2
  return std::max(least_s, std::sqrt(peak * std::abs(distance_m) / config.shift_acceleration_m_s2));
}

}  // namespace surefoot::decision
