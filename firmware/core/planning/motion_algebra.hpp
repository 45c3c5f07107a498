#pragma once

#include <cmath>

#include "firmware/core/gait/motion_profile.hpp"

/// Arithmetic of quantities that move: each result carries its exact first and second derivative with respect to time.
namespace surefoot::planning {

using gait::ScalarMotion;

[[nodiscard]] inline ScalarMotion operator+(const ScalarMotion& a, const ScalarMotion& b) noexcept {
  return {a.position + b.position, a.velocity + b.velocity, a.acceleration + b.acceleration};
}

[[nodiscard]] inline ScalarMotion operator-(const ScalarMotion& a, const ScalarMotion& b) noexcept {
  return {a.position - b.position, a.velocity - b.velocity, a.acceleration - b.acceleration};
}

[[nodiscard]] inline ScalarMotion operator*(const ScalarMotion& a, const ScalarMotion& b) noexcept {
  return {a.position * b.position, a.velocity * b.position + a.position * b.velocity,
          a.acceleration * b.position + 2.0 * a.velocity * b.velocity + a.position * b.acceleration};
}

[[nodiscard]] inline ScalarMotion operator*(double factor, const ScalarMotion& a) noexcept {
  return {factor * a.position, factor * a.velocity, factor * a.acceleration};
}

[[nodiscard]] constexpr ScalarMotion resting(double value) noexcept { return {value, 0.0, 0.0}; }

/// f(a), of which the value and the first two derivatives by a are known.
[[nodiscard]] inline ScalarMotion chained(const ScalarMotion& a, double value, double first, double second) noexcept {
  return {value, first * a.velocity, first * a.acceleration + second * a.velocity * a.velocity};
}

/// @param a  above 0
[[nodiscard]] inline ScalarMotion square_root(const ScalarMotion& a) noexcept {
  const double root = std::sqrt(a.position);
  return chained(a, root, 0.5 / root, -0.25 / (root * a.position));
}

/// @param a  not 0
[[nodiscard]] inline ScalarMotion inverse(const ScalarMotion& a) noexcept {
  const double value = 1.0 / a.position;
  return chained(a, value, -value * value, 2.0 * value * value * value);
}

[[nodiscard]] inline ScalarMotion sine(const ScalarMotion& a) noexcept {
  return chained(a, std::sin(a.position), std::cos(a.position), -std::sin(a.position));
}

[[nodiscard]] inline ScalarMotion cosine(const ScalarMotion& a) noexcept {
  return chained(a, std::cos(a.position), -std::sin(a.position), -std::cos(a.position));
}

/// Angle of the direction (x, z) from z toward x, as a pitch that is positive forward.
/// @param x, z  not both 0
[[nodiscard]] inline ScalarMotion pitch_of(const ScalarMotion& x, const ScalarMotion& z) noexcept {
  const ScalarMotion per_square = inverse(x * x + z * z);
  const ScalarMotion rate{(x.velocity * z.position - x.position * z.velocity) * per_square.position,
                          (x.acceleration * z.position - x.position * z.acceleration) * per_square.position +
                              (x.velocity * z.position - x.position * z.velocity) * per_square.velocity,
                          0.0};
  return {std::atan2(x.position, z.position), rate.position, rate.velocity};
}

}  // namespace surefoot::planning
