#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "firmware/can/can_frame.hpp"

namespace surefoot::host {

/// Bytes of the longest datagram that `encode_datagram` writes, and room for a channel's name in others'.
inline constexpr std::size_t kMaxDatagramBytes = 512;

/// Writes a frame as python-can's `udp_multicast` does: a msgpack map of eleven fields, see `pack_message` of
/// python-can 4.6 (can/interfaces/udp_multicast/utils.py). The time stamp is 0: receivers put in their own.
/// @param datagram  room for kMaxDatagramBytes
/// @return bytes written
std::size_t encode_datagram(const can::CanFrame& frame, std::span<std::byte> datagram) noexcept;

/// What a datagram holds.
enum class DatagramKind : std::uint8_t {
  kFrame,  ///< a CAN FD data frame with an 11-bit identifier
  kErrorFrame,
  kForeign,  ///< another shape of frame, or no frame at all
};

/// Reads what `pack_message` of python-can writes, as strictly as its `unpack_message`: an unknown field, a value
/// of a wrong type or range, or bytes behind the map make it foreign. Takes memory at construction only.
class DatagramReader {
 public:
  DatagramReader();
  ~DatagramReader();
  DatagramReader(const DatagramReader&) = delete;
  DatagramReader& operator=(const DatagramReader&) = delete;

  /// @param frame  written for `kFrame` only
  [[nodiscard]] DatagramKind read(std::span<const std::byte> datagram, can::CanFrame& frame) noexcept;

 private:
  class Parser;
  std::unique_ptr<Parser> parser_;
};

}  // namespace surefoot::host
