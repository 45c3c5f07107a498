#include "firmware/host/bus/socket_bus.hpp"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <ctime>

namespace surefoot::host {
namespace {

constexpr std::int64_t kNsPerSecond = 1'000'000'000;
constexpr std::size_t kMaxBatches = 8;  // of one `receive`: a flood of what is dropped does not hold the tick

std::int64_t monotonic_now_ns() noexcept {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * kNsPerSecond + now.tv_nsec;
}

bool is_full(int error) noexcept { return error == ENOBUFS || error == EAGAIN || error == EWOULDBLOCK; }

}  // namespace

std::size_t SocketBus::send(std::span<const can::CanFrame> frames) noexcept {
  look_for_link_if_down();
  bool may_retry = report_.is_up;  // the first error may be an old one: of a link that is up again by now
  std::size_t taken = 0;
  while (taken < frames.size()) {
    const auto batch = frames.subspan(taken, std::min(frames.size() - taken, MessageBatch::kMessages));
    for (std::size_t i = 0; i < batch.size(); ++i) outgoing_.set_length(i, encode(batch[i], outgoing_.buffer(i)));
    const int sent = outgoing_.send(send_socket(), batch.size());
    if (sent < 0) {
      const int error = errno;
      if (is_full(error)) {
        report_.refused_no_buffer += frames.size() - taken;
        break;
      }
      note_link_error();
      if (!may_retry) break;
      may_retry = false;
      continue;
    }
    report_.is_up = true;
    taken += static_cast<std::size_t>(sent);
  }
  report_.sent += taken;
  return taken;
}

std::size_t SocketBus::receive(std::span<can::CanFrame> frames) noexcept {
  look_for_link_if_down();
  time_count_ = 0;
  const std::size_t wanted = std::min(frames.size(), kMaxReceivedFrames);
  for (std::size_t batch = 0; batch < kMaxBatches && time_count_ < wanted; ++batch) {
    const std::size_t asked = std::min(wanted - time_count_, MessageBatch::kMessages);
    const int result = incoming_.receive(receive_socket(), asked);
    if (result < 0) {
      if (is_full(errno)) break;
      note_link_error();  // frames may still wait behind the error
      continue;
    }
    const auto count = static_cast<std::size_t>(result);
    for (std::size_t i = 0; i < count; ++i) {
      const Received received = incoming_.received(i);
      if (take(received, frames[time_count_])) times_ns_[time_count_++] = received.time_ns;
    }
    if (count < asked) break;
  }
  report_.received += time_count_;
  return time_count_;
}

bool SocketBus::take(const Received& received, can::CanFrame& frame) noexcept {
  if (received.kernel_drops) {
    report_.queue_overflow += *received.kernel_drops - kernel_drops_;  // modulo 2^32
    kernel_drops_ = *received.kernel_drops;
  }
  return decode(received, report_, frame);
}

bool SocketBus::wait_readable(std::int64_t deadline_monotonic_ns) noexcept {
  SocketBus* const self = this;
  return wait_for_any({&self, 1}, deadline_monotonic_ns);
}

bool SocketBus::wait_for_any(std::span<SocketBus* const> buses, std::int64_t deadline_monotonic_ns) noexcept {
  std::array<pollfd, kMaxBuses> polled{};
  while (true) {
    const std::int64_t now_ns = monotonic_now_ns();
    std::int64_t wake_ns = std::max(deadline_monotonic_ns, now_ns);
    for (std::size_t i = 0; i < buses.size(); ++i) {
      polled[i] = {.fd = buses[i]->receive_socket(), .events = POLLIN, .revents = 0};
      if (buses[i]->report_.is_up) continue;
      buses[i]->look_for_link(now_ns);
      if (!buses[i]->report_.is_up) wake_ns = std::min(wake_ns, buses[i]->next_look_ns_);
    }
    // Not SO_RCVTIMEO, which rounds to jiffies.
    const std::int64_t sleep_ns = wake_ns - now_ns;
    const timespec sleep{.tv_sec = sleep_ns / kNsPerSecond, .tv_nsec = sleep_ns % kNsPerSecond};
    if (::ppoll(polled.data(), buses.size(), &sleep, nullptr) > 0) {
      for (std::size_t i = 0; i < buses.size(); ++i) {
        if ((polled[i].revents & POLLIN) != 0) return true;
        if (polled[i].revents != 0) buses[i]->take_socket_error();
      }
    }
    if (now_ns >= deadline_monotonic_ns) return false;
  }
}

void SocketBus::note_link_error() noexcept {
  ++report_.link_down;
  report_.is_up = false;
}

// An error that stays on the socket would make every poll return at once.
void SocketBus::take_socket_error() noexcept {
  int error = 0;
  socklen_t size = sizeof error;
  ::getsockopt(receive_socket(), SOL_SOCKET, SO_ERROR, &error, &size);
  if (error != 0) note_link_error();
}

void SocketBus::look_for_link(std::int64_t now_ns) noexcept {
  if (now_ns < next_look_ns_) return;
  next_look_ns_ = now_ns + kLookForLinkEveryNs;
  report_.is_up = restore_link();
}

void SocketBus::look_for_link_if_down() noexcept {
  if (!report_.is_up) look_for_link(monotonic_now_ns());
}

}  // namespace surefoot::host
