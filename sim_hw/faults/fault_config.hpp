#pragma once

#include <cstddef>
#include <cstdint>

namespace surefoot::sim_hw {

/// Most faults that one run takes.
inline constexpr std::size_t kMaxFaults = 16;

/// What goes wrong. A "frame of" a node is one that it sends, or a command frame addressed to it; every frame
/// that comes from outside is one of the controller's; every frame is one of the bus. `value` has the meaning
/// given here, and none where it is not mentioned.
enum class FaultKind : std::uint8_t {
  kDrop,       ///< frames of the target are lost
  kDuplicate,  ///< frames of the target arrive 1 + `value` times
  kDelay,      ///< frames of the target arrive `value` ticks later, before those of that tick
  kCorrupt,    ///< frames of the target arrive with `value` bits of payload or identifier flipped, or, one in
               ///< eight, with another length; it is the receivers' CRC that has to notice
  kSwap,       ///< frames of the target and of its twin on the other side change identifiers. `value` 0: nothing
               ///< else, and the CRC does not fit; 1: the CRC fits, as if the boards' plugs were exchanged
  kStuck,      ///< the sensor repeats what it measured first in the fault's time
  kDrift,      ///< the sensor is off by `value` for each second of the fault, in its own unit
  kNoise,      ///< normal noise of standard deviation `value`, in the sensor's unit
  kSaturate,   ///< the sensor measures at most `value` and at least -`value`, in its own unit
  kDeadNode,   ///< the node has no power, to the end of the run: silent and deaf, motors limp (no torque)
  kRestart,    ///< as `kDeadNode`, then it boots: heartbeat boot-up, counters from 0, damping until a new command
  kBabble,     ///< the node sends `value` intact emergencies ("error reset") a tick besides its frames
  kBusOff,     ///< the node is silent and deaf, but runs on (its watchdog too); it returns without a boot-up
  kLinkDown,   ///< nothing passes, in neither direction
};
inline constexpr std::size_t kFaultKinds = 14;

/// What it goes wrong at.
enum class FaultTarget : std::uint8_t { kLegRight, kLegLeft, kFootRight, kFootLeft, kTorso, kController, kBus };

/// Which measurements of the target: those of its own kind of node, or all of them.
enum class FaultSignal : std::uint8_t {
  kAll,
  kAngle,          ///< leg, rad
  kRate,           ///< leg, rad/s
  kTorque,         ///< leg, N m, as measured by the board
  kForce,          ///< foot, N
  kGyro,           ///< torso, rad/s
  kAccelerometer,  ///< torso, m/s2
  // Of robots with inertial legs.
  kHipGyro,            ///< leg, rad/s
  kInclinometer,       ///< foot, rad
  kFootAccelerometer,  ///< foot, m/s2
};

/// Which of the six joints, four corners or three axes; the signals of inertial legs have no elements.
enum class FaultElement : std::uint8_t {
  kAll,
  kHipYaw,
  kHipRoll,
  kHipPitch,
  kKneePitch,
  kAnklePitch,
  kAnkleRoll,
  kFrontLeft,
  kFrontRight,
  kRearLeft,
  kRearRight,
  kX,
  kY,
  kZ,
};

/// One fault: from `at_s` on for `for_s`, on the scenario's clock. It begins and ends with a control tick.
///
/// Its random numbers depend on the seed, on the fault itself, and on the frame or measurement that it meets,
/// and on nothing else: another fault beside it changes none of them.
struct FaultConfig {
  FaultKind kind = FaultKind::kDrop;
  FaultTarget target = FaultTarget::kBus;
  FaultSignal signal = FaultSignal::kAll;     ///< of sensor faults; `kAll` otherwise
  FaultElement element = FaultElement::kAll;  ///< of sensor faults; `kAll` otherwise
  double at_s = 1.0;                          ///< negative: before the first gait cycle
  double for_s = 1.0;                         ///< no meaning for `kDeadNode`
  double probability = 1.0;                   ///< of each frame; 1 for faults that are not of frames
  double value = 1.0;                         ///< see `FaultKind`
};

/// The kinds whose `probability` counts: they happen to single frames.
[[nodiscard]] constexpr bool is_frame_fault(FaultKind kind) noexcept { return kind <= FaultKind::kSwap; }

[[nodiscard]] constexpr bool is_of_inertial_legs(FaultSignal signal) noexcept {
  return signal >= FaultSignal::kHipGyro;
}

/// The kinds that change what a sensor measures.
[[nodiscard]] constexpr bool is_sensor_fault(FaultKind kind) noexcept {
  return kind >= FaultKind::kStuck && kind <= FaultKind::kSaturate;
}

}  // namespace surefoot::sim_hw
