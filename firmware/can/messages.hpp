#pragma once

#include <cstddef>
#include <cstdint>

#include "firmware/can/can_frame.hpp"
#include "firmware/can/identifiers.hpp"
#include "firmware/core/leg_command.hpp"
#include "firmware/core/sensor_snapshot.hpp"

namespace surefoot::can {

/// Why a frame was refused; each cause has a counter in `FrameCounters`.
enum class Rejection : std::uint8_t {
  kNone,
  kUnknownIdentifier,  ///< none of this kind of frame, or one that only the receiver itself may send
  kWrongLength,
  kWrongCrc,
  kRepeated,        ///< rolling counter did not move: a duplicate or a replay
  kLate,            ///< answers another tick than the one that runs
  kImplausible,     ///< a decoded value is outside its physical range
  kForeignVersion,  ///< a heartbeat of another protocol version, or a state frame of a node that announced one
};

/// Size of an array indexed by `Rejection`.
inline constexpr std::size_t kRejectionCauses = 8;

/// What every protected frame carries beside its values.
struct FrameStamp {
  std::uint32_t tick = 0;    ///< SYNC and its lockstep marker: 32 bits; other frames carry the low 16 bits
  std::uint8_t counter = 0;  ///< rolling, one up for each frame of this identifier
};

/// Status bits of a leg board.
struct LegStatus {
  bool watchdog_expired = false;  ///< no command frame in time: joints are damped
  bool torque_limited = false;    ///< at least one motor is at its limit
  bool is_damping = false;
};

/// NMT states of CiA 301, the first byte of a heartbeat.
enum class NodeState : std::uint8_t { kBootUp = 0x00, kStopped = 0x04, kOperational = 0x05, kPreOperational = 0x7F };

/// Version of surefoot.dbc, in every heartbeat. A heartbeat with another version is refused and counted, and so
/// are the state frames of its sender until it announces the right one.
inline constexpr std::uint8_t kProtocolVersion = 1;

struct Heartbeat {
  NodeState state = NodeState::kBootUp;
  std::uint8_t protocol_version = kProtocolVersion;
  bool has_inertial_sensors = false;  ///< a leg or foot that answers SYNC with its inertial frame too
};

/// CiA 301 emergency: code and error register.
struct Emergency {
  std::uint16_t code = 0;  ///< 0x8130 watchdog, 0x8150 two masters, 0x0000 error reset
  std::uint8_t error_register = 0;
};

/// Encoders: values outside the frame's physical range are clamped to it, NaN becomes zero (the
/// generated C code checks nothing). Each returns a frame with counter and CRC filled in.
/// Cost: about 0.1 us for the largest frame. None allocates.
[[nodiscard]] CanFrame encode_sync(FrameStamp) noexcept;
/// The frame that carries this command: LEG_POSITION for `kPosition`, LEG_COMMAND for the other modes. Each of the
/// two identifiers has a rolling counter of its own.
[[nodiscard]] CanFrame encode_leg_command(Side, FrameStamp, const LegCommand&) noexcept;
[[nodiscard]] CanFrame encode_leg_state(Side, FrameStamp, const LegSensors&, LegStatus) noexcept;
[[nodiscard]] CanFrame encode_foot_force(Side, FrameStamp, const FootSensors&) noexcept;
[[nodiscard]] CanFrame encode_imu(FrameStamp, const ImuSensors&) noexcept;
[[nodiscard]] CanFrame encode_leg_inertial(Side, FrameStamp, const LegInertialSensors&) noexcept;
[[nodiscard]] CanFrame encode_foot_inertial(Side, FrameStamp, const FootInertialSensors&) noexcept;
[[nodiscard]] CanFrame encode_heartbeat(Node, FrameStamp, Heartbeat) noexcept;
[[nodiscard]] CanFrame encode_emergency(Node, FrameStamp, Emergency) noexcept;
[[nodiscard]] CanFrame encode_lockstep_served(FrameStamp) noexcept;

/// Decoders: check identifier, length, CRC and physical ranges, in this order; on a rejection the outputs are
/// untouched. Rolling counter and tick are the receiver's to judge (`CounterWatch`): they need memory.
/// `Freshness` is left alone.
[[nodiscard]] Rejection decode_sync(const CanFrame&, FrameStamp&) noexcept;
/// LEG_COMMAND and LEG_POSITION; the members that the frame does not carry become 0.
[[nodiscard]] Rejection decode_leg_command(const CanFrame&, FrameStamp&, LegCommand&) noexcept;
[[nodiscard]] Rejection decode_leg_state(const CanFrame&, FrameStamp&, LegSensors&, LegStatus&) noexcept;
[[nodiscard]] Rejection decode_foot_force(const CanFrame&, FrameStamp&, FootSensors&) noexcept;
[[nodiscard]] Rejection decode_imu(const CanFrame&, FrameStamp&, ImuSensors&) noexcept;
[[nodiscard]] Rejection decode_leg_inertial(const CanFrame&, FrameStamp&, LegInertialSensors&) noexcept;
[[nodiscard]] Rejection decode_foot_inertial(const CanFrame&, FrameStamp&, FootInertialSensors&) noexcept;
[[nodiscard]] Rejection decode_heartbeat(const CanFrame&, FrameStamp&, Heartbeat&) noexcept;
[[nodiscard]] Rejection decode_emergency(const CanFrame&, FrameStamp&, Emergency&) noexcept;
[[nodiscard]] Rejection decode_lockstep_served(const CanFrame&, FrameStamp&) noexcept;

}  // namespace surefoot::can
