#pragma once

#include <array>
#include <memory>
#include <vector>

#include "firmware/host/bus/socket_bus.hpp"

namespace surefoot::host {

/// Two buses as one: one bus a leg.
///
/// Sends: left leg and left foot (nodes 2, 4) on the second bus; SYNC and the controller's heartbeat on both;
/// all else on the first. Receives from both, whatever is heard where, merged by the kernel's time stamps. What one
/// participant sends, in one call or several, comes in that order wherever a frame for both buses stands between;
/// that one comes once, from the bus that was faster.
class BusBundle final : public HostBus {
 public:
  using Members = std::array<std::unique_ptr<SocketBus>, 2>;

  explicit BusBundle(Members members);

  /// A frame that does not get through on one bus holds up that bus alone: a dead leg's bus does not silence the
  /// other. @return `frames.size()` less the frames that were refused by a bus; not always a prefix
  std::size_t send(std::span<const can::CanFrame> frames) noexcept override;
  std::size_t receive(std::span<can::CanFrame> frames) noexcept override;
  bool wait_readable(std::int64_t deadline_monotonic_ns) noexcept override;

  /// Sums; up when both are. A frame that goes out on both buses counts twice.
  [[nodiscard]] BusReport report() const noexcept override;
  [[nodiscard]] std::span<const std::int64_t> receive_times_ns() const noexcept override {
    return std::span(times_ns_).first(time_count_);
  }

 private:
  /// Frames that a member has delivered and the caller has not taken yet.
  struct Inbox {
    std::vector<can::CanFrame> frames;
    std::vector<std::int64_t> times_ns;
    std::size_t next = 0;
    std::size_t count = 0;

    [[nodiscard]] bool is_empty() const noexcept { return next == count; }
  };

  /// Sends what stands in the outboxes. @return frames that a bus refused
  std::size_t flush() noexcept;
  void refill(std::size_t member) noexcept;
  /// Whether the other bus has just brought the very same frame for both buses.
  [[nodiscard]] bool is_copy(const can::CanFrame& frame, std::size_t member) noexcept;

  /// The last frame for both buses, whose copy on the other one is yet to come.
  struct Original {
    can::CanFrame frame{};
    std::size_t member = 0;
    bool is_awaited = false;
  };

  Members members_;
  std::array<Inbox, 2> inboxes_;
  std::array<std::vector<can::CanFrame>, 2> outboxes_;
  std::array<Original, 2> originals_{};  ///< SYNC, the controller's heartbeat
  std::array<std::int64_t, SocketBus::kMaxReceivedFrames> times_ns_{};
  std::size_t time_count_ = 0;
};

}  // namespace surefoot::host
