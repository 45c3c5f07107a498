#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "firmware/core/leg_command.hpp"

namespace surefoot::sim_hw {

/// Commands on their way to the motors: each takes effect at a physics step of its own.
class CommandQueue {
 public:
  static constexpr std::size_t kCapacity = 64;

  /// Commands come in the order of their steps. A full queue loses its oldest.
  void push(std::uint64_t at_step, const LegCommand& command) noexcept {
    if (count_ == kCapacity) drop_oldest();
    entry_[(first_ + count_) % kCapacity] = {at_step, command};
    ++count_;
  }

  /// Replaces `active` by the newest command that is due.
  /// @return whether one was
  bool take_due(std::uint64_t step, LegCommand& active) noexcept {
    const std::size_t waiting = count_;
    while (count_ > 0 && entry_[first_].at_step <= step) {
      active = entry_[first_].command;
      drop_oldest();
    }
    return count_ != waiting;
  }

  void clear() noexcept { count_ = 0; }

 private:
  struct Entry {
    std::uint64_t at_step = 0;
    LegCommand command;
  };

  void drop_oldest() noexcept {
    first_ = (first_ + 1) % kCapacity;
    --count_;
  }

  std::array<Entry, kCapacity> entry_{};
  std::size_t first_ = 0;
  std::size_t count_ = 0;
};

}  // namespace surefoot::sim_hw
