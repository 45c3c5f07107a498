#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/host/bus/host_bus.hpp"
#include "firmware/host/bus/message_batch.hpp"

namespace surefoot::host {

/// A bus behind a datagram socket: batches, counters, waiting, and links that go and come again.
class SocketBus : public HostBus {
 public:
  static constexpr std::size_t kMaxReceivedFrames = 256;            ///< of one `receive`
  static constexpr std::int64_t kLookForLinkEveryNs = 100'000'000;  ///< while it is down

  std::size_t send(std::span<const can::CanFrame> frames) noexcept final;
  std::size_t receive(std::span<can::CanFrame> frames) noexcept final;
  bool wait_readable(std::int64_t deadline_monotonic_ns) noexcept final;
  [[nodiscard]] BusReport report() const noexcept final { return report_; }
  [[nodiscard]] std::span<const std::int64_t> receive_times_ns() const noexcept final {
    return std::span(times_ns_).first(time_count_);
  }

  /// Sleeps until one of the buses is readable or the deadline has passed, see `HostBus::wait_readable`.
  /// @param buses  at most kMaxBuses
  static bool wait_for_any(std::span<SocketBus* const> buses, std::int64_t deadline_monotonic_ns) noexcept;
  static constexpr std::size_t kMaxBuses = 2;

 protected:
  explicit SocketBus(std::size_t datagram_capacity) : outgoing_(datagram_capacity), incoming_(datagram_capacity) {}

  [[nodiscard]] virtual int send_socket() const noexcept = 0;
  [[nodiscard]] virtual int receive_socket() const noexcept = 0;

  /// Writes a frame as a datagram. @return its length
  [[nodiscard]] virtual std::size_t encode(const can::CanFrame& frame, std::span<std::byte> datagram) noexcept = 0;

  /// Reads a frame from a datagram. @return false for what is not the caller's; then it is counted
  [[nodiscard]] virtual bool decode(const Received& received, BusReport& report, can::CanFrame& frame) noexcept = 0;

  /// Looks for a link that went away, and attaches to it anew. @return true when it is up
  [[nodiscard]] virtual bool restore_link() noexcept = 0;

 private:
  void note_link_error() noexcept;
  void take_socket_error() noexcept;
  void look_for_link(std::int64_t now_ns) noexcept;
  void look_for_link_if_down() noexcept;
  [[nodiscard]] bool take(const Received& received, can::CanFrame& frame) noexcept;

  MessageBatch outgoing_;
  MessageBatch incoming_;
  BusReport report_{};
  std::array<std::int64_t, kMaxReceivedFrames> times_ns_{};
  std::size_t time_count_ = 0;
  std::uint32_t kernel_drops_ = 0;
  std::int64_t next_look_ns_ = 0;
};

}  // namespace surefoot::host
