#pragma once

#include <cstdint>

#include "firmware/core/foot_reference.hpp"
#include "firmware/core/gait/walk_parameters.hpp"
#include "firmware/core/joints.hpp"

namespace surefoot::gait {

/// Law for the duration of the restoring step.
enum class RestorationTiming : std::uint8_t {
  kAcosFactor,     ///< t_ss acos(f) / pi, eq. (3.24), as the thesis ran it
  kNominalCosine,  ///< t_ss acos(1 - 2 f) / pi, the time the nominal cosine needs for that distance
};

/// One step that brings the feet from any stance back to the nominal step length, about the reference.
/// Source: El-Kahlout 2003, eqs. (3.22)-(3.27), (3.29), (3.30) with the sign of S7 as in S6, (3.32), (3.33).
struct StepRestoration {
  Side swing = Side::kLeft;         ///< the front foot, left when the feet stand side by side
  double reference_x_body_m = 0.0;  ///< x_ref_as after the adaptation; midpoint of the feet
  double half_spread_m = 0.0;       ///< dif, (3.22)
  double factor = 0.0;              ///< f, (3.23): share of a nominal step that is left to do
  double single_support_s = 0.0;    ///< t_ss_a, (3.24); 0 when there is nothing to restore
  double double_support_s = 0.0;    ///< t_ds_a, (3.25); half before the swing, half after it

  /// t_ss_a + t_ds_a.
  [[nodiscard]] constexpr double duration_s() const noexcept { return single_support_s + double_support_s; }
  /// Phase of the nominal walk that begins with the feet as this step leaves them.
  [[nodiscard]] constexpr double resume_phase_s(const WalkParameters& walk) const noexcept {
    return swing == Side::kLeft ? walk.step_s() : 0.0;
  }
};

/// Decides once which foot swings and how long it takes. Below f = 1e-3 the step is skipped:
/// its duration is zero.
///
/// @param reference_x_m          x_ref_as, the midpoint of the feet
/// @param right_x_m, left_x_m    where the feet stand, body frame
[[nodiscard]] StepRestoration plan_restoration(const WalkParameters&, RestorationTiming, double reference_x_m,
                                               double right_x_m, double left_x_m) noexcept;

/// Foot paths of that step with analytic derivatives; stands before and after.
///
/// @param time_s  since the sway of the step began
[[nodiscard]] FootReference restoration_reference(const WalkParameters&, const StepRestoration&,
                                                  double time_s) noexcept;

}  // namespace surefoot::gait
