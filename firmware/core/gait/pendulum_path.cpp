#include "firmware/core/gait/pendulum_path.hpp"

#include <cmath>

namespace surefoot::gait {

PendulumPath::PendulumPath(const PathPoint& begin, const PathPoint& end, double duration_s,
                           double natural_rate_rad_s) noexcept
    : natural_rate_rad_s_(natural_rate_rad_s) {
  // With a = x0 - p0 and b = (v0 - p1) / w the end gives two equations in p0 and p1:
  //   (1 - C) p0 + (T - S / w) p1 = x1 - x0 C - v0 S / w
  //   -w S p0    + (1 - C) p1     = v1 - x0 w S - v0 C
  const double w = natural_rate_rad_s;
  const double cosh = std::cosh(w * duration_s);
  const double sinh = std::sinh(w * duration_s);
  const double r1 = end.position_m - begin.position_m * cosh - begin.velocity_m_s * sinh / w;
  const double r2 = end.velocity_m_s - begin.position_m * w * sinh - begin.velocity_m_s * cosh;
  const double one_one = 1.0 - cosh;
  const double one_two = duration_s - sinh / w;
  const double two_one = -w * sinh;
  const double determinant = one_one * one_one - one_two * two_one;  // 2 - 2 C + w T S > 0
  centre_m_ = (r1 * one_one - one_two * r2) / determinant;
  centre_rate_m_s_ = (one_one * r2 - two_one * r1) / determinant;
  cosh_m_ = begin.position_m - centre_m_;
  sinh_m_ = (begin.velocity_m_s - centre_rate_m_s_) / w;
}

PathPoint PendulumPath::at(double time_s) const noexcept {
  const double w = natural_rate_rad_s_;
  const double cosh = std::cosh(w * time_s);
  const double sinh = std::sinh(w * time_s);
  return {pressure_centre_m(time_s) + cosh_m_ * cosh + sinh_m_ * sinh,
          centre_rate_m_s_ + w * (cosh_m_ * sinh + sinh_m_ * cosh)};
}

double PendulumPath::pressure_centre_m(double time_s) const noexcept { return centre_m_ + centre_rate_m_s_ * time_s; }

}  // namespace surefoot::gait
