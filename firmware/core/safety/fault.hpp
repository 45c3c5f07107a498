#pragma once

#include <cstdint>

namespace surefoot::safety {

/// Numbered faults of the controller; the first one latches. Each has a paragraph in
/// firmware/FAULTS.md: cause, check, cure, safe state.
enum class Fault : std::uint8_t {
  kNone = 0,
  kSensorSilent = 1,       ///< a node, or its inertial sensors, did not answer for longer than the ride-through
  kTorqueNotFinite = 2,    ///< the servo asked for NaN or infinity
  kJointOutOfRange = 3,    ///< a measured joint angle stands outside its mechanical range
  kJointOverspeed = 4,     ///< a measured joint rate is beyond what the robot can do unharmed
  kBoardDamping = 5,       ///< a leg board damps although it is told to hold torques: they do not arrive
  kSecondMaster = 6,       ///< somebody else sends the controller's frames
  kLoopOverrun = 7,        ///< the host could not keep the tick's period: asked for from outside
  kSensorImplausible = 8,  ///< a sensor answers, but its values cannot be true
  kForeignVersion = 9,     ///< a node announced another protocol version while the loop ran
};

/// Name as it appears in logs, e.g. "sensor_silent".
[[nodiscard]] const char* name(Fault fault) noexcept;

}  // namespace surefoot::safety
