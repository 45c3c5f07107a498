#pragma once

#include <cstdint>

#include "firmware/core/safety/fault.hpp"

namespace surefoot::safety {

/// How the robot is made safe after a fault. In order: a later one takes less on trust, and a robot goes
/// only that way until the firmware is started anew.
enum class SafeState : std::uint8_t {
  kNone,        ///< no fault: the robot does its job
  kStanceHold,  ///< both legs can be trusted and commanded: both feet down, and it stands there under servo control
  kDamp,        ///< a leg cannot: both boards damp their joints, which lowers the robot
};

/// A fault and what it asks for.
struct Finding {
  Fault fault = Fault::kNone;
  SafeState needs = SafeState::kNone;
};

/// Two findings as one: the first fault keeps its number, the worse state wins. So are the findings of one
/// tick put together, in the order of cause and consequence, and so is a tick's finding latched.
[[nodiscard]] Finding followed_by(Finding first, Finding next) noexcept;

/// What a fault that concerns no single node asks for: kStanceHold while the legs still obey (second
/// master, loop overrun), kDamp otherwise.
[[nodiscard]] Finding finding_of(Fault fault) noexcept;

/// What a fault of one node asks for: kDamp for a leg board, kStanceHold for a foot or the torso IMU.
[[nodiscard]] Finding finding_of_node(Fault fault, bool is_leg_board) noexcept;

/// Name as it appears in logs: "none", "stance_hold", "damp".
[[nodiscard]] const char* name(SafeState state) noexcept;

}  // namespace surefoot::safety
