#pragma once

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>

namespace surefoot::host {

/// Lock-free ring from one producer thread to one consumer thread. Memory is taken and touched at
/// construction; afterwards nothing allocates, blocks or calls the system. A full ring refuses and
/// counts: the producer never waits for the consumer.
///
/// Indices count up for ever; slot = index modulo capacity. The producer's writes to a slot happen
/// before the consumer's reads of it (release of `written_`, acquire in `consume`), and the other
/// way round for reuse (`read_`).
template <typename Slot>
class SpscRing {
 public:
  /// @param capacity  slots, a power of two
  /// @throws std::invalid_argument otherwise
  explicit SpscRing(std::size_t capacity) : mask_(capacity - 1) {
    if (!std::has_single_bit(capacity)) throw std::invalid_argument("ring capacity must be a power of two");
    slots_ = std::make_unique<Slot[]>(capacity);
  }

  [[nodiscard]] std::size_t capacity() const noexcept { return mask_ + 1; }

  /// Producer: lets `fill(Slot&)` write the next slot in place.
  /// @return false when the ring is full: nothing was called, one more drop is counted
  template <typename Fill>
  bool produce(Fill&& fill) noexcept {
    const std::uint64_t written = written_.load(std::memory_order_relaxed);
    if (written - read_seen_ > mask_) {
      read_seen_ = read_.load(std::memory_order_acquire);
      if (written - read_seen_ > mask_) {
        drops_.store(drops_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
        return false;
      }
    }
    fill(slots_[written & mask_]);
    written_.store(written + 1, std::memory_order_release);
    return true;
  }

  /// Consumer: hands at most `limit` waiting slots to `take(const Slot&)`, oldest first, then frees
  /// them together.
  /// @return how many
  template <typename Take>
  std::size_t consume(Take&& take, std::size_t limit) {
    const std::uint64_t read = read_.load(std::memory_order_relaxed);
    const std::uint64_t waiting = written_.load(std::memory_order_acquire) - read;
    const std::size_t count = std::min<std::size_t>(waiting, limit);
    for (std::size_t i = 0; i < count; ++i) take(static_cast<const Slot&>(slots_[(read + i) & mask_]));
    read_.store(read + count, std::memory_order_release);
    return count;
  }

  /// Producer: slots free for the next pushes; more may become free at any time.
  [[nodiscard]] std::size_t room() const noexcept {
    const std::uint64_t read = read_.load(std::memory_order_acquire);
    return capacity() - static_cast<std::size_t>(written_.load(std::memory_order_relaxed) - read);
  }

  /// Any thread: pushes refused so far.
  [[nodiscard]] std::uint64_t drops() const noexcept { return drops_.load(std::memory_order_relaxed); }

 private:
  static constexpr std::size_t kCacheLine = 64;

  std::unique_ptr<Slot[]> slots_;
  std::size_t mask_;
  alignas(kCacheLine) std::atomic<std::uint64_t> written_{0};  // the producer's line
  std::uint64_t read_seen_ = 0;                                // read_ as the producer last saw it
  std::atomic<std::uint64_t> drops_{0};
  alignas(kCacheLine) std::atomic<std::uint64_t> read_{0};  // the consumer's line
};

}  // namespace surefoot::host
