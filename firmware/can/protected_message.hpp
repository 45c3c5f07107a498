#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "firmware/can/end_to_end.hpp"
#include "firmware/can/messages.hpp"
#include "firmware/can/physical_range.hpp"

namespace surefoot::can {

/// One message of the generated codec. `Message` is its struct of raw signals; all of them have the
/// signals `counter` and `tick`.
template <typename Message>
struct ProtectedMessage {
  int (*pack)(std::uint8_t*, const Message*, std::size_t);
  int (*unpack)(Message*, const std::uint8_t*, std::size_t);
  std::uint8_t length;
  std::size_t crc_offset;

  /// @return the frame, stamped and with its CRC
  [[nodiscard]] CanFrame seal(std::uint16_t identifier, FrameStamp stamp, Message message) const noexcept {
    message.counter = stamp.counter;
    message.tick = static_cast<decltype(message.tick)>(stamp.tick);
    CanFrame frame{.identifier = identifier, .length = length};
    static_cast<void>(pack(frame.payload.data(), &message, frame.payload.size()));  // fails for a short buffer only
    protect(frame, crc_offset);
    return frame;
  }

  /// Checks length and CRC, then unpacks.
  [[nodiscard]] Rejection open(const CanFrame& frame, Message& message) const noexcept {
    if (frame.length != length) return Rejection::kWrongLength;
    if (!is_intact(frame, crc_offset)) return Rejection::kWrongCrc;
    static_cast<void>(unpack(&message, frame.payload.data(), frame.length));  // fails for a short buffer only
    return Rejection::kNone;
  }
};

template <typename Message>
[[nodiscard]] FrameStamp stamp_of(const Message& message) noexcept {
  return {.tick = message.tick, .counter = message.counter};
}

/// One physical signal: where its raw value lies and the generated functions that scale and check it.
template <typename Message, typename Raw>
struct Signal {
  Raw Message::*raw;
  Raw (*encode)(double);
  double (*decode)(Raw);
  bool (*is_in_range)(Raw);
};

template <typename Message, typename Raw, std::size_t kCount>
using Signals = std::array<Signal<Message, Raw>, kCount>;

/// Scales values into raw signals, clamped to the range: the generated code converts without a check.
template <typename Message, typename Raw, std::size_t kCount>
void put(const Signals<Message, Raw, kCount>& signals, PhysicalRange range,
         std::type_identity_t<std::span<const double, kCount>> values, Message& message) noexcept {
  for (std::size_t i = 0; i < kCount; ++i) message.*signals[i].raw = signals[i].encode(range.clamp(values[i]));
}

/// True when every raw signal is inside its physical range.
template <typename Message, typename Raw, std::size_t kCount>
[[nodiscard]] bool are_plausible(const Signals<Message, Raw, kCount>& signals, const Message& message) noexcept {
  for (const Signal<Message, Raw>& signal : signals) {
    if (!signal.is_in_range(message.*signal.raw)) return false;
  }
  return true;
}

/// Scales raw signals into values.
template <typename Message, typename Raw, std::size_t kCount>
void take(const Signals<Message, Raw, kCount>& signals, const Message& message,
          std::type_identity_t<std::span<double, kCount>> values) noexcept {
  for (std::size_t i = 0; i < kCount; ++i) values[i] = signals[i].decode(message.*signals[i].raw);
}

}  // namespace surefoot::can
