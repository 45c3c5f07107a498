#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "sim_hw/bus/frame_bits.hpp"

namespace surefoot::sim_hw {

/// One frame's way over the bus. Times on the clock of whoever queued it, in ns.
struct Transmission {
  can::CanFrame frame;
  FrameBits bits;               ///< of this very frame
  std::int64_t queued_ns = 0;   ///< ready at its node
  std::int64_t started_ns = 0;  ///< start of frame
  std::int64_t ended_ns = 0;    ///< end of intermission: the earliest start of the next frame

  [[nodiscard]] std::int64_t response_ns() const noexcept { return ended_ns - queued_ns; }
};

/// A CAN bus without errors, event by event in whole nanoseconds: whenever it is free, the frame with
/// the lowest identifier of those that are queued goes, whole (ISO 11898-1, arbitration). Of frames with
/// one identifier the one queued first goes first. Each takes the time of its exact bits. No heap.
class Arbiter {
 public:
  static constexpr std::size_t kCapacity = 256;  ///< frames waiting

  Arbiter() noexcept = default;
  explicit Arbiter(BitTiming timing) noexcept : timing_(timing) {}

  /// Adds a frame that is ready from `queued_ns` on; instants may come in any order, also earlier than
  /// what was sent already (it then goes when the bus is next free). False: full, and not taken.
  bool queue(const can::CanFrame& frame, std::int64_t queued_ns) noexcept;

  /// The next frame that starts before `until_ns`, if there is one; call until there is none. It may end later
  /// than `until_ns`. Whoever knows of no frame that will be ready before `until_ns`, other than those queued,
  /// has asked for the truth.
  [[nodiscard]] std::optional<Transmission> transmit_next(std::int64_t until_ns) noexcept;

  /// End of the last transmission.
  [[nodiscard]] std::int64_t busy_until_ns() const noexcept { return busy_until_ns_; }

  /// Frames that wait.
  [[nodiscard]] std::size_t waiting() const noexcept { return count_; }

  /// Moves the clock's zero forward by `elapsed_ns`, e.g. to the begin of the next tick.
  void rebase(std::int64_t elapsed_ns) noexcept;

 private:
  struct Waiting {
    can::CanFrame frame;
    std::int64_t queued_ns = 0;
    std::uint64_t order = 0;  ///< of its queueing
  };

  /// Index of the frame that wins at `now_ns`, or `count_` when none is ready.
  [[nodiscard]] std::size_t winner_at(std::int64_t now_ns) const noexcept;

  BitTiming timing_{};
  std::array<Waiting, kCapacity> waiting_{};
  std::size_t count_ = 0;
  std::uint64_t queued_ = 0;
  std::int64_t busy_until_ns_ = 0;
};

}  // namespace surefoot::sim_hw
