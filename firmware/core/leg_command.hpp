#pragma once

#include <cstdint>

#include "firmware/core/joints.hpp"

namespace surefoot {

/// What a leg board does with its motors; the `mode` of a torque frame.
enum class LegMode : std::uint8_t {
  kDamp = 0,    ///< torques ignored, joints damped; the safe state, and the state after power-up
  kTorque = 1,  ///< torques held until the next frame
};

/// One tick's command to one leg board.
struct LegCommand {
  LegMode mode = LegMode::kDamp;
  LegVector torque_nm{};
};

}  // namespace surefoot
