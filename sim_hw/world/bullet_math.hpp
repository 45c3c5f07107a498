#pragma once

#include <LinearMath/btMatrix3x3.h>
#include <LinearMath/btVector3.h>

#include <array>

#include "firmware/core/geometry/robot_geometry.hpp"

namespace surefoot::sim_hw {

// Bullet ships in float and in double; mixing the two links, runs and lies.
static_assert(sizeof(btScalar) == sizeof(double), "build against bullet-float64");

inline constexpr double kGravityM_S2 = 9.81;  ///< downwards

[[nodiscard]] inline btVector3 to_bullet(const geometry::Vector3& v) noexcept { return {v.x(), v.y(), v.z()}; }
[[nodiscard]] inline btVector3 to_bullet(const std::array<double, 3>& v) noexcept { return {v[0], v[1], v[2]}; }

[[nodiscard]] inline geometry::Vector3 from_bullet(const btVector3& v) noexcept { return {v.x(), v.y(), v.z()}; }
[[nodiscard]] inline geometry::Matrix3 from_bullet(const btMatrix3x3& m) noexcept {
  geometry::Matrix3 out;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) out(row, column) = m[row][column];
  }
  return out;
}

}  // namespace surefoot::sim_hw
