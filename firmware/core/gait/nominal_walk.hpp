#pragma once

#include "firmware/core/foot_reference.hpp"
#include "firmware/core/gait/walk_parameters.hpp"
#include "firmware/core/joints.hpp"

namespace surefoot::gait {

/// Nominal foot paths with their analytic velocities and accelerations.
/// Source: El-Kahlout 2003, eqs. (3.1)-(3.6); (3.6) with its phase origin at t_ds/2, without which
/// the left foot jumps by 18.34 mm at lift-off.
///
/// Position and velocity are continuous at all phase boundaries; acceleration jumps by 0.403 m/s2
/// in x and 0.302 m/s2 in z at lift-off and touch-down (cosines).
///
/// @param phase_s         time in the cycle; any finite value, taken modulo the cycle
/// @param reference_x_m   x_ref_as as adapted so far
[[nodiscard]] FootReference nominal_walk(const WalkParameters&, double phase_s, double reference_x_m) noexcept;

/// The same with the lateral sway faded in by a quintic over the first half double support after a
/// (re)start: without it the sway starts from rest at w pi / (t_ss + t_ds) = 0.17 m/s.
///
/// @param since_start_s   time since walking (re)started, >= 0
[[nodiscard]] FootReference nominal_walk_from_rest(const WalkParameters&, double phase_s, double reference_x_m,
                                                   double since_start_s) noexcept;

/// True where the phase has both feet on the ground.
[[nodiscard]] bool is_double_support(const WalkParameters&, double phase_s) noexcept;

/// Where a phase lies in its half of the cycle. The halves mirror each other: the left foot swings in
/// the first one while the body sways over the right foot, the right foot swings in the second one.
struct HalfCycle {
  Side swing = Side::kLeft;  ///< the foot that swings in this half; the other one stands
  double time_s = 0.0;       ///< since the half began, in [0, t_ss + t_ds)
};

/// @param phase_s  any finite value, taken modulo the cycle; a nanosecond early counts as the next half
[[nodiscard]] HalfCycle half_cycle(const WalkParameters&, double phase_s) noexcept;

}  // namespace surefoot::gait
