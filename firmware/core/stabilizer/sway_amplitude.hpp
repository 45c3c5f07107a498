#pragma once

#include "firmware/core/stabilizer/gradual.hpp"

namespace surefoot::stabilizer {

/// Amplitude of the pelvis' swing, once a step: A grows by Ka (Y_ref - Y) / (1 + l w^2 / g), Y the ZMP's outermost
/// place in the last step and Y_ref that of flat walking. A ZMP beyond the nominal one asks for less sway. Source: Kim,
/// Park, Oh 2006, reconstructed. Gentler than there (Ka 0.3) and forgetful, because a walk on uneven floor drifts with
/// it as specified.
struct SwayAmplitudeConfig {
  double gain = 0.05;             ///< Ka
  double zmp_per_sway = 2.0;      ///< 1 + l w^2 / g with l = 0.9 m and w = 3.3 rad/s
  double kept_share = 0.9;        ///< of the adaptation from step to step
  double band_m = 0.003;          ///< of the ZMP error, within which nothing is learned
  double pattern_sway_m = 0.06;   ///< amplitude of the pattern that this is added to
  double min_sway_m = 0.02;       ///< of the sum
  double max_sway_m = 0.07;       ///< of the sum, not below `min_sway_m`
  double time_constant_s = 0.02;  ///< of the low pass before the outermost place is taken
  double smoothing_s = 0.2;       ///< of the output
};

struct SwayAmplitudeState {
  bool has_sample = false;      ///< of this step
  double measured_zmp_m = 0.0;  ///< low-passed, outwards positive
  double nominal_zmp_m = 0.0;
  double outermost_measured_m = 0.0;
  double outermost_nominal_m = 0.0;
  double learned_m = 0.0;
  double added_sway_m = 0.0;  ///< output
};

/// One tick. Learns in the first tick of a step, if active; keeps what it has while inactive.
/// @return `sway_m`, such that the sum stays between its bounds
[[nodiscard]] Adjustment step(const SwayAmplitudeConfig&, SwayAmplitudeState&, const StabilizerInput&,
                              bool is_active) noexcept;

}  // namespace surefoot::stabilizer
