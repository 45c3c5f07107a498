#pragma once

#include "firmware/core/stabilizer/landing_shift.hpp"

namespace surefoot::stabilizer {

/// Landing position by the torso's tilt: while the foot comes down, its landing point moves to where the torso leans
/// and falls to; shortly before the landing it is settled.
/// Source: Kim, Park, Oh 2006, reconstructed: k1 tilt + k2 rate, at most 30 mm; tilt and rate against flat walking.
struct TiltLandingPositionConfig {
  double gain_m_per_rad = 0.3;      ///< k1
  double rate_gain_m_s_rad = 0.08;  ///< k2
  double band_m = 0.004;            ///< of the shift, within which the foot lands where the pattern has it
  double max_shift_m = 0.03;
  double max_inward_m = 0.0;    ///< towards the other foot; the soles of KHR-2 pass 2 mm apart
  double settled_share = 0.95;  ///< of the swing, from which the point stays
  double smoothing_s = 0.05;    ///< of the output; it also fades over this time
};

struct TiltLandingPositionState {
  LandingShift shift;
};

/// One tick. The shift stays through the double support, where the foot stands on it, and fades once inactive.
/// @return `landing_x_m` and `landing_y_m`, each within `max_shift_m`
[[nodiscard]] Adjustment step(const TiltLandingPositionConfig&, TiltLandingPositionState&, const StabilizerInput&,
                              bool is_active) noexcept;

}  // namespace surefoot::stabilizer
