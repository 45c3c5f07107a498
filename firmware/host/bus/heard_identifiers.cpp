#include "firmware/host/bus/heard_identifiers.hpp"

#include <array>

#include "firmware/can/identifiers.hpp"

namespace surefoot::host {
namespace {

// What only the controller may send.
constexpr std::array kOfController{can::kSyncIdentifier,
                                   can::command_identifier(can::Node::kLegRight),
                                   can::command_identifier(can::Node::kLegLeft),
                                   can::position_identifier(can::Node::kLegRight),
                                   can::position_identifier(can::Node::kLegLeft),
                                   can::heartbeat_identifier(can::Node::kController)};

constexpr std::size_t kSensorNodes = can::kNodes.size() - 1;
constexpr std::size_t kKinds = 3;  // state, emergency, heartbeat
constexpr std::size_t kInertialNodes = 4;

constexpr auto kForController = [] {
  std::array<std::uint16_t, kSensorNodes * kKinds + kInertialNodes + kOfController.size() + 1> heard{};
  std::size_t count = 0;
  for (const can::Node node : can::kNodes) {
    if (node == can::Node::kController) continue;
    heard[count++] = can::state_identifier(node);
    if (can::is_leg_board(node) || can::is_foot(node)) heard[count++] = can::inertial_identifier(node);
    heard[count++] = can::emergency_identifier(node);
    heard[count++] = can::heartbeat_identifier(node);
  }
  for (const std::uint16_t identifier : kOfController) heard[count++] = identifier;
  heard[count] = can::kLockstepServedIdentifier;
  return heard;
}();
static_assert(kForController.size() <= kMaxHeardIdentifiers);

}  // namespace

std::span<const std::uint16_t> heard_identifiers(BusRole role) noexcept {
  switch (role) {
    case BusRole::kController:
      return kForController;
    case BusRole::kRobot:
      return kOfController;
    case BusRole::kEverything:
      break;
  }
  return {};
}

}  // namespace surefoot::host
