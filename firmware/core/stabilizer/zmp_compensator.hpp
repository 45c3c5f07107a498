#pragma once

#include <array>

#include "firmware/core/stabilizer/gradual.hpp"

namespace surefoot::stabilizer {

/// ZMP compensator: moves the pelvis by the state of the compliant ankle, m l^2 phi'' = m g l phi - K (phi - u / l),
/// which an observer finds from the error of the supporting foot's ZMP, K (phi - u / l) / (m g), against flat walking.
/// Source: Kim, Park, Oh 2006, reconstructed. The gains place the poles of the feedback at -4 and of the observer at -8
/// for 56 kg, l = 0.9 m and K = 2450 N m/rad; u = -Kc (phi, phi') in metres.
struct ZmpCompensatorConfig {
  double stiffness_nm_per_rad = 2450.0;                ///< K
  double pendulum_m = 0.9;                             ///< l
  std::array<double, 2> feedback_gain{-0.452, 0.133};  ///< Kc in m/rad and m s/rad
  std::array<double, 2> observer_gain{3.588, 4.684};   ///< L in rad/(m s) and rad/(m s2)
  double max_offset_m = 0.05;
  double max_zmp_error_m = 0.1;  ///< a larger error counts as this much
  double fade_s = 0.1;           ///< of the observed state while inactive
};

/// Observed deviation from flat walking of one axis.
struct ObservedLean {
  double lean_rad = 0.0;  ///< phi
  double rate_rad_s = 0.0;
  double offset_m = 0.0;  ///< u in force
};

struct ZmpCompensatorState {
  ObservedLean x;  ///< forward
  ObservedLean y;  ///< to the left
};

/// One tick. While the supporting foot does not carry, the observed state fades as if inactive.
/// @return `pelvis_x_m` and `pelvis_y_m`, each within `max_offset_m`
[[nodiscard]] Adjustment step(const ZmpCompensatorConfig&, ZmpCompensatorState&, const StabilizerInput&,
                              bool is_active) noexcept;

}  // namespace surefoot::stabilizer
