#pragma once

#include "firmware/core/stabilizer/gradual.hpp"

namespace surefoot::stabilizer {

/// Damping of the stance ankle: the body on its compliant ankle, m l^2 phi'' = m g l phi - K (phi - u), has a mode near
/// 1 Hz that nothing damps; the ankle moves against the rate of phi. phi is estimated as u + T / K (T: ankle moment)
/// and compared with flat walking; u is this controller's own command as the plant has it by now. Source: Kim, Park, Oh
/// 2006, in the reconstruction of its compliant-ankle model; u' = u - kd d/dt phi.
struct DampingConfig {
  double stiffness_nm_per_rad = 2450.0;  ///< K: servo, structure and sole, about one ankle
  double gain_s = 0.03;                  ///< kd; with an ideal estimate 2 zeta wn m l^2 / K = 0.12 s is half critical
  double time_constant_s = 0.05;         ///< of the low pass whose rate is taken
  double command_lag_s = 0.01;           ///< from a command to the moment that answers it, servo and sensor
  double smoothing_s = 0.02;             ///< of the output; it also fades over this time
  double max_angle_rad = 0.035;
};

struct DampingState {
  Side support = Side::kLeft;          ///< foot that the estimate belongs to
  bool is_estimating = false;          ///< the estimate is of a foot that carries
  AnkleAngles lagged_command;          ///< own command as it has reached the plant
  AnkleAngles filtered_lean;           ///< low pass of phi, left and backwards positive
  PerSide<AnkleAngles> added_angle{};  ///< outputs
};

/// One tick. Moves roll and pitch of the supporting foot's ankle; the other's fades.
/// @return ankle angles of both feet, each within `max_angle_rad`
[[nodiscard]] Adjustment step(const DampingConfig&, DampingState&, const StabilizerInput&, bool is_active) noexcept;

}  // namespace surefoot::stabilizer
