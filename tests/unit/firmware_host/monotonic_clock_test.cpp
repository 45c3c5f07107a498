#include "firmware/host/realtime/monotonic_clock.hpp"

#include <gtest/gtest.h>
#include <pthread.h>
#include <sys/resource.h>

#include <csignal>
#include <limits>
#include <thread>

namespace surefoot::host {
namespace {

constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();
std::atomic<bool> stop_from_handler{false};
std::atomic<int> handled{0};

void count_signal(int) { ++handled; }
void count_and_stop(int) {
  stop_from_handler = true;
  ++handled;
}

/// Sends signals to the thread that waits until one of them has been handled `wanted` times.
void interrupt(pthread_t thread, int wanted) {
  while (handled < wanted) {
    pthread_kill(thread, SIGUSR1);
    std::this_thread::yield();
  }
}

TEST(MonotonicClock, NeverReturnsBeforeTheInstant) {
  const std::atomic<bool> stop{false};
  const MonotonicClock clock(stop);
  for (const std::int64_t ahead_ns : {1, 999, 50'000, 2'000'000}) {
    const std::int64_t instant_ns = MonotonicClock::now_ns() + ahead_ns;
    EXPECT_TRUE(clock.sleep_until_ns(instant_ns));
    EXPECT_GE(MonotonicClock::now_ns(), instant_ns);
  }
}

TEST(MonotonicClock, AnInstantThatHasPassedIsNotWaitedFor) {
  const std::atomic<bool> stop{false};
  const MonotonicClock clock(stop);
  EXPECT_TRUE(clock.sleep_until_ns(MonotonicClock::now_ns() - 1));
  EXPECT_TRUE(clock.sleep_until_ns(0));
  EXPECT_TRUE(clock.sleep_until_ns(std::numeric_limits<std::int64_t>::min()));
}

TEST(MonotonicClock, DoesNotBeginToWaitOnceStopped) {
  const std::atomic<bool> stop{true};
  EXPECT_FALSE(MonotonicClock(stop).sleep_until_ns(kNever));
}

TEST(MonotonicClock, ASignalThatStopsEndsTheWait) {
  handled = 0;
  stop_from_handler = false;
  std::signal(SIGUSR1, count_and_stop);
  const pthread_t waiting = pthread_self();
  // Signals again and again: one that arrives before the wait begins ends it as well.
  std::jthread sender([&](const std::stop_token& done) {
    while (!done.stop_requested()) {
      pthread_kill(waiting, SIGUSR1);
      std::this_thread::yield();
    }
  });
  EXPECT_FALSE(MonotonicClock(stop_from_handler).sleep_until_ns(kNever));
  EXPECT_GE(handled, 1);
}

// A relative sleep that began anew after each signal, or one that gave up, would show here.
TEST(MonotonicClock, OtherSignalsDoNotShortenTheWait) {
  handled = 0;
  std::signal(SIGUSR1, count_signal);
  const std::atomic<bool> stop{false};
  const pthread_t waiting = pthread_self();
  std::jthread sender([waiting] { interrupt(waiting, 20); });
  const std::int64_t instant_ns = MonotonicClock::now_ns() + 5'000'000;
  EXPECT_TRUE(MonotonicClock(stop).sleep_until_ns(instant_ns));
  EXPECT_GE(MonotonicClock::now_ns(), instant_ns);
}

}  // namespace
}  // namespace surefoot::host
