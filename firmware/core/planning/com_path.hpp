#pragma once

#include <cstdint>

#include "firmware/core/gait/motion_profile.hpp"
#include "firmware/core/planning/gait_factors.hpp"

namespace surefoot::planning {

/// How the centre of mass is carried through double support (Al-Shuka et al. 2014, section 2). In single support all
/// three are the same inverted pendulum over the ankle.
enum class ComMethod : std::uint8_t {
  kSharedPressure,        ///< 1: the pressure centre runs from ankle to ankle in proportion to the way, eqs. (5) to (9)
  kHangingPendulum,       ///< 2: a pendulum of its own length H_d, eqs. (10) to (15); the same path as method 1
  kMirroredAcceleration,  ///< 3: the acceleration of single support turned over and scaled in time
  kMirroredAsPrinted,     ///< 3 as eqs. (19) to (21) print it; closes only for T_d = T_s
};

/// The centre of mass in single support, seen from the ankle that carries, eq. (3).
/// @param time_s  since the foot was lifted, in [0, T_s]
[[nodiscard]] gait::ScalarMotion com_in_single_support(const GaitFactors&, double time_s) noexcept;

/// The same in double support, seen from the middle between the ankles.
/// @param time_s  since the foot landed, in [0, T_d]
[[nodiscard]] gait::ScalarMotion com_in_double_support(ComMethod, const GaitFactors&, double time_s) noexcept;

/// Pressure centre of a point mass at this height with this motion: x - (H / g) x'', eqs. (2), (5).
[[nodiscard]] double ideal_zmp_m(const GaitFactors&, const gait::ScalarMotion& com) noexcept;

/// Duration of double support with which method 3 ends where the next single support begins.
/// The others have `continuous_double_support_s`.
[[nodiscard]] double mirrored_double_support_s(const GaitFactors&) noexcept;

}  // namespace surefoot::planning
