#pragma once

#include <vector>

#include "tools/floor/criteria_walk.hpp"

/// What the controllers of Kim, Park, Oh 2007 regulate, as figures of a walk: one sample a walk, or one a landing or
/// step. No sample where the walk ended too early.
namespace surefoot::floor {

using Samples = std::vector<double>;

// Standing on a slope across: means of half a second, which ends 15 s after power-up.

/// Half the difference of the legs' lengths as commanded, right longer positive, mm.
[[nodiscard]] Samples commanded_leg_correction_mm(const ObservedWalk&);
/// Mean of both ankles' roll as commanded, degrees.
[[nodiscard]] Samples commanded_ankle_roll_deg(const ObservedWalk&);
/// The same two as the joints really have them.
[[nodiscard]] Samples true_leg_correction_mm(const ObservedWalk&);
[[nodiscard]] Samples true_ankle_roll_deg(const ObservedWalk&);
/// Magnitude of the torso's true roll against the vertical, degrees.
[[nodiscard]] Samples torso_lean_deg(const ObservedWalk&);

// Of each landing.

/// Largest true force on the foot from its contact to the planned end of the lowering, N; early landings alone, up to
/// the absorber's `latest_share`.
[[nodiscard]] Samples early_landing_peak_n(const ObservedWalk&);
/// Time between the contact and the end of the lowering, ms, either way.
[[nodiscard]] Samples landing_error_ms(const ObservedWalk&);
/// 100 where the next step begins before the foot carries, else 0.
[[nodiscard]] Samples landed_late_percent(const ObservedWalk&);
/// How far the momentum about the landing foot is from what is desired of it (eq. 10) when landing momentum must have
/// ended, N m s: 0.1 s after the contact, or when the other foot is lifted. Landings within its range do not count.
[[nodiscard]] Samples landed_momentum_error_nms(const ObservedWalk&);
/// How far from d_final of eq. (15) the foot lands, outward, mm, with what the hip gyro tells when the point settles.
[[nodiscard]] Samples landing_position_error_mm(const ObservedWalk&);
/// Largest moment of the floor on the foot, about its ankle's two axes, from the contact to the next lift, N m.
[[nodiscard]] Samples landing_moment_peak_nm(const ObservedWalk&);

// Of the swing leg on a flexible hip.

/// What is left after 1 s of the first peak of the hip joint's rate, percent: largest magnitudes within 0.23 s from the
/// lift on and 1 s later, of the first lift. Twice a mean over the leg's period of 0.23 s is taken away, which leaves
/// out the body's slower swing on its ankle; the figure is up to a fifth too large, for the means begin before the
/// lift.
[[nodiscard]] Samples vibration_left_percent(const ObservedWalk&);

// Of the body.

/// Root mean square of the supporting foot's ZMP against flat walking, both axes, single supports, mm.
[[nodiscard]] Samples zmp_error_mm(const ObservedWalk&);
/// Of each step of the walk's second half: the outermost ZMP against flat walking's, mm, either way; in the middle half
/// of the swing.
[[nodiscard]] Samples zmp_peak_error_mm(const ObservedWalk&);
/// Magnitude of the torso's mean true roll and pitch over the last two gait cycles, degrees.
[[nodiscard]] Samples mean_tilt_deg(const ObservedWalk&);
/// Root mean square of the torso's roll rate against flat walking over 2 s from the push on, degrees per second.
[[nodiscard]] Samples rate_after_push_deg_s(const ObservedWalk&);
/// Largest roll of the torso against flat walking over 2 s from the push on, degrees.
[[nodiscard]] Samples roll_after_push_deg(const ObservedWalk&);

}  // namespace surefoot::floor
