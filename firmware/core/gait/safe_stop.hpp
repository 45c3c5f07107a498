#pragma once

#include "firmware/core/gait/motion_plan.hpp"
#include "firmware/core/gait/motion_profile.hpp"
#include "firmware/core/gait/walk_parameters.hpp"

namespace surefoot::gait {

/// How the robot stops after a fault that leaves it its legs.
struct SafeStopConfig {
  MotionProfile profile = MotionProfile::kQuintic;  ///< the joints' references keep their velocity
  double duration_s = 0.2;  ///< > 0; 0.1 to 0.5 stay up alike, longer ones lose a robot that a load topples
};

/// Both feet down where they are, side to side as in standing, and there they stay for good: the reflex'
/// stance (El-Kahlout 2003, eqs. (3.11)-(3.16)) without its step forward.
///
/// @param now  the references of this tick; the move starts with their position and, by the quintic
///             profile, velocity and acceleration
[[nodiscard]] MotionPlan safe_stop(const WalkParameters&, const SafeStopConfig&, const FootReference& now) noexcept;

}  // namespace surefoot::gait
