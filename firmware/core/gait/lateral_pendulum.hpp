#pragma once

#include "firmware/core/gait/motion_profile.hpp"

namespace surefoot::gait {

/// The centre of mass across the direction of walking, as a pendulum over the foot that carries and a hanging one
/// between the feet: what method 2 of Al-Shuka et al. 2014 has along the walk, turned by 90 degrees.
///
/// Single support: y = y_f - a cosh(w (t - T_s / 2)), the pressure centre rests under the foot at y_f. Double support:
/// y = b sin(w_d (t - T_d / 2)), the pressure centre runs from foot to foot. They join without a step in position,
/// velocity or acceleration where w_d tan(w_d T_d / 2) = w / tanh(w T_s / 2).
class LateralPendulum {
 public:
  LateralPendulum() = default;

  /// Cost: 60 tangents.
  ///
  /// @param foot_offset_y_m     y_f, of either foot from the middle, > 0
  /// @param natural_rate_rad_s  w = sqrt(g / z_c), > 0
  /// @param single_support_s    T_s, > 0
  /// @param double_support_s    T_d, > 0
  LateralPendulum(double foot_offset_y_m, double natural_rate_rad_s, double single_support_s,
                  double double_support_s) noexcept;

  /// Way from the middle towards the foot that carries this step.
  /// @param step_time_s  since the begin of the double support, up to T_d + T_s; before it, steps like this one went
  [[nodiscard]] ScalarMotion at(double step_time_s) const noexcept;

  /// y at its largest, half way through single support.
  [[nodiscard]] double amplitude_m() const noexcept { return foot_offset_y_m_ - cosh_m_; }

 private:
  [[nodiscard]] ScalarMotion within_step(double step_time_s) const noexcept;

  double foot_offset_y_m_ = 0.0;
  double natural_rate_rad_s_ = 1.0;
  double single_support_s_ = 1.0;
  double double_support_s_ = 1.0;
  double hanging_rate_rad_s_ = 1.0;  ///< w_d
  double sine_m_ = 0.0;              ///< b
  double cosh_m_ = 0.0;              ///< a
};

}  // namespace surefoot::gait
