#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <type_traits>

#include "firmware/host/spsc_ring.hpp"

namespace surefoot::host {

/// What is told to the outside, one LCM type each (lcm_types/).
enum class Channel : std::uint8_t {
  kControllerState,   ///< controller_state_t, every tick
  kEvent,             ///< event_t, when something happens
  kSimulatorTruth,    ///< simulator_truth_t, every tick
  kBusStatistics,     ///< bus_statistics_t, now and then
  kTimingStatistics,  ///< timing_statistics_t, now and then; live only, never in the log
  kStabilizer,        ///< stabilizer_t, every tick of a floor walk
  kRun,               ///< run_t, every second of wall time; live only
};

/// LCM channel names, indexed by `Channel`.
inline constexpr std::array<const char*, 7> kChannelNames{"SUREFOOT_STATE",  "SUREFOOT_EVENT",
                                                          "SUREFOOT_TRUTH",  "SUREFOOT_BUS",
                                                          "SUREFOOT_TIMING", "SUREFOOT_STABILIZER",
                                                          "SUREFOOT_RUN"};

[[nodiscard]] constexpr const char* name(Channel channel) noexcept {
  return kChannelNames[static_cast<std::size_t>(channel)];
}

/// One message on its way from the loop to the recorder: the generated LCM struct as it stands in
/// memory, and the function that can encode it.
struct TelemetrySlot {
  static constexpr std::size_t kMaxMessageBytes = 1536;

  /// @return bytes written to `buffer`, negative when `size` is too small
  using Encode = int (*)(const std::byte* message, void* buffer, int size);

  alignas(std::max_align_t) std::array<std::byte, kMaxMessageBytes> message;
  Encode encode;
  std::int64_t utime_us;
  Channel channel;
};

/// Encodes any message that `push` below accepts; LCM's wire format is never larger than the struct
/// plus its 8-byte fingerprint.
inline constexpr std::size_t kMaxEncodedBytes = TelemetrySlot::kMaxMessageBytes + 8;

using TelemetryRing = SpscRing<TelemetrySlot>;

/// Copies a generated LCM struct into the ring; about 50 ns. Encoding is the consumer's work.
///
/// @param utime_us  scenario clock, may be negative
/// @return false when the ring is full (counted there)
template <class Message>
bool push(TelemetryRing& ring, Channel channel, std::int64_t utime_us, const Message& message) noexcept {
  static_assert(std::is_trivially_copyable_v<Message>, "only fixed-size arrays in lcm_types: no string, no T v[n]");
  static_assert(sizeof(Message) <= TelemetrySlot::kMaxMessageBytes);
  return ring.produce([&](TelemetrySlot& slot) {
    std::memcpy(slot.message.data(), &message, sizeof(Message));
    slot.encode = [](const std::byte* bytes, void* buffer, int size) {
      return std::launder(reinterpret_cast<const Message*>(bytes))->encode(buffer, 0, size);
    };
    slot.utime_us = utime_us;
    slot.channel = channel;
  });
}

}  // namespace surefoot::host
