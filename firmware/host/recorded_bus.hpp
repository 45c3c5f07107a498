#pragma once

#include "firmware/host/bus/host_bus.hpp"
#include "firmware/host/memory_bus.hpp"

namespace surefoot::host {

/// A bus of the operating system with a tap: shows every frame that this participant sends or receives.
class RecordedBus final : public HostBus {
 public:
  /// @param tap  may be null; both outlive this
  RecordedBus(HostBus& bus, BusTap* tap) noexcept : bus_(bus), tap_(tap) {}

  std::size_t send(std::span<const can::CanFrame> frames) noexcept override {
    const std::size_t taken = bus_.send(frames);
    show(frames.first(taken));
    return taken;
  }

  std::size_t receive(std::span<can::CanFrame> frames) noexcept override {
    const std::size_t taken = bus_.receive(frames);
    show(frames.first(taken));
    return taken;
  }

  bool wait_readable(std::int64_t deadline_monotonic_ns) noexcept override {
    return bus_.wait_readable(deadline_monotonic_ns);
  }

  [[nodiscard]] BusReport report() const noexcept override { return bus_.report(); }

  [[nodiscard]] std::span<const std::int64_t> receive_times_ns() const noexcept override {
    return bus_.receive_times_ns();
  }

 private:
  void show(std::span<const can::CanFrame> frames) noexcept {
    if (tap_ == nullptr) return;
    for (const can::CanFrame& frame : frames) tap_->on_frame(frame);
  }

  HostBus& bus_;
  BusTap* tap_;
};

}  // namespace surefoot::host
