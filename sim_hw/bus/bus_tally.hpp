#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "sim_hw/bus/arbiter.hpp"
#include "sim_hw/bus/traffic.hpp"

namespace surefoot::sim_hw {

/// What one stream's frames were seen to need.
struct StreamTally {
  std::uint64_t frames = 0;
  std::int64_t worst_response_ns = 0;  ///< from queued to the end of the frame
};

/// Running totals of one bus: exact bits, and the slowest frame of each stream.
class BusTally {
 public:
  static constexpr std::size_t kMaxStreams = 32;

  BusTally() noexcept = default;
  explicit BusTally(BitTiming timing) noexcept : timing_(timing) {}

  void add(const Transmission& sent) noexcept {
    add_bits(sent.bits);
    const std::size_t stream = stream_of(sent.frame.identifier);
    if (stream >= kMaxStreams) return;
    ++stream_[stream].frames;
    stream_[stream].worst_response_ns = std::max(stream_[stream].worst_response_ns, sent.response_ns());
  }

  /// A frame of which only the length is known.
  void add_bits(FrameBits bits) noexcept {
    ++frames_;
    nominal_bits_ += bits.nominal;
    data_bits_ += bits.data;
  }

  [[nodiscard]] std::uint64_t frames() const noexcept { return frames_; }
  [[nodiscard]] std::uint64_t nominal_bits() const noexcept { return nominal_bits_; }
  [[nodiscard]] std::uint64_t data_bits() const noexcept { return data_bits_; }
  [[nodiscard]] std::uint64_t busy_ns() const noexcept {
    return nominal_bits_ * timing_.nominal_bit_ns + data_bits_ * timing_.data_bit_ns;
  }

  /// @param elapsed_ns  time over which the frames were added; 0 gives 0
  [[nodiscard]] double load_percent(std::int64_t elapsed_ns) const noexcept {
    return elapsed_ns <= 0 ? 0.0 : 100.0 * static_cast<double>(busy_ns()) / static_cast<double>(elapsed_ns);
  }

  /// @param stream  place in `robot_traffic()`
  [[nodiscard]] const StreamTally& stream(std::size_t stream) const noexcept { return stream_[stream]; }

 private:
  BitTiming timing_{};
  std::uint64_t frames_ = 0;
  std::uint64_t nominal_bits_ = 0;
  std::uint64_t data_bits_ = 0;
  std::array<StreamTally, kMaxStreams> stream_{};
};

}  // namespace surefoot::sim_hw
