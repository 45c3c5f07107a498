#include "sim_hw/bus/traffic.hpp"

#include <array>
#include <cmath>

#include "firmware/can/generated/surefoot.h"

namespace surefoot::sim_hw {
namespace {

using can::Node;

constexpr std::uint32_t kHeartbeatTicks = 100;
constexpr std::uint16_t kNodeMask = 0x7F;

constexpr TrafficStream emergency(Node node, const char* name, std::uint8_t length) {
  return {can::emergency_identifier(node), name, node, StreamKind::kEmergency, length, 0};
}
constexpr TrafficStream state(Node node, const char* name, std::uint8_t length) {
  return {can::state_identifier(node), name, node, StreamKind::kState, length, 1};
}
constexpr TrafficStream inertial(Node node, const char* name, std::uint8_t length) {
  return {can::inertial_identifier(node), name, node, StreamKind::kState, length, 1, StreamUse::kInertialLegs};
}
constexpr TrafficStream torques(Node node, const char* name, std::uint8_t length) {
  return {can::command_identifier(node), name, Node::kController, StreamKind::kCommand, length, 1, StreamUse::kTorques};
}
constexpr TrafficStream angles(Node node, const char* name, std::uint8_t length) {
  return {can::position_identifier(node), name, Node::kController, StreamKind::kCommand, length, 1, StreamUse::kAngles};
}
constexpr TrafficStream heartbeat(Node node, const char* name, std::uint8_t length) {
  return {can::heartbeat_identifier(node), name, node, StreamKind::kHeartbeat, length, kHeartbeatTicks};
}

constexpr std::array kTraffic{
    TrafficStream{can::kSyncIdentifier, "SYNC", Node::kController, StreamKind::kSync, SUREFOOT_SYNC_LENGTH, 1},
    emergency(Node::kLegRight, "EMERGENCY_LEG_RIGHT", SUREFOOT_EMERGENCY_LEG_RIGHT_LENGTH),
    emergency(Node::kLegLeft, "EMERGENCY_LEG_LEFT", SUREFOOT_EMERGENCY_LEG_LEFT_LENGTH),
    emergency(Node::kFootRight, "EMERGENCY_FOOT_RIGHT", SUREFOOT_EMERGENCY_FOOT_RIGHT_LENGTH),
    emergency(Node::kFootLeft, "EMERGENCY_FOOT_LEFT", SUREFOOT_EMERGENCY_FOOT_LEFT_LENGTH),
    emergency(Node::kTorsoImu, "EMERGENCY_TORSO_IMU", SUREFOOT_EMERGENCY_TORSO_IMU_LENGTH),
    emergency(Node::kController, "EMERGENCY_CONTROLLER", SUREFOOT_EMERGENCY_CONTROLLER_LENGTH),
    state(Node::kLegRight, "LEG_STATE_RIGHT", SUREFOOT_LEG_STATE_RIGHT_LENGTH),
    state(Node::kLegLeft, "LEG_STATE_LEFT", SUREFOOT_LEG_STATE_LEFT_LENGTH),
    state(Node::kFootRight, "FOOT_FORCE_RIGHT", SUREFOOT_FOOT_FORCE_RIGHT_LENGTH),
    state(Node::kFootLeft, "FOOT_FORCE_LEFT", SUREFOOT_FOOT_FORCE_LEFT_LENGTH),
    state(Node::kTorsoImu, "IMU", SUREFOOT_IMU_LENGTH),
    torques(Node::kLegRight, "LEG_COMMAND_RIGHT", SUREFOOT_LEG_COMMAND_RIGHT_LENGTH),
    torques(Node::kLegLeft, "LEG_COMMAND_LEFT", SUREFOOT_LEG_COMMAND_LEFT_LENGTH),
    inertial(Node::kLegRight, "LEG_INERTIAL_RIGHT", SUREFOOT_LEG_INERTIAL_RIGHT_LENGTH),
    inertial(Node::kLegLeft, "LEG_INERTIAL_LEFT", SUREFOOT_LEG_INERTIAL_LEFT_LENGTH),
    inertial(Node::kFootRight, "FOOT_INERTIAL_RIGHT", SUREFOOT_FOOT_INERTIAL_RIGHT_LENGTH),
    inertial(Node::kFootLeft, "FOOT_INERTIAL_LEFT", SUREFOOT_FOOT_INERTIAL_LEFT_LENGTH),
    angles(Node::kLegRight, "LEG_POSITION_RIGHT", SUREFOOT_LEG_POSITION_RIGHT_LENGTH),
    angles(Node::kLegLeft, "LEG_POSITION_LEFT", SUREFOOT_LEG_POSITION_LEFT_LENGTH),
    heartbeat(Node::kLegRight, "HEARTBEAT_LEG_RIGHT", SUREFOOT_HEARTBEAT_LEG_RIGHT_LENGTH),
    heartbeat(Node::kLegLeft, "HEARTBEAT_LEG_LEFT", SUREFOOT_HEARTBEAT_LEG_LEFT_LENGTH),
    heartbeat(Node::kFootRight, "HEARTBEAT_FOOT_RIGHT", SUREFOOT_HEARTBEAT_FOOT_RIGHT_LENGTH),
    heartbeat(Node::kFootLeft, "HEARTBEAT_FOOT_LEFT", SUREFOOT_HEARTBEAT_FOOT_LEFT_LENGTH),
    heartbeat(Node::kTorsoImu, "HEARTBEAT_TORSO_IMU", SUREFOOT_HEARTBEAT_TORSO_IMU_LENGTH),
    heartbeat(Node::kController, "HEARTBEAT_CONTROLLER", SUREFOOT_HEARTBEAT_CONTROLLER_LENGTH)};

constexpr std::array<std::uint8_t, 0x800> make_places() {
  std::array<std::uint8_t, 0x800> places{};
  places.fill(kNoStream);
  for (std::size_t place = 0; place < kTraffic.size(); ++place) {
    places[kTraffic[place].identifier] = static_cast<std::uint8_t>(place);
  }
  return places;
}

constexpr std::array<std::uint8_t, 0x800> kPlaces = make_places();

}  // namespace

std::span<const TrafficStream> robot_traffic() noexcept { return kTraffic; }

std::vector<TrafficStream> streams_of(TrafficOptions options) {
  std::vector<TrafficStream> streams;
  for (TrafficStream stream : kTraffic) {
    if (stream.use == StreamUse::kInertialLegs && !options.has_inertial_legs) continue;
    if (stream.use == StreamUse::kAngles && !options.commands_angles) continue;
    if (stream.use == StreamUse::kTorques && options.commands_angles) stream.period_ticks = 0;
    streams.push_back(stream);
  }
  return streams;
}

std::size_t stream_of(std::uint16_t identifier) noexcept {
  return identifier < kPlaces.size() ? kPlaces[identifier] : kNoStream;
}

bool travels_on(std::uint16_t identifier, std::uint32_t bus, std::uint32_t count) noexcept {
  if (bus >= count) return false;
  if (count == 1 || identifier == can::kSyncIdentifier) return true;
  switch (static_cast<Node>(identifier & kNodeMask)) {  // every function code leaves the node its low seven bits
    case Node::kController:
      return true;
    case Node::kLegLeft:
    case Node::kFootLeft:
      return bus == 1;
    default:
      return bus == 0;
  }
}

BitTiming bit_timing(const BusConfig& config) noexcept {
  return {.nominal_bit_ns = static_cast<std::uint32_t>(std::llround(1.0e9 / config.nominal_bit_rate_hz)),
          .data_bit_ns = static_cast<std::uint32_t>(std::llround(1.0e9 / config.data_bit_rate_hz))};
}

}  // namespace surefoot::sim_hw
