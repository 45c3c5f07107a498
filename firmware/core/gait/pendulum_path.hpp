#pragma once

namespace surefoot::gait {

/// Position and velocity along one axis.
struct PathPoint {
  double position_m = 0.0;
  double velocity_m_s = 0.0;
};

/// Path of a linear inverted pendulum whose pressure centre moves at constant speed: the one path that joins two points
/// with their velocities in a given time and is such a pendulum's. In the steady walk its pressure centre rests under
/// the foot, x = d sinh(w (t - T/2)) / (2 sinh(w T / 2)).
///
/// x'' = w^2 (x - p), p = p0 + p1 t, so x = p0 + p1 t + a cosh(w t) + b sinh(w t).
class PendulumPath {
 public:
  PendulumPath() = default;

  /// @param natural_rate_rad_s  w = sqrt(g / z_c), > 0
  /// @param duration_s          > 0
  PendulumPath(const PathPoint& begin, const PathPoint& end, double duration_s, double natural_rate_rad_s) noexcept;

  /// @param time_s  in [0, duration]
  [[nodiscard]] PathPoint at(double time_s) const noexcept;

  /// Where the pressure centre is then.
  [[nodiscard]] double pressure_centre_m(double time_s) const noexcept;

 private:
  double natural_rate_rad_s_ = 1.0;
  double centre_m_ = 0.0;         ///< p0
  double centre_rate_m_s_ = 0.0;  ///< p1
  double cosh_m_ = 0.0;           ///< a
  double sinh_m_ = 0.0;           ///< b
};

}  // namespace surefoot::gait
