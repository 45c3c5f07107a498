#pragma once

#include "firmware/core/stabilizer/gradual.hpp"
#include "firmware/core/stabilizer/sole_edge.hpp"

namespace surefoot::stabilizer {

/// Foot-tilt feed-forward: the ankle of a foot that carries follows the inclination of its sole against gravity, so
/// that the shank stays upright on an uneven floor. Only what differs from the slope of the whole floor counts, the
/// slow mean of the soles that carry: to that the upright pose has the time to turn. Off while standing. Source: ours.
struct FootTiltConfig {
  double gain = 0.7;              ///< below 1, for a sole on soft ground follows its ankle
  double band_rad = 0.0;          ///< of the inclination, within which nothing moves
  double time_constant_s = 0.05;  ///< of the low pass; it also fades over this time
  double max_angle_rad = 0.07;
  double slope_time_constant_s = 2.0;  ///< of the floor's mean inclination
  EdgeLimits edge;                     ///< a foot on its edge tips: its inclination is not the floor's
};

struct FootTiltState {
  PerSide<AnkleAngles> added_angle{};
  AnkleAngles slope{};  ///< mean inclination of the soles that carry
};

/// One tick.
/// @return ankle angles of both feet, each within `max_angle_rad`
[[nodiscard]] Adjustment step(const FootTiltConfig&, FootTiltState&, const StabilizerInput&, bool is_active) noexcept;

}  // namespace surefoot::stabilizer
