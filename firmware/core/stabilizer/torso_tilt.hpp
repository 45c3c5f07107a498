#pragma once

#include "firmware/core/stabilizer/gradual.hpp"

namespace surefoot::stabilizer {

/// Centre of the pelvis' swing, once a step: moves against the mean deviation of the torso's roll and pitch in the last
/// step.
/// Source: Kim, Park, Oh 2006, reconstructed.
struct TorsoTiltConfig {
  double gain_m_per_rad = 0.115;  ///< 2 mm per degree and step
  double kept_share = 0.9;        ///< of the adaptation from step to step: what a constant tilt adds up to is bounded
  double band_rad = 0.002;        ///< of the mean, within which nothing is learned
  double max_offset_m = 0.02;
  double smoothing_s = 0.2;  ///< of the output
};

struct TorsoTiltState {
  double roll_sum_rad_s = 0.0;  ///< integrals over this step
  double pitch_sum_rad_s = 0.0;
  double time_s = 0.0;
  double learned_x_m = 0.0;
  double learned_y_m = 0.0;
  double centre_x_m = 0.0;  ///< outputs
  double centre_y_m = 0.0;
};

/// One tick. Learns in the first tick of a step, if active; keeps what it has while inactive.
/// @return `sway_centre_x_m` and `sway_centre_y_m`, each within `max_offset_m`
[[nodiscard]] Adjustment step(const TorsoTiltConfig&, TorsoTiltState&, const StabilizerInput&, bool is_active) noexcept;

}  // namespace surefoot::stabilizer
