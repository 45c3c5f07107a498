#pragma once

#include "firmware/core/stabilizer/gradual.hpp"

namespace surefoot::stabilizer {

/// Soft landing: the ankle of the foot that lands yields to the moment of the floor, u' = u + T / (C s + K), so that
/// the sole lies down on a tilted tile; and the step waits until the foot carries. Source: Kim, Park, Oh 2006,
/// reconstructed; the waiting is section 3.2.4 of the 2007 paper. Moments within a band, as flat landings have them,
/// move nothing.
struct SoftLandingConfig {
  double stiffness_nm_per_rad = 1000.0;  ///< K
  double damping_nm_s_per_rad = 50.0;    ///< C
  double band_nm = 5.0;
  double max_angle_rad = 0.035;
  double fade_s = 0.3;  ///< back to zero, on the ground and in the air
};

struct SoftLandingState {
  PerSide<AnkleAngles> added_angle{};
};

/// One tick. Turns the moving foot while it carries. The wait is asked for as long as a foot comes down: the schedule's
/// double support begins only when it is over.
/// @return ankle angles of both feet, each within `max_angle_rad`, and `waits_for_contact`
[[nodiscard]] Adjustment step(const SoftLandingConfig&, SoftLandingState&, const StabilizerInput&,
                              bool is_active) noexcept;

}  // namespace surefoot::stabilizer
