#pragma once

#include <optional>

namespace surefoot::planning {

/// What a planned walk is made of, along the direction of walking. Source: Al-Shuka et al. 2014.
struct GaitFactors {
  double com_height_m = 0.85;          ///< H, constant, above the ankles
  double step_length_m = 0.5;          ///< S: way of the centre of mass in a step
  double single_support_share = 0.75;  ///< p, of that way; in (0, 1)
  double single_support_s = 0.5;       ///< T_s
  double double_support_s = 0.125;     ///< T_d

  [[nodiscard]] double step_s() const noexcept { return single_support_s + double_support_s; }
  [[nodiscard]] double speed_m_s() const noexcept { return step_length_m / step_s(); }
  /// s_s = p S / 2, eq. (11)
  [[nodiscard]] double single_support_half_way_m() const noexcept { return 0.5 * single_support_share * step_length_m; }
  /// s_d = (1 - p) S / 2, eq. (12)
  [[nodiscard]] double double_support_half_way_m() const noexcept {
    return 0.5 * (1.0 - single_support_share) * step_length_m;
  }
};

/// w = sqrt(g / H) of an inverted pendulum, eqs. (4), (10).
[[nodiscard]] double natural_rate_rad_s(double com_height_m) noexcept;

/// The one duration of double support that joins the supports without a step in acceleration:
/// T_d = (2 / w_d) atan(sqrt((1 - p) / p) tanh(w_s T_s / 2)), the closed form of eq. (16). Falls as p grows; does not
/// depend on the step length.
[[nodiscard]] double continuous_double_support_s(const GaitFactors&) noexcept;

/// Its inverse: p for these durations and this height.
/// @return nothing where no p in (0, 1) does, or an argument is no positive number
[[nodiscard]] std::optional<double> continuous_single_support_share(double com_height_m, double single_support_s,
                                                                    double double_support_s) noexcept;

/// Coefficient of friction under which the walk does not slip, eqs. (17), (18): p S / (2 H), the largest |x''| / g of
/// either support.
[[nodiscard]] double least_friction(const GaitFactors&) noexcept;

}  // namespace surefoot::planning
