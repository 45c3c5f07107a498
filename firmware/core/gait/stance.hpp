#pragma once

#include "firmware/core/foot_reference.hpp"
#include "firmware/core/gait/walk_parameters.hpp"

namespace surefoot::gait {

/// How high a foot must be to count as in the air (the thesis compares with ==).
inline constexpr double kAirborneTolerance_m = 1.0e-6;

/// Both feet on the floor, w_of to either side of the midline, at rest.
[[nodiscard]] FootReference stance(const WalkParameters&, const PerSide<double>& x_body_m) noexcept;

/// Where the reflex ends: x_s + x_refl, both feet down and w_of to either side.
/// Source: El-Kahlout 2003, eqs. (3.11)-(3.16), with (3.15)(3.16) started from the feet's own heights.
///
/// @param at_trigger    references of the trigger tick
/// @param offset_x_m    x_refl of each foot
[[nodiscard]] FootReference reflex_stance(const WalkParameters&, const FootReference& at_trigger,
                                          const PerSide<double>& offset_x_m) noexcept;

/// True while the reference lifts this foot off the floor.
[[nodiscard]] bool is_airborne(const WalkParameters&, const FootPath&) noexcept;

}  // namespace surefoot::gait
