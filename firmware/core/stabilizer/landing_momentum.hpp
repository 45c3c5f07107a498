#pragma once

#include "firmware/core/stabilizer/walk_view.hpp"

namespace surefoot::stabilizer {

/// Landing angular momentum: when a foot lands while the body rolls too fast or too slowly toward it, the landed ankle
/// gives the moment that would bring the momentum to the desired one within `window_s`.
/// Source: Kim, Park, Oh 2007, section 3.2.2, eq. (10), Fig. 25b. Range and gains are ours: 30 N m of error turn the
/// ankle by 0.5 degrees in 0.1 s.
struct LandingMomentumConfig {
  double inertia_kg_m2 = 45.4;         ///< about the landing foot, m l^2
  bool uses_nominal = true;            ///< desired momentum: flat walking's; else the printed one
  double printed_momentum_nms = 11.0;  ///< I w_desired of the paper's robot
  double range_nms = 1.5;              ///< about the desired momentum; nothing happens inside
  double window_s = 0.1;               ///< Delta t, and the longest action
  double max_moment_nm = 38.0;
  double half_width_m = 0.07;  ///< of the sole: a moment beyond force times this would tip the foot
  double kp_rad_per_nm = 0.0;
  double ki_rad_per_nms = 0.0029;
  double max_angle_rad = 0.0175;
  double max_rate_rad_s = 0.5;
  double standing_fade_s = 60.0;  ///< time constant of the return while the foot stands in a walk; large: it holds
  double fade_s = 0.1;            ///< the same while the foot is lifted, and when the walk is over
};

struct LandingMomentumState {
  PerSide<double> ankle_roll_rad{};
  double integral_rad = 0.0;
  double desired_nms = 0.0;       ///< momentum toward the landed foot, latched at the landing
  double wanted_moment_nm = 0.0;  ///< that the floor shall give toward the landed foot, before clipping
  double acting_s = 0.0;
  bool has_judged = false;  ///< this landing
  bool is_acting = false;
};

/// M = (I w_desired - I w) / Delta t, eq. (10), before clipping.
///
/// @param rate_toward_rad_s  roll rate, positive toward the landing foot
[[nodiscard]] double landing_moment_nm(const LandingMomentumConfig&, double desired_nms,
                                       double rate_toward_rad_s) noexcept;

/// Reads the hip gyro of the supporting leg and the landed ankle's moment. Gives ankle roll angles.
[[nodiscard]] Adjustment step(const LandingMomentumConfig&, LandingMomentumState&, const StabilizerInput&,
                              bool is_active) noexcept;

}  // namespace surefoot::stabilizer
