#pragma once

#include <cstdint>

#include "firmware/core/joints.hpp"

namespace surefoot {

/// What a leg board does with its motors.
enum class LegMode : std::uint8_t {
  kDamp = 0,      ///< torques ignored, joints damped; the safe state, and the state after power-up
  kTorque = 1,    ///< torques held until the next frame
  kPosition = 2,  ///< the board's own servo brings the joints to the angles within a control period and holds them
};

/// One tick's command to one leg board.
struct LegCommand {
  LegMode mode = LegMode::kDamp;
  LegVector torque_nm{};  ///< of `kTorque`
  LegVector angle_rad{};  ///< of `kPosition`
};

/// What the rooms above the output gate want of both legs; one mode for the whole robot.
struct WantedMotion {
  LegMode mode = LegMode::kTorque;
  PerSide<LegVector> torque_nm{};  ///< of `kTorque`
  PerSide<LegVector> angle_rad{};  ///< of `kPosition`
};

}  // namespace surefoot
