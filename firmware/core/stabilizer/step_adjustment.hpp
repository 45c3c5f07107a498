#pragma once

#include "firmware/core/stabilizer/landing_shift.hpp"

namespace surefoot::stabilizer {

/// Step adjustment: the landing point of the swing foot follows the deviation of the divergent component of motion
/// (capture point; Pratt et al. 2006, Englsberger et al. 2015) from flat walking, xi = x + x' / omega,
/// omega = sqrt(g / z_c), with x = z_c times the torso's deviation in angle. It grows with exp(omega t) until the
/// landing; `horizon_s` bounds how far ahead that is believed.
struct StepAdjustmentConfig {
  double com_height_m = 0.67;  ///< z_c above the soles
  double gain = 1.0;           ///< shift per deviation at landing
  double horizon_s = 0.15;
  double band_m = 0.015;  ///< of the deviation at landing, within which the foot lands where the pattern has it
  double max_shift_x_m = 0.08;
  double max_outward_m = 0.05;
  double max_inward_m = 0.0;  ///< towards the other foot; the soles of KHR-2 pass 2 mm apart
  double freeze_s = 0.05;     ///< before the landing, from where the point stays
  double smoothing_s = 0.03;  ///< of the output; it also fades over this time
};

struct StepAdjustmentState {
  LandingShift shift;
};

/// One tick. The shift stays through the double support, where the foot stands on it, and fades once inactive.
/// @return `landing_x_m` and `landing_y_m` within their limits
[[nodiscard]] Adjustment step(const StepAdjustmentConfig&, StepAdjustmentState&, const StabilizerInput&,
                              bool is_active) noexcept;

}  // namespace surefoot::stabilizer
