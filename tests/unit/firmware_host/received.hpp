#pragma once

#include <cstdint>
#include <ctime>
#include <span>
#include <vector>

#include "firmware/host/bus/host_bus.hpp"

namespace surefoot::host::testing {

inline std::int64_t from_now_ns(std::int64_t wait_ns) {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec + wait_ns;
}

inline constexpr std::int64_t kLongNs = 20'000'000'000;  // nothing waits as long but a test that fails

/// Waits for so many frames: a busy kernel delivers them a little after they were sent. Allocates nothing.
/// @return how many came
inline std::size_t receive_all(HostBus& bus, std::span<can::CanFrame> frames) noexcept {
  const std::int64_t give_up_ns = from_now_ns(kLongNs);
  std::size_t count = 0;
  while (count < frames.size() && bus.wait_readable(give_up_ns)) count += bus.receive(frames.subspan(count));
  return count;
}

/// Waits for so many frames, and takes those as well that came with them.
inline std::vector<can::CanFrame> received(HostBus& bus, std::size_t at_least) {
  std::vector<can::CanFrame> all(at_least);
  all.resize(receive_all(bus, all));
  std::vector<can::CanFrame> more(100);
  while (const std::size_t count = bus.receive(more)) {
    all.insert(all.end(), more.begin(), more.begin() + static_cast<std::ptrdiff_t>(count));
  }
  return all;
}

inline std::vector<std::uint16_t> identifiers(const std::vector<can::CanFrame>& frames) {
  std::vector<std::uint16_t> all;
  for (const can::CanFrame& frame : frames) all.push_back(frame.identifier);
  return all;
}

}  // namespace surefoot::host::testing
