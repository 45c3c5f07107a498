#pragma once

#include <cmath>

#include "firmware/core/geometry/robot_geometry.hpp"

namespace surefoot::kinematics {

/// An angle as its cosine and sine.
struct Turn {
  double cos = 1.0;
  double sin = 0.0;

  [[nodiscard]] static Turn of(double angle_rad) noexcept { return {std::cos(angle_rad), std::sin(angle_rad)}; }
  /// Direction of (cos, sin) times any length; zero length gives the zero angle.
  [[nodiscard]] static Turn along(double cos, double sin) noexcept {
    const double length = std::sqrt(cos * cos + sin * sin);
    return length == 0.0 ? Turn{} : Turn{cos / length, sin / length};  // NaN stays NaN
  }
  [[nodiscard]] double angle_rad() const noexcept { return std::atan2(sin, cos); }
  [[nodiscard]] Turn reversed() const noexcept { return {cos, -sin}; }
  /// Both turns about the same axis.
  [[nodiscard]] Turn then(const Turn& b) const noexcept {
    return {cos * b.cos - sin * b.sin, sin * b.cos + cos * b.sin};
  }
};

/// `v` turned right-handed about x.
[[nodiscard]] inline geometry::Vector3 about_x(const Turn& t, const geometry::Vector3& v) noexcept {
  return {v.x(), t.cos * v.y() - t.sin * v.z(), t.sin * v.y() + t.cos * v.z()};
}

/// `v` turned right-handed about y.
[[nodiscard]] inline geometry::Vector3 about_y(const Turn& t, const geometry::Vector3& v) noexcept {
  return {t.cos * v.x() + t.sin * v.z(), v.y(), t.cos * v.z() - t.sin * v.x()};
}

/// `v` turned right-handed about z.
[[nodiscard]] inline geometry::Vector3 about_z(const Turn& t, const geometry::Vector3& v) noexcept {
  return {t.cos * v.x() - t.sin * v.y(), t.sin * v.x() + t.cos * v.y(), v.z()};
}

}  // namespace surefoot::kinematics
