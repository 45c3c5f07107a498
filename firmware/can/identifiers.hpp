#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "firmware/core/joints.hpp"

namespace surefoot::can {

/// Node numbers, CiA 301 style.
enum class Node : std::uint8_t {
  kLegRight = 1,
  kLegLeft = 2,
  kFootRight = 3,
  kFootLeft = 4,
  kTorsoImu = 5,
  kController = 0x7F,
};

/// Every node on the bus.
inline constexpr std::array kNodes{Node::kLegRight, Node::kLegLeft,  Node::kFootRight,
                                   Node::kFootLeft, Node::kTorsoImu, Node::kController};

inline constexpr std::uint16_t kSyncIdentifier = 0x080;

/// Simulated robot in lockstep only: it has answered all that it will for this tick's SYNC. Sent when some node
/// did not answer, so that the firmware need not wait for it; and with the announcements before tick 0, so that
/// firmware on the wall clock and a robot in lockstep do not take each other for their like.
inline constexpr std::uint16_t kLockstepServedIdentifier = 0x7F0;
/// The tick that such a frame carries when it is an announcement: nobody's SYNC is meant.
inline constexpr std::uint32_t kAnnouncedBeforeAnyTick = 0xFFFF'FFFF;

[[nodiscard]] constexpr std::uint16_t emergency_identifier(Node node) noexcept {
  return static_cast<std::uint16_t>(0x080 + static_cast<std::uint16_t>(node));
}
[[nodiscard]] constexpr std::uint16_t state_identifier(Node node) noexcept {
  return static_cast<std::uint16_t>(0x180 + static_cast<std::uint16_t>(node));
}
[[nodiscard]] constexpr std::uint16_t command_identifier(Node node) noexcept {
  return static_cast<std::uint16_t>(0x200 + static_cast<std::uint16_t>(node));
}
/// Of the second state frame: inertial sensors of legs and feet, on a robot that has them.
[[nodiscard]] constexpr std::uint16_t inertial_identifier(Node node) noexcept {
  return static_cast<std::uint16_t>(0x280 + static_cast<std::uint16_t>(node));
}
/// Of the second command frame: angles in the place of torques.
[[nodiscard]] constexpr std::uint16_t position_identifier(Node node) noexcept {
  return static_cast<std::uint16_t>(0x300 + static_cast<std::uint16_t>(node));
}
[[nodiscard]] constexpr std::uint16_t heartbeat_identifier(Node node) noexcept {
  return static_cast<std::uint16_t>(0x700 + static_cast<std::uint16_t>(node));
}

/// The nodes that the firmware listens to.
inline constexpr std::array kSensorNodes{Node::kLegRight, Node::kLegLeft, Node::kFootRight, Node::kFootLeft,
                                         Node::kTorsoImu};

/// Place of a sensor node in arrays of `kSensorNodes.size()`.
[[nodiscard]] constexpr std::size_t slot(Node node) noexcept { return static_cast<std::size_t>(node) - 1; }

/// Name as it appears in messages, e.g. "right foot".
[[nodiscard]] constexpr const char* name(Node node) noexcept {
  switch (node) {
    case Node::kLegRight:
      return "right leg board";
    case Node::kLegLeft:
      return "left leg board";
    case Node::kFootRight:
      return "right foot";
    case Node::kFootLeft:
      return "left foot";
    case Node::kTorsoImu:
      return "torso IMU";
    case Node::kController:
      return "controller";
  }
  return "unknown";
}

[[nodiscard]] constexpr bool is_leg_board(Node node) noexcept {
  return node == Node::kLegRight || node == Node::kLegLeft;
}

[[nodiscard]] constexpr bool is_foot(Node node) noexcept { return node == Node::kFootRight || node == Node::kFootLeft; }

[[nodiscard]] constexpr Node leg_node(Side side) noexcept {
  return side == Side::kRight ? Node::kLegRight : Node::kLegLeft;
}
[[nodiscard]] constexpr Node foot_node(Side side) noexcept {
  return side == Side::kRight ? Node::kFootRight : Node::kFootLeft;
}

}  // namespace surefoot::can
