#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "firmware/core/gait/motion_profile.hpp"

namespace surefoot::planning {

inline constexpr std::size_t kMostPieces = 3;
inline constexpr std::size_t kMostCoefficients = 5;  ///< of a piece: up to the fourth degree

/// That a derivative of the path has a value at a knot. Derivative 0 is the position.
struct SplineCondition {
  std::size_t knot = 0;
  int derivative = 0;  ///< 0 to 2
  double value = 0.0;
};

/// One to three polynomials that join without a step in position, velocity or acceleration.
class Spline {
 public:
  Spline() = default;

  /// Solves for the coefficients. Cost: one solution of at most 15 linear equations.
  ///
  /// @param knots_s     begin, joints and end, ascending; one more than pieces
  /// @param degrees     of the pieces, 1 to 4
  /// @param conditions  as many as there are coefficients left once the pieces join: sum (degree + 1) - 3 (pieces - 1)
  Spline(std::span<const double> knots_s, std::span<const int> degrees,
         std::span<const SplineCondition> conditions) noexcept;

  /// Whether the knots ascend, the conditions are as many as needed, and they determine the path. If not it rests at 0.
  [[nodiscard]] bool is_determined() const noexcept { return pieces_ > 0; }

  /// @param time_s  held between the first knot and the last
  [[nodiscard]] gait::ScalarMotion at(double time_s) const noexcept;

 private:
  std::size_t pieces_ = 0;
  std::array<double, kMostPieces + 1> knot_s_{};
  std::array<std::array<double, kMostCoefficients>, kMostPieces> coefficient_{};  ///< of powers of the piece's share
};

}  // namespace surefoot::planning
