#include "firmware/host/realtime/monotonic_clock.hpp"

#include <cerrno>
#include <ctime>

namespace surefoot::host {
namespace {

constexpr std::int64_t kNsPerS = 1'000'000'000;

}  // namespace

std::int64_t MonotonicClock::now_ns() noexcept {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec * kNsPerS + now.tv_nsec;
}

bool MonotonicClock::sleep_until_ns(std::int64_t instant_ns) const noexcept {
  if (instant_ns < 0) instant_ns = 0;  // before the machine's start: passed, and no negative timespec
  const timespec instant{.tv_sec = instant_ns / kNsPerS, .tv_nsec = instant_ns % kNsPerS};
  // Absolute, so that being interrupted, or late, does not add up.
  while (!stop_.load(std::memory_order_relaxed)) {
    if (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &instant, nullptr) != EINTR) {
      return !stop_.load(std::memory_order_relaxed);
    }
  }
  return false;
}

}  // namespace surefoot::host
