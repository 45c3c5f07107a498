#pragma once

#include <algorithm>
#include <cstdint>
#include <ctime>

namespace surefoot::bench {

/// Processor time of this thread: what other programs take does not count.
[[nodiscard]] inline double cpu_us() noexcept {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1.0e6 * static_cast<double>(time.tv_sec) + 1.0e-3 * static_cast<double>(time.tv_nsec);
}

/// Time of a call in a round of so many, the least of those rounds that fit into the time; at least two rounds.
///
/// @param seconds  of processor time
/// @param round    makes the calls and returns their time in microseconds
template <typename Round>
[[nodiscard]] double least_us(double seconds, std::int64_t calls, const Round& round) {
  const double end_us = cpu_us() + 1.0e6 * seconds;
  double least = round();
  do {
    least = std::min(least, round());
  } while (cpu_us() < end_us);
  return least / static_cast<double>(calls);
}

/// The same for one action, called again and again. Its results must go where the compiler cannot see through.
template <typename Action>
[[nodiscard]] double least_us_per_call(double seconds, const Action& action) {
  constexpr std::int64_t kCalls = 1000;
  return least_us(seconds, kCalls, [&] {
    const double start_us = cpu_us();
    for (std::int64_t i = 0; i < kCalls; ++i) action();
    return cpu_us() - start_us;
  });
}

/// Keeps a result alive that nobody reads.
template <typename Value>
inline void keep(const Value& value) noexcept {
  asm volatile("" : : "g"(&value) : "memory");
}

}  // namespace surefoot::bench
