#pragma once

#include <cstdint>

#include "firmware/can/can_frame.hpp"

namespace surefoot::sim_hw {

/// What a classic frame with an 11-bit identifier carries.
enum class ClassicKind : std::uint8_t {
  kData,
  kRemote,  ///< a request: it names a length and carries no payload
};

/// Bits that this very frame takes as a classic CAN frame, at one bit rate: start of frame to 3 bits of
/// intermission, with the stuff bits of its own bits, CRC-15 included. Acknowledged, no error.
/// Source: ISO 11898-1:2015, classical base frame format and bit stuffing.
///
/// Of a longer payload 8 bytes count; identifiers are cut to 11 bits. Cost: about 0.3 us.
[[nodiscard]] std::uint32_t classic_frame_bits(const can::CanFrame&, ClassicKind = ClassicKind::kData) noexcept;

/// An upper bound for every classic data frame of this payload length: 55 + 10 n bits.
/// Source: Davis, Burns, Bril, Lukkien 2007, the transmission time of a frame with an 11-bit identifier.
[[nodiscard]] std::uint32_t worst_case_classic_frame_bits(std::uint8_t length) noexcept;

}  // namespace surefoot::sim_hw
