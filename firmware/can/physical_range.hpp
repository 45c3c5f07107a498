#pragma once

#include <algorithm>
#include <cmath>

namespace surefoot::can {

/// What a signal may carry: `[min|max]` of surefoot.dbc, narrower than what its raw bits could hold.
/// The generated code has these limits only inside predicates; a test holds both together.
struct PhysicalRange {
  double lowest = 0.0;
  double highest = 0.0;

  /// @return the nearest value inside the range; 0 for NaN
  [[nodiscard]] double clamp(double value) const noexcept {
    return std::isnan(value) ? 0.0 : std::clamp(value, lowest, highest);
  }
};

inline constexpr PhysicalRange kJointAngleRad{-3.2, 3.2};         ///< resolution 1e-6 rad
inline constexpr PhysicalRange kJointRateRadS{-30.0, 30.0};       ///< resolution 1e-3 rad/s
inline constexpr PhysicalRange kJointTorqueNm{-300.0, 300.0};     ///< resolution 0.01 N m
inline constexpr PhysicalRange kCornerForceN{-500.0, 3200.0};     ///< resolution 0.1 N
inline constexpr PhysicalRange kAngularRateRadS{-16.0, 16.0};     ///< resolution 5e-4 rad/s
inline constexpr PhysicalRange kSpecificForceMS2{-160.0, 160.0};  ///< 16 g, resolution 5e-3 m/s2
inline constexpr PhysicalRange kSoleTiltRad{-1.6, 1.6};           ///< resolution 5e-5 rad

}  // namespace surefoot::can
