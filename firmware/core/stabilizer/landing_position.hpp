#pragma once

#include "firmware/core/stabilizer/walk_view.hpp"

namespace surefoot::stabilizer {

/// Landing position: the swing foot lands where the floor's force stops as much roll as it shall.
/// Source: Kim, Park, Oh 2007, section 3.2.5, eqs. (12) to (15):
/// I (w_before - w_after) = (M_ankle + m g d) Delta t gives d, and d_final = d_pre + kp (d - d_pre).
/// kp is ours. M_ankle, the moment that the landing ankle will give, is taken as zero.
struct LandingPositionConfig {
  double inertia_kg_m2 = 45.4;         ///< about the landing foot
  double contact_s = 0.1;              ///< Delta t
  bool uses_nominal = true;            ///< d_pre: what the law says of flat walking; else the printed one
  double printed_momentum_nms = 11.0;  ///< I w_after, wanted after the landing
  double printed_distance_m = 0.071;   ///< d_pre
  double kp = 0.1;
  double max_shift_m = 0.04;
  double single_support_s = 0.9025;  ///< length of the swing
  double freeze_s = 0.05;            ///< before the planned landing, from where the point stays
  double smoothing_s = 0.03;
  double max_rate_m_s = 0.5;
  double fade_s = 0.05;
};

struct LandingPositionState {
  double shift_y_m = 0.0;  ///< d_final - d_pre, to the left
};

/// d of eq. (14): distance of the landing foot from the centre of mass that leaves I w_after.
///
/// @param rate_toward_rad_s  roll rate before the landing, positive toward the landing foot
[[nodiscard]] double landing_distance_m(const LandingPositionConfig&, double body_mass_kg,
                                        double rate_toward_rad_s) noexcept;

/// Reads the hip gyro of the supporting leg. Gives `landing_y_m`, which stays through the double support.
[[nodiscard]] Adjustment step(const LandingPositionConfig&, LandingPositionState&, const StabilizerInput&,
                              bool is_active) noexcept;

}  // namespace surefoot::stabilizer
