#pragma once

#include "firmware/core/decision/reflex_config.hpp"
#include "firmware/core/foot_reference.hpp"
#include "firmware/core/gait/walk_parameters.hpp"

namespace surefoot::decision {

/// x_refl of each foot: how far the reflex moves it from where it is at the trigger.
/// Source: El-Kahlout 2003, eq. (3.17) (right back, left forward), mirrored if so configured in the half
/// of the cycle in which the right foot swings; or eqs. (4.5)(4.6): the standing foot forward against
/// the body, the foot in the air back, nothing in double support.
///
/// @param at_trigger     references of the trigger tick
/// @param walk_phase_s   phase of the walk at the trigger
[[nodiscard]] PerSide<double> reflex_offset_x_m(const gait::WalkParameters&, const ReflexConfig&,
                                                const FootReference& at_trigger, double walk_phase_s) noexcept;

}  // namespace surefoot::decision
