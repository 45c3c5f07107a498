#pragma once

#include "firmware/core/controller.hpp"

namespace surefoot::run {

/// Joint angles with the feet side by side, as the sequence begins.
[[nodiscard]] inline PerSide<LegVector> standing_pose(const ControllerConfig& firmware) noexcept {
  return standing_reference(firmware).angle_rad;
}

}  // namespace surefoot::run
