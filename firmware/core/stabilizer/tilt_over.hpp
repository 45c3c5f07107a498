#pragma once

#include "firmware/core/stabilizer/gradual.hpp"

namespace surefoot::stabilizer {

/// Tilt-over prevention: when the torso's roll or its rate leaves the band of normal walking while one foot carries,
/// the stance ankle turns against it. Source: Kim, Park, Oh 2006, reconstructed; the band is about the nominal roll at
/// this place of the step.
struct TiltOverConfig {
  double gain = 1.0;          ///< ankle angle per roll beyond the band
  double rate_gain_s = 0.05;  ///< and per rate beyond its band
  double band_rad = 0.026;    ///< 1.5 degrees
  double rate_band_rad_s = 0.2;
  double max_angle_rad = 0.052;
  double smoothing_s = 0.03;  ///< of the output; it also fades over this time
};

struct TiltOverState {
  PerSide<double> added_roll_rad{};
};

/// One tick. Acts on the supporting foot.
/// @return ankle roll of both feet, each within `max_angle_rad`
[[nodiscard]] Adjustment step(const TiltOverConfig&, TiltOverState&, const StabilizerInput&, bool is_active) noexcept;

}  // namespace surefoot::stabilizer
