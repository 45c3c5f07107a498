#pragma once

#include "firmware/core/controller.hpp"
#include "firmware/core/gait/stance.hpp"
#include "firmware/core/kinematics/leg_kinematics.hpp"

namespace surefoot::run {

/// Joint angles with the feet side by side, as the sequence begins.
[[nodiscard]] inline PerSide<LegVector> standing_pose(const ControllerConfig& firmware) noexcept {
  const gait::WalkParameters& walk = firmware.walk;
  return kinematics::inverse(firmware.geometry, gait::stance(walk, {walk.reference_x_body_m, walk.reference_x_body_m}))
      .angle_rad;
}

}  // namespace surefoot::run
