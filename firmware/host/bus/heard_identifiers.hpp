#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/host/bus/host_bus.hpp"

namespace surefoot::host {

/// Of any role.
inline constexpr std::size_t kMaxHeardIdentifiers = 32;

/// The identifiers that a participant wants to hear; empty means all.
[[nodiscard]] std::span<const std::uint16_t> heard_identifiers(BusRole role) noexcept;

}  // namespace surefoot::host
