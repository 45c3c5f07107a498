#pragma once

#include "firmware/core/foot_reference.hpp"
#include "firmware/core/gait/walk_parameters.hpp"
#include "firmware/core/geometry/robot_geometry.hpp"

namespace surefoot::decision {

/// The capture step. Every number is geometry or a load to design for; none is tuned to a cell of a table.
struct CaptureConfig {
  geometry::RobotGeometry geometry{};  ///< the robot's own; the controller copies it here
  double com_height_m = 0.57;          ///< z_c of the linear inverted pendulum, above the soles
  /// How far the load to design for moves the centre of mass: 25 kg at 0.20 m on 80 kg, 25 (0.20 + 0.035) / 105.
  /// What a load weighs cannot be told at the trigger: the forces still ring. A foot put too far forward costs
  /// little, for the other foot stays.
  double load_shift_m = 0.056;
  double tilt_back_rad_s = 0.03;          ///< a body that began to tip backwards as fast as this is loaded at its back
  double tilt_margin_rad_s = 0.1;         ///< `is_balance_lost`
  double max_step_m = 0.20;               ///< longest way of the swing foot against the body within the reflex
  double leg_use = 0.97;                  ///< share of the stretched leg that a step may use
  double shift_acceleration_m_s2 = 0.25;  ///< peak of the shift of the feet: moves the ZMP by 15 mm
  double max_lateral_shift_m = 0.06;      ///< bound on one lateral adaptation
};

/// What is known at the trigger.
struct CaptureState {
  FootReference feet{};             ///< references of the trigger tick, with velocities
  double com_x_body_m = 0.0;        ///< of the robot as it stood last: the standing ZMP
  double tilt_rate_rise_rad_s = 0;  ///< pitch rate of the body less its mean of the last tenth of a second
};

/// Where the feet come to rest, and why.
struct CaptureStep {
  double capture_point_x_body_m = 0.0;  ///< at touch-down, in the body frame of the trigger
  double step_m = 0.0;                  ///< how much farther forward than it was the swing foot is put, >= 0
  FootReference end{};                  ///< both feet down and w_of to either side, at rest
};

/// omega = sqrt(g / z_c) of the linear inverted pendulum.
[[nodiscard]] double pendulum_rate_per_s(const CaptureConfig&) noexcept;

/// Capture point (Pratt et al. 2006) after `time_s` with the pressure centre held as near to it as the standing
/// sole allows: xi(t) = p + (xi - p) exp(omega t), p = min(xi, toe). All on one axis, from the standing foot.
[[nodiscard]] double capture_point_after_m(const CaptureConfig&, double capture_point_m, double time_s) noexcept;

/// Plans the capture step.
///
/// xi = x_com + load shift + v / omega, v the speed of the body over the standing foot. At touch-down the middle of
/// the foremost sole shall be under xi or ahead of it, for there the margin is the same to either edge; if it is
/// not with the swing foot put down where it is, that foot goes there, as far as `max_step_m` and the leg allow.
/// A load at the back moves the other way: then nothing is added. With both feet down, both stay.
///
/// The standing foot is braked evenly: v T / 2 of way in the duration T. Feet cannot collide, for they end 2 w_of
/// apart. A centre of mass that is no number gives a step of length zero; the feet must be finite.
///
/// @param duration_s  until touch-down, > 0
[[nodiscard]] CaptureStep plan_capture(const gait::WalkParameters&, const CaptureConfig&, const CaptureState&,
                                       double duration_s) noexcept;

/// Duration of a shift by `distance_m` along a quintic whose acceleration peaks at the configured value,
/// sqrt(10 / sqrt(3) d / a), but no less than `least_s`.
[[nodiscard]] double gentle_shift_s(const CaptureConfig&, double distance_m, double least_s) noexcept;

}  // namespace surefoot::decision
