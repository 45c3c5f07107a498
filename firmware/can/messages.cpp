#include "firmware/can/messages.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "firmware/can/generated/surefoot.h"
#include "firmware/can/protected_message.hpp"

namespace surefoot::can {
namespace {

// Frames of one kind have one layout in surefoot.dbc whatever their sender (a test checks it), so the
// generated code of one member serves its whole family.
using Sync = surefoot_sync_t;
using LockstepServed = surefoot_lockstep_served_t;
using LegCommandRaw = surefoot_leg_command_right_t;
using LegPositionRaw = surefoot_leg_position_right_t;
using LegStateRaw = surefoot_leg_state_right_t;
using FootForceRaw = surefoot_foot_force_right_t;
using ImuRaw = surefoot_imu_t;
using LegInertialRaw = surefoot_leg_inertial_right_t;
using FootInertialRaw = surefoot_foot_inertial_right_t;
using HeartbeatRaw = surefoot_heartbeat_leg_right_t;
using EmergencyRaw = surefoot_emergency_leg_right_t;

constexpr std::size_t kCrcFirst = 0;  ///< in all frames of the control loop
constexpr std::size_t kCrcLast = 6;   ///< where CiA 301 gives byte 0 a meaning

constexpr ProtectedMessage<Sync> kSync{surefoot_sync_pack, surefoot_sync_unpack, SUREFOOT_SYNC_LENGTH, kCrcFirst};
constexpr ProtectedMessage<LockstepServed> kLockstepServed{
    surefoot_lockstep_served_pack, surefoot_lockstep_served_unpack, SUREFOOT_LOCKSTEP_SERVED_LENGTH, kCrcFirst};
constexpr ProtectedMessage<LegCommandRaw> kLegCommand{
    surefoot_leg_command_right_pack, surefoot_leg_command_right_unpack, SUREFOOT_LEG_COMMAND_RIGHT_LENGTH, kCrcFirst};
constexpr ProtectedMessage<LegPositionRaw> kLegPosition{surefoot_leg_position_right_pack,
                                                        surefoot_leg_position_right_unpack,
                                                        SUREFOOT_LEG_POSITION_RIGHT_LENGTH, kCrcFirst};
constexpr ProtectedMessage<LegStateRaw> kLegState{surefoot_leg_state_right_pack, surefoot_leg_state_right_unpack,
                                                  SUREFOOT_LEG_STATE_RIGHT_LENGTH, kCrcFirst};
constexpr ProtectedMessage<FootForceRaw> kFootForce{surefoot_foot_force_right_pack, surefoot_foot_force_right_unpack,
                                                    SUREFOOT_FOOT_FORCE_RIGHT_LENGTH, kCrcFirst};
constexpr ProtectedMessage<ImuRaw> kImu{surefoot_imu_pack, surefoot_imu_unpack, SUREFOOT_IMU_LENGTH, kCrcFirst};
constexpr ProtectedMessage<LegInertialRaw> kLegInertial{surefoot_leg_inertial_right_pack,
                                                        surefoot_leg_inertial_right_unpack,
                                                        SUREFOOT_LEG_INERTIAL_RIGHT_LENGTH, kCrcFirst};
constexpr ProtectedMessage<FootInertialRaw> kFootInertial{surefoot_foot_inertial_right_pack,
                                                          surefoot_foot_inertial_right_unpack,
                                                          SUREFOOT_FOOT_INERTIAL_RIGHT_LENGTH, kCrcFirst};
constexpr ProtectedMessage<HeartbeatRaw> kHeartbeat{surefoot_heartbeat_leg_right_pack,
                                                    surefoot_heartbeat_leg_right_unpack,
                                                    SUREFOOT_HEARTBEAT_LEG_RIGHT_LENGTH, kCrcLast};
constexpr ProtectedMessage<EmergencyRaw> kEmergency{surefoot_emergency_leg_right_pack,
                                                    surefoot_emergency_leg_right_unpack,
                                                    SUREFOOT_EMERGENCY_LEG_RIGHT_LENGTH, kCrcLast};

#define SUREFOOT_SIGNAL(message, signal)                                                                             \
  Signal {                                                                                                           \
    &surefoot_##message##_t::signal, surefoot_##message##_##signal##_encode, surefoot_##message##_##signal##_decode, \
        surefoot_##message##_##signal##_is_in_range                                                                  \
  }
#define SUREFOOT_JOINT_SIGNALS(message, quantity)                                                         \
  std::array {                                                                                            \
    SUREFOOT_SIGNAL(message, hip_yaw_##quantity), SUREFOOT_SIGNAL(message, hip_roll_##quantity),          \
        SUREFOOT_SIGNAL(message, hip_pitch_##quantity), SUREFOOT_SIGNAL(message, knee_pitch_##quantity),  \
        SUREFOOT_SIGNAL(message, ankle_pitch_##quantity), SUREFOOT_SIGNAL(message, ankle_roll_##quantity) \
  }

constexpr auto kStateAngle = SUREFOOT_JOINT_SIGNALS(leg_state_right, angle_rad);
constexpr auto kStateRate = SUREFOOT_JOINT_SIGNALS(leg_state_right, rate_rad_s);
constexpr auto kStateTorque = SUREFOOT_JOINT_SIGNALS(leg_state_right, torque_nm);
constexpr auto kCommandTorque = SUREFOOT_JOINT_SIGNALS(leg_command_right, torque_nm);
constexpr auto kCommandAngle = SUREFOOT_JOINT_SIGNALS(leg_position_right, angle_rad);
constexpr std::array kCornerForce{
    SUREFOOT_SIGNAL(foot_force_right, front_left_force_n), SUREFOOT_SIGNAL(foot_force_right, front_right_force_n),
    SUREFOOT_SIGNAL(foot_force_right, rear_left_force_n), SUREFOOT_SIGNAL(foot_force_right, rear_right_force_n)};
constexpr std::array kAngularRate{SUREFOOT_SIGNAL(imu, angular_rate_x_body_rad_s),
                                  SUREFOOT_SIGNAL(imu, angular_rate_y_body_rad_s),
                                  SUREFOOT_SIGNAL(imu, angular_rate_z_body_rad_s)};
constexpr std::array kSpecificForce{SUREFOOT_SIGNAL(imu, specific_force_x_body_m_s2),
                                    SUREFOOT_SIGNAL(imu, specific_force_y_body_m_s2),
                                    SUREFOOT_SIGNAL(imu, specific_force_z_body_m_s2)};
constexpr std::array kHipRollRate{SUREFOOT_SIGNAL(leg_inertial_right, hip_roll_rate_rad_s)};
constexpr std::array kSoleTilt{SUREFOOT_SIGNAL(foot_inertial_right, sole_roll_rad),
                               SUREFOOT_SIGNAL(foot_inertial_right, sole_pitch_rad)};
constexpr std::array kSoleForce{SUREFOOT_SIGNAL(foot_inertial_right, specific_force_x_foot_m_s2),
                                SUREFOOT_SIGNAL(foot_inertial_right, specific_force_y_foot_m_s2)};

#undef SUREFOOT_JOINT_SIGNALS
#undef SUREFOOT_SIGNAL

std::span<const double, 3> components(const geometry::Vector3& vector) noexcept {
  return std::span<const double, 3>(vector.data(), 3);
}
std::span<double, 3> components(geometry::Vector3& vector) noexcept { return std::span<double, 3>(vector.data(), 3); }

/// True when one of the nodes sends this kind of frame under this identifier.
template <typename Nodes>
bool is_identifier_of(const Nodes& nodes, std::uint16_t (*identifier_of)(Node), std::uint16_t identifier) noexcept {
  return std::ranges::any_of(nodes, [&](Node node) { return identifier_of(node) == identifier; });
}

constexpr std::array kLegs{Node::kLegRight, Node::kLegLeft};
constexpr std::array kFeet{Node::kFootRight, Node::kFootLeft};

CanFrame encode_leg_position(Side side, FrameStamp stamp, const LegVector& angle_rad) noexcept {
  LegPositionRaw raw{};
  put(kCommandAngle, kJointAngleRad, angle_rad, raw);
  return kLegPosition.seal(position_identifier(leg_node(side)), stamp, raw);
}

Rejection decode_leg_position(const CanFrame& frame, FrameStamp& stamp, LegCommand& command) noexcept {
  LegPositionRaw raw;
  if (const Rejection rejection = kLegPosition.open(frame, raw); rejection != Rejection::kNone) return rejection;
  if (!are_plausible(kCommandAngle, raw)) return Rejection::kImplausible;
  stamp = stamp_of(raw);
  command = {.mode = LegMode::kPosition};
  take(kCommandAngle, raw, command.angle_rad);
  return Rejection::kNone;
}

bool is_known(NodeState state) noexcept {
  return state == NodeState::kBootUp || state == NodeState::kStopped || state == NodeState::kOperational ||
         state == NodeState::kPreOperational;
}

}  // namespace

CanFrame encode_sync(FrameStamp stamp) noexcept { return kSync.seal(kSyncIdentifier, stamp, {}); }

CanFrame encode_leg_command(Side side, FrameStamp stamp, const LegCommand& command) noexcept {
  if (command.mode == LegMode::kPosition) return encode_leg_position(side, stamp, command.angle_rad);
  LegCommandRaw raw{};
  raw.mode = static_cast<std::uint8_t>(command.mode);
  put(kCommandTorque, kJointTorqueNm, command.torque_nm, raw);
  return kLegCommand.seal(command_identifier(leg_node(side)), stamp, raw);
}

CanFrame encode_leg_state(Side side, FrameStamp stamp, const LegSensors& sensors, LegStatus status) noexcept {
  LegStateRaw raw{};
  raw.is_watchdog_expired = status.watchdog_expired ? 1 : 0;
  raw.is_torque_limited = status.torque_limited ? 1 : 0;
  raw.is_damping = status.is_damping ? 1 : 0;
  put(kStateAngle, kJointAngleRad, sensors.angle_rad, raw);
  put(kStateRate, kJointRateRadS, sensors.rate_rad_s, raw);
  put(kStateTorque, kJointTorqueNm, sensors.torque_nm, raw);
  return kLegState.seal(state_identifier(leg_node(side)), stamp, raw);
}

CanFrame encode_foot_force(Side side, FrameStamp stamp, const FootSensors& sensors) noexcept {
  FootForceRaw raw{};
  put(kCornerForce, kCornerForceN, sensors.corner_force_n, raw);
  return kFootForce.seal(state_identifier(foot_node(side)), stamp, raw);
}

CanFrame encode_imu(FrameStamp stamp, const ImuSensors& sensors) noexcept {
  ImuRaw raw{};
  put(kAngularRate, kAngularRateRadS, components(sensors.angular_rate_body_rad_s), raw);
  put(kSpecificForce, kSpecificForceMS2, components(sensors.specific_force_body_m_s2), raw);
  return kImu.seal(state_identifier(Node::kTorsoImu), stamp, raw);
}

CanFrame encode_leg_inertial(Side side, FrameStamp stamp, const LegInertialSensors& sensors) noexcept {
  LegInertialRaw raw{};
  put(kHipRollRate, kAngularRateRadS, std::array{sensors.hip_roll_rate_rad_s}, raw);
  return kLegInertial.seal(inertial_identifier(leg_node(side)), stamp, raw);
}

CanFrame encode_foot_inertial(Side side, FrameStamp stamp, const FootInertialSensors& sensors) noexcept {
  FootInertialRaw raw{};
  put(kSoleTilt, kSoleTiltRad, std::array{sensors.roll_rad, sensors.pitch_rad}, raw);
  put(kSoleForce, kSpecificForceMS2, std::array{sensors.specific_force_x_foot_m_s2, sensors.specific_force_y_foot_m_s2},
      raw);
  return kFootInertial.seal(inertial_identifier(foot_node(side)), stamp, raw);
}

CanFrame encode_heartbeat(Node node, FrameStamp stamp, Heartbeat heartbeat) noexcept {
  HeartbeatRaw raw{};
  raw.nmt_state = static_cast<std::uint8_t>(heartbeat.state);
  raw.protocol_version = heartbeat.protocol_version;
  raw.has_inertial_sensors = heartbeat.has_inertial_sensors ? 1 : 0;
  return kHeartbeat.seal(heartbeat_identifier(node), stamp, raw);
}

CanFrame encode_emergency(Node node, FrameStamp stamp, Emergency emergency) noexcept {
  EmergencyRaw raw{};
  raw.code = emergency.code;
  raw.error_register = emergency.error_register;
  return kEmergency.seal(emergency_identifier(node), stamp, raw);
}

CanFrame encode_lockstep_served(FrameStamp stamp) noexcept {
  return kLockstepServed.seal(kLockstepServedIdentifier, stamp, {});
}

Rejection decode_sync(const CanFrame& frame, FrameStamp& stamp) noexcept {
  if (frame.identifier != kSyncIdentifier) return Rejection::kUnknownIdentifier;
  Sync raw;
  if (const Rejection rejection = kSync.open(frame, raw); rejection != Rejection::kNone) return rejection;
  stamp = stamp_of(raw);
  return Rejection::kNone;
}

Rejection decode_leg_command(const CanFrame& frame, FrameStamp& stamp, LegCommand& command) noexcept {
  if (is_identifier_of(kLegs, position_identifier, frame.identifier)) return decode_leg_position(frame, stamp, command);
  if (!is_identifier_of(kLegs, command_identifier, frame.identifier)) return Rejection::kUnknownIdentifier;
  LegCommandRaw raw;
  if (const Rejection rejection = kLegCommand.open(frame, raw); rejection != Rejection::kNone) return rejection;
  if (!surefoot_leg_command_right_mode_is_in_range(raw.mode) || !are_plausible(kCommandTorque, raw)) {
    return Rejection::kImplausible;
  }
  stamp = stamp_of(raw);
  command = {.mode = static_cast<LegMode>(raw.mode)};
  take(kCommandTorque, raw, command.torque_nm);
  return Rejection::kNone;
}

Rejection decode_leg_state(const CanFrame& frame, FrameStamp& stamp, LegSensors& sensors, LegStatus& status) noexcept {
  if (!is_identifier_of(kLegs, state_identifier, frame.identifier)) return Rejection::kUnknownIdentifier;
  LegStateRaw raw;
  if (const Rejection rejection = kLegState.open(frame, raw); rejection != Rejection::kNone) return rejection;
  if (!are_plausible(kStateAngle, raw) || !are_plausible(kStateRate, raw) || !are_plausible(kStateTorque, raw)) {
    return Rejection::kImplausible;
  }
  stamp = stamp_of(raw);
  take(kStateAngle, raw, sensors.angle_rad);
  take(kStateRate, raw, sensors.rate_rad_s);
  take(kStateTorque, raw, sensors.torque_nm);
  status = {.watchdog_expired = raw.is_watchdog_expired != 0,
            .torque_limited = raw.is_torque_limited != 0,
            .is_damping = raw.is_damping != 0};
  return Rejection::kNone;
}

Rejection decode_foot_force(const CanFrame& frame, FrameStamp& stamp, FootSensors& sensors) noexcept {
  if (!is_identifier_of(kFeet, state_identifier, frame.identifier)) return Rejection::kUnknownIdentifier;
  FootForceRaw raw;
  if (const Rejection rejection = kFootForce.open(frame, raw); rejection != Rejection::kNone) return rejection;
  if (!are_plausible(kCornerForce, raw)) return Rejection::kImplausible;
  stamp = stamp_of(raw);
  take(kCornerForce, raw, sensors.corner_force_n);
  return Rejection::kNone;
}

Rejection decode_imu(const CanFrame& frame, FrameStamp& stamp, ImuSensors& sensors) noexcept {
  if (frame.identifier != state_identifier(Node::kTorsoImu)) return Rejection::kUnknownIdentifier;
  ImuRaw raw;
  if (const Rejection rejection = kImu.open(frame, raw); rejection != Rejection::kNone) return rejection;
  if (!are_plausible(kAngularRate, raw) || !are_plausible(kSpecificForce, raw)) return Rejection::kImplausible;
  stamp = stamp_of(raw);
  take(kAngularRate, raw, components(sensors.angular_rate_body_rad_s));
  take(kSpecificForce, raw, components(sensors.specific_force_body_m_s2));
  return Rejection::kNone;
}

Rejection decode_leg_inertial(const CanFrame& frame, FrameStamp& stamp, LegInertialSensors& sensors) noexcept {
  if (!is_identifier_of(kLegs, inertial_identifier, frame.identifier)) return Rejection::kUnknownIdentifier;
  LegInertialRaw raw;
  if (const Rejection rejection = kLegInertial.open(frame, raw); rejection != Rejection::kNone) return rejection;
  if (!are_plausible(kHipRollRate, raw)) return Rejection::kImplausible;
  stamp = stamp_of(raw);
  take(kHipRollRate, raw, std::span(&sensors.hip_roll_rate_rad_s, 1).first<1>());
  return Rejection::kNone;
}

Rejection decode_foot_inertial(const CanFrame& frame, FrameStamp& stamp, FootInertialSensors& sensors) noexcept {
  if (!is_identifier_of(kFeet, inertial_identifier, frame.identifier)) return Rejection::kUnknownIdentifier;
  FootInertialRaw raw;
  if (const Rejection rejection = kFootInertial.open(frame, raw); rejection != Rejection::kNone) return rejection;
  if (!are_plausible(kSoleTilt, raw) || !are_plausible(kSoleForce, raw)) return Rejection::kImplausible;
  stamp = stamp_of(raw);
  std::array<double, 2> tilt_rad;
  std::array<double, 2> force_m_s2;
  take(kSoleTilt, raw, tilt_rad);
  take(kSoleForce, raw, force_m_s2);
  sensors.roll_rad = tilt_rad[0];
  sensors.pitch_rad = tilt_rad[1];
  sensors.specific_force_x_foot_m_s2 = force_m_s2[0];
  sensors.specific_force_y_foot_m_s2 = force_m_s2[1];
  return Rejection::kNone;
}

Rejection decode_heartbeat(const CanFrame& frame, FrameStamp& stamp, Heartbeat& heartbeat) noexcept {
  if (!is_identifier_of(kNodes, heartbeat_identifier, frame.identifier)) return Rejection::kUnknownIdentifier;
  HeartbeatRaw raw;
  if (const Rejection rejection = kHeartbeat.open(frame, raw); rejection != Rejection::kNone) return rejection;
  const auto state = static_cast<NodeState>(raw.nmt_state);
  if (!is_known(state)) return Rejection::kImplausible;
  stamp = stamp_of(raw);
  heartbeat = {
      .state = state, .protocol_version = raw.protocol_version, .has_inertial_sensors = raw.has_inertial_sensors != 0};
  return Rejection::kNone;
}

Rejection decode_emergency(const CanFrame& frame, FrameStamp& stamp, Emergency& emergency) noexcept {
  if (!is_identifier_of(kNodes, emergency_identifier, frame.identifier)) return Rejection::kUnknownIdentifier;
  EmergencyRaw raw;
  if (const Rejection rejection = kEmergency.open(frame, raw); rejection != Rejection::kNone) return rejection;
  stamp = stamp_of(raw);
  emergency = {.code = raw.code, .error_register = raw.error_register};
  return Rejection::kNone;
}

Rejection decode_lockstep_served(const CanFrame& frame, FrameStamp& stamp) noexcept {
  if (frame.identifier != kLockstepServedIdentifier) return Rejection::kUnknownIdentifier;
  LockstepServed raw;
  if (const Rejection rejection = kLockstepServed.open(frame, raw); rejection != Rejection::kNone) return rejection;
  stamp = stamp_of(raw);
  return Rejection::kNone;
}

}  // namespace surefoot::can
