#pragma once

#include <cstdint>

namespace surefoot::gait {

/// How a foot moves from one point to another.
enum class MotionProfile : std::uint8_t {
  kRamp,     ///< straight line, eqs. (3.11)-(3.16), (3.21); velocity jumps at both ends; as the tables were made
  kQuintic,  ///< same duration, starts with the gait's position, velocity and acceleration, ends at rest
};

/// One coordinate and its first two derivatives with respect to time.
struct ScalarMotion {
  double position = 0.0;
  double velocity = 0.0;
  double acceleration = 0.0;
};

/// Straight line from `start` to `end`; constant velocity inside, at rest before and after.
///
/// @param duration_s  > 0
/// @param time_s      since the start; the velocity holds on 0 <= time_s < duration_s
[[nodiscard]] ScalarMotion ramp(double start, double end, double duration_s, double time_s) noexcept;

/// Fifth-degree polynomial from `start` (position, velocity, acceleration) to rest at `end`.
///
/// @param duration_s  > 0
/// @param time_s      since the start; `start` holds before, `end` at rest after
[[nodiscard]] ScalarMotion quintic(const ScalarMotion& start, double end, double duration_s, double time_s) noexcept;

/// s(u) = u^3 (10 - 15 u + 6 u^2) with its derivatives by u: from 0 to 1, at rest at both ends.
///
/// @param u  held in [0, 1]
[[nodiscard]] ScalarMotion rest_to_rest(double u) noexcept;

}  // namespace surefoot::gait
