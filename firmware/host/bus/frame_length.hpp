#pragma once

#include <cstddef>

namespace surefoot::host {

/// The payload lengths that a CAN FD frame can have (ISO 11898-1:2015, table of DLC).
[[nodiscard]] constexpr bool is_fd_length(std::size_t bytes) noexcept {
  if (bytes <= 8) return true;
  if (bytes <= 24) return bytes % 4 == 0;
  return bytes == 32 || bytes == 48 || bytes == 64;
}

}  // namespace surefoot::host
