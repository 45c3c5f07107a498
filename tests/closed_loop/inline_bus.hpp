#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <vector>

#include "firmware/host/bus/host_bus.hpp"
#include "firmware/host/realtime/monotonic_clock.hpp"

namespace surefoot::testing {

/// The firmware's end of a bus whose other end lives in the same thread: whenever the firmware waits, the
/// other end gets to work. No kernel, no second thread, the same order every time.
class InlineBus final : public host::HostBus {
 public:
  /// The other end: takes what the firmware has sent, sends what it likes.
  class FarEnd final : public can::CanBus {
   public:
    std::size_t send(std::span<const can::CanFrame> frames) noexcept override {
      to_firmware.insert(to_firmware.end(), frames.begin(), frames.end());
      return frames.size();
    }
    std::size_t receive(std::span<can::CanFrame> frames) noexcept override { return take(from_firmware, frames); }

    static std::size_t take(std::vector<can::CanFrame>& queue, std::span<can::CanFrame> frames) {
      const std::size_t count = std::min(frames.size(), queue.size());
      std::copy_n(queue.begin(), count, frames.begin());
      queue.erase(queue.begin(), queue.begin() + static_cast<std::ptrdiff_t>(count));
      return count;
    }

    std::vector<can::CanFrame> to_firmware;
    std::vector<can::CanFrame> from_firmware;
  };

  /// @param work  called in every wait, with the far end
  explicit InlineBus(std::function<void(FarEnd&)> work) : work_(std::move(work)) {}

  std::size_t send(std::span<const can::CanFrame> frames) noexcept override {
    sent.insert(sent.end(), frames.begin(), frames.end());
    far_.from_firmware.insert(far_.from_firmware.end(), frames.begin(), frames.end());
    return frames.size();
  }

  std::size_t receive(std::span<can::CanFrame> frames) noexcept override {
    return FarEnd::take(far_.to_firmware, frames);
  }

  /// A far end that has nothing to say lets the time pass.
  bool wait_readable(std::int64_t deadline_monotonic_ns) noexcept override {
    work_(far_);
    if (!far_.to_firmware.empty()) return true;
    while (host::MonotonicClock::now_ns() < deadline_monotonic_ns) {
    }
    return false;
  }

  [[nodiscard]] host::BusReport report() const noexcept override { return {}; }

  [[nodiscard]] FarEnd& far() noexcept { return far_; }

  std::vector<can::CanFrame> sent;  ///< by the firmware, all of it

 private:
  std::function<void(FarEnd&)> work_;
  FarEnd far_;
};

}  // namespace surefoot::testing
