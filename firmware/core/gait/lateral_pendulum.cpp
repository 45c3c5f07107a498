#include "firmware/core/gait/lateral_pendulum.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace surefoot::gait {
namespace {

/// The root of w_d tan(w_d T_d / 2) = wanted below the tangent's pole; the left side grows with w_d.
double hanging_rate_rad_s(double wanted_rad_s, double double_support_s) noexcept {
  double least = 0.0;
  double most = std::numbers::pi / double_support_s;
  for (int turn = 0; turn < 60; ++turn) {
    const double middle = 0.5 * (least + most);
    (middle * std::tan(0.5 * middle * double_support_s) < wanted_rad_s ? least : most) = middle;
  }
  return 0.5 * (least + most);
}

}  // namespace

LateralPendulum::LateralPendulum(double foot_offset_y_m, double natural_rate_rad_s, double single_support_s,
                                 double double_support_s) noexcept
    : foot_offset_y_m_(foot_offset_y_m),
      natural_rate_rad_s_(natural_rate_rad_s),
      single_support_s_(single_support_s),
      double_support_s_(double_support_s) {
  const double w = natural_rate_rad_s;
  const double half = 0.5 * w * single_support_s;
  hanging_rate_rad_s_ = hanging_rate_rad_s(w / std::tanh(half), double_support_s);
  const double per_square = w * w / (hanging_rate_rad_s_ * hanging_rate_rad_s_);
  const double at_lift_m = foot_offset_y_m * per_square / (1.0 + per_square);  // equal accelerations
  cosh_m_ = (foot_offset_y_m - at_lift_m) / std::cosh(half);
  sine_m_ = at_lift_m / std::sin(0.5 * hanging_rate_rad_s_ * double_support_s);
}

ScalarMotion LateralPendulum::at(double step_time_s) const noexcept {
  if (step_time_s < 0.0) {
    const double step_s = single_support_s_ + double_support_s_;
    const double steps = std::ceil(-step_time_s / step_s);
    const ScalarMotion other = within_step(std::max(0.0, step_time_s + steps * step_s));
    return std::fmod(steps, 2.0) == 0.0 ? other : ScalarMotion{-other.position, -other.velocity, -other.acceleration};
  }
  return within_step(step_time_s);
}

ScalarMotion LateralPendulum::within_step(double step_time_s) const noexcept {
  if (step_time_s <= double_support_s_) {
    const double w = hanging_rate_rad_s_;
    const double angle = w * (step_time_s - 0.5 * double_support_s_);
    const double y_m = sine_m_ * std::sin(angle);
    return {y_m, sine_m_ * w * std::cos(angle), -w * w * y_m};
  }
  const double w = natural_rate_rad_s_;
  const double angle = w * (step_time_s - double_support_s_ - 0.5 * single_support_s_);
  const double lever_m = cosh_m_ * std::cosh(angle);
  return {foot_offset_y_m_ - lever_m, -cosh_m_ * w * std::sinh(angle), -w * w * lever_m};
}

}  // namespace surefoot::gait
