#pragma once

#include <array>
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

[[nodiscard]] constexpr std::uint16_t emergency_identifier(Node node) noexcept {
  return static_cast<std::uint16_t>(0x080 + static_cast<std::uint16_t>(node));
}
[[nodiscard]] constexpr std::uint16_t state_identifier(Node node) noexcept {
  return static_cast<std::uint16_t>(0x180 + static_cast<std::uint16_t>(node));
}
[[nodiscard]] constexpr std::uint16_t command_identifier(Node node) noexcept {
  return static_cast<std::uint16_t>(0x200 + static_cast<std::uint16_t>(node));
}
[[nodiscard]] constexpr std::uint16_t heartbeat_identifier(Node node) noexcept {
  return static_cast<std::uint16_t>(0x700 + static_cast<std::uint16_t>(node));
}

[[nodiscard]] constexpr Node leg_node(Side side) noexcept {
  return side == Side::kRight ? Node::kLegRight : Node::kLegLeft;
}
[[nodiscard]] constexpr Node foot_node(Side side) noexcept {
  return side == Side::kRight ? Node::kFootRight : Node::kFootLeft;
}

}  // namespace surefoot::can
