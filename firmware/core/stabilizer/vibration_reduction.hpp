#pragma once

#include "firmware/core/stabilizer/walk_view.hpp"

namespace surefoot::stabilizer {

/// Vibration reduction: damps the lateral swinging of the lifted leg on its flexible hip, m l^2 th'' = -k (th - u), by
/// u_v = -K th' with th' from the sole's accelerometer, a = l th'', through a leaky integral.
/// Source: Kim, Park, Oh 2007, section 3.2.6, eqs. (16) to (18); the block diagram is lost. The tilt's part of the
/// specific force is taken away by the inclinometer, and a high-pass filter keeps the sway of the walk out.
struct VibrationReductionConfig {
  double gain_s = 0.025;         ///< K; damping ratio about K / 2 sqrt(k / m l^2)
  double leak_rad_s = 10.0;      ///< epsilon of the integral
  double high_pass_rad_s = 6.0;  ///< of the acceleration; between the walk's 3.3 and the leg's 27 rad/s
  double leg_length_m = 0.57;    ///< l, hip to sole
  double max_angle_rad = 0.007;
  double max_rate_rad_s = 0.5;
  double fade_s = 0.05;
};

/// One leg.
struct SwayingLeg {
  double slow_m_s2 = 0.0;  ///< what the high-pass filter takes away
  double rate_rad_s = 0.0;
  double hip_roll_rad = 0.0;
  bool is_running = false;
};

struct VibrationReductionState {
  PerSide<SwayingLeg> leg;
};

/// Reads accelerometer and inclinometer of the moving foot. Gives its `hip_roll_rad`, in +-max_angle_rad, while it is
/// in the air.
[[nodiscard]] Adjustment step(const VibrationReductionConfig&, VibrationReductionState&, const StabilizerInput&,
                              bool is_active) noexcept;

}  // namespace surefoot::stabilizer
