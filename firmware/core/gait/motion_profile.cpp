#include "firmware/core/gait/motion_profile.hpp"

#include <algorithm>

namespace surefoot::gait {

ScalarMotion ramp(double start, double end, double duration_s, double time_s) noexcept {
  if (time_s < 0.0) return {.position = start};
  if (time_s >= duration_s) return {.position = end};
  const double velocity = (end - start) / duration_s;
  return {.position = start + velocity * time_s, .velocity = velocity};
}

ScalarMotion quintic(const ScalarMotion& start, double end, double duration_s, double time_s) noexcept {
  if (time_s <= 0.0) return start;
  if (time_s >= duration_s) return {.position = end};
  // In u = t / T: what the parabola of the start leaves to be done in position, velocity, acceleration.
  const double velocity = start.velocity * duration_s;
  const double acceleration = start.acceleration * duration_s * duration_s;
  const double position_left = end - start.position - velocity - 0.5 * acceleration;
  const double velocity_left = -velocity - acceleration;
  const double c2 = 0.5 * acceleration;
  const double c3 = 10.0 * position_left - 4.0 * velocity_left - 0.5 * acceleration;
  const double c4 = -15.0 * position_left + 7.0 * velocity_left + acceleration;
  const double c5 = 6.0 * position_left - 3.0 * velocity_left - 0.5 * acceleration;
  const double u = time_s / duration_s;
  return {
      .position = start.position + u * (velocity + u * (c2 + u * (c3 + u * (c4 + u * c5)))),
      .velocity = (velocity + u * (2.0 * c2 + u * (3.0 * c3 + u * (4.0 * c4 + u * 5.0 * c5)))) / duration_s,
      .acceleration = (2.0 * c2 + u * (6.0 * c3 + u * (12.0 * c4 + u * 20.0 * c5))) / (duration_s * duration_s),
  };
}

ScalarMotion rest_to_rest(double u) noexcept {
  const double v = std::clamp(u, 0.0, 1.0);
  const double rest = v * (1.0 - v);
  return {
      .position = v * v * v * (10.0 + v * (-15.0 + 6.0 * v)),
      .velocity = 30.0 * rest * rest,
      .acceleration = 60.0 * rest * (1.0 - 2.0 * v),
  };
}

}  // namespace surefoot::gait
