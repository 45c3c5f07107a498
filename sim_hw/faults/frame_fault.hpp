#pragma once

#include <cstdint>

#include "firmware/can/can_frame.hpp"
#include "firmware/can/identifiers.hpp"

namespace surefoot::sim_hw {

/// Damages a frame: flips `bits` different bits of identifier and payload (all of them where it has fewer), or, one
/// in eight, gives it another length, the new bytes zero. Always changes it; the same draw does the same damage.
[[nodiscard]] can::CanFrame corrupted(can::CanFrame frame, unsigned bits, std::uint64_t draw) noexcept;

/// Whether a receiver takes a frame for one of the contract's: identifier, length, CRC and ranges.
[[nodiscard]] bool is_acceptable(const can::CanFrame& frame) noexcept;

/// Whether a receiver takes a frame for a node's answer to SYNC of this tick.
[[nodiscard]] bool is_answer(const can::CanFrame& frame, std::uint32_t tick) noexcept;

/// The same board on the other side; the node itself where there is none.
[[nodiscard]] can::Node twin_of(can::Node node) noexcept;

/// The frame under the identifier of the twin's.
/// @param is_sealed  with a CRC that fits the new identifier
[[nodiscard]] can::CanFrame swapped(can::CanFrame frame, bool is_sealed) noexcept;

}  // namespace surefoot::sim_hw
