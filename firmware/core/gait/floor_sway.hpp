#pragma once

#include "firmware/core/gait/floor_walk.hpp"

/// The floor walk across its direction: how the pelvis goes from foot to foot.
namespace surefoot::gait {

/// w = sqrt(g / z_c) of the pendulum that carries the centre of mass.
[[nodiscard]] double natural_rate_rad_s(const FourFactorParameters&) noexcept;

/// Time in which the sway grows before the first lift.
[[nodiscard]] double shift_s(const WalkParameters&, const FourFactorParameters&) noexcept;

/// s^2 (3 - 2 s): 0 to 1 without velocity at either end.
/// @param share  held in [0, 1]
[[nodiscard]] double smooth(double share) noexcept;

/// The centre of mass' sway with these durations, of the profile pendulum and of planned walks.
[[nodiscard]] LateralPendulum lateral_pendulum(const WalkParameters&, const FourFactorParameters&) noexcept;

/// y of the pelvis over the middle of the feet, positive to the left: grown in and faded out.
/// @param added_m  to the amplitude
[[nodiscard]] double pelvis_sway_y_m(const WalkParameters&, const FourFactorParameters&, const FloorWalkState&,
                                     double added_m) noexcept;

}  // namespace surefoot::gait
