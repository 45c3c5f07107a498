#include "firmware/host/spsc_ring.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <thread>
#include <vector>

namespace surefoot::host {
namespace {

TEST(SpscRing, RefusesACapacityThatIsNoPowerOfTwo) {
  EXPECT_THROW(SpscRing<int>(0), std::invalid_argument);
  EXPECT_THROW(SpscRing<int>(12), std::invalid_argument);
  EXPECT_EQ(SpscRing<int>(16).capacity(), 16U);
}

TEST(SpscRing, FullRingRefusesWithoutTouchingWhatWaitsAndCountsEachDrop) {
  SpscRing<int> ring(4);
  for (int i = 0; i < 7; ++i) EXPECT_EQ(ring.produce([&](int& slot) { slot = i; }), i < 4);
  EXPECT_EQ(ring.drops(), 3U);
  EXPECT_EQ(ring.room(), 0U);
  std::vector<int> taken;
  EXPECT_EQ(ring.consume([&](int slot) { taken.push_back(slot); }, 3), 3U);
  EXPECT_EQ(taken, (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(ring.room(), 3U);
  EXPECT_TRUE(ring.produce([](int& slot) { slot = 9; }));
  ring.consume([&](int slot) { taken.push_back(slot); }, 100);
  EXPECT_EQ(taken, (std::vector<int>{0, 1, 2, 3, 9}));
  EXPECT_EQ(ring.drops(), 3U);
}

TEST(SpscRing, BetweenTwoThreadsNothingIsTornReorderedOrLostUncounted) {
  constexpr std::uint64_t kPushes = 200'000;
  using Wide = std::array<std::uint64_t, 6>;  // torn or early reads show as unequal words
  SpscRing<Wide> ring(8);
  std::thread producer([&] {
    for (std::uint64_t i = 1; i <= kPushes; ++i) ring.produce([i](Wide& slot) { slot.fill(i); });
    while (!ring.produce([&](Wide& slot) { slot.fill(kPushes + 1); })) std::this_thread::yield();
  });
  std::uint64_t last = 0;
  std::uint64_t taken = 0;
  std::uint64_t broken = 0;
  while (last != kPushes + 1) {
    taken += ring.consume(
        [&](const Wide& slot) {
          for (const std::uint64_t word : slot) broken += word != slot[0] ? 1U : 0U;
          broken += slot[0] <= last ? 1U : 0U;
          last = slot[0];
        },
        5);
  }
  producer.join();
  EXPECT_EQ(broken, 0U);
  // The closing push may have been refused, and so counted, several times.
  EXPECT_GE(taken + ring.drops(), kPushes + 1);
  EXPECT_LE(taken, kPushes + 1);
}

}  // namespace
}  // namespace surefoot::host
