#pragma once

#include "firmware/core/stabilizer/walk_view.hpp"

namespace surefoot::stabilizer {

/// Upright pose: turns both ankles and changes both leg lengths until the torso is upright on an inclined floor.
/// Source: Kim, Park, Oh 2007, section 3.2.1, eqs. (8), (9). The gains are ours: with the error seen through the filter
/// the loop is filter_s s^2 + (1 + kp) s + ki, aperiodic up to ki = (1 + kp)^2 / (4 filter_s).
struct UprightPoseConfig {
  double kp = 0.8;
  double ki_per_s = 0.26;
  double filter_s = 3.0;         ///< low-pass filter of the torso's inclination
  double hip_spacing_m = 0.142;  ///< between the legs
  double max_angle_rad = 0.15;   ///< of the floor that it makes up for, each axis
  double fade_s = 0.5;
};

/// One axis of the loop.
struct UprightPoseAxis {
  double error_rad = 0.0;     ///< filtered inclination against flat walking
  double integral_rad = 0.0;  ///< of ki times the error
  double angle_rad = 0.0;     ///< inclination of the floor as the loop has it; kp error + integral
};

struct UprightPoseState {
  UprightPoseAxis roll;
  UprightPoseAxis pitch;
};

/// Reads the torso's roll and pitch. Gives leg lengths (the leg on the low side becomes longer) and ankle angles of
/// both legs, each in +-max_angle_rad.
[[nodiscard]] Adjustment step(const UprightPoseConfig&, UprightPoseState&, const StabilizerInput&,
                              bool is_active) noexcept;

}  // namespace surefoot::stabilizer
