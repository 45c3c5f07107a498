#include "firmware/host/realtime/silence_watch.hpp"

#include <gtest/gtest.h>

namespace surefoot::host {
namespace {

constexpr std::int64_t kMs = 1'000'000;

TEST(SilenceWatch, CountsEachLookThatHeardNothing) {
  SilenceWatch watch(150 * kMs);
  watch.restart(1000 * kMs);
  EXPECT_EQ(watch.look(1100 * kMs), 100 * kMs);
  EXPECT_EQ(watch.look(1120 * kMs), 120 * kMs);
  EXPECT_EQ(watch.look(1120 * kMs), 120 * kMs);
}

TEST(SilenceWatch, CountsOneSliceOfATimeInWhichNobodyRan) {
  SilenceWatch watch(150 * kMs);
  watch.restart(0);
  EXPECT_EQ(watch.look(5000 * kMs), 150 * kMs);
  EXPECT_EQ(watch.look(5010 * kMs), 160 * kMs);
}

TEST(SilenceWatch, BeginsAnewWhenTheOtherSideSpeaks) {
  SilenceWatch watch(150 * kMs);
  watch.restart(0);
  static_cast<void>(watch.look(100 * kMs));
  watch.restart(120 * kMs);
  EXPECT_EQ(watch.look(130 * kMs), 10 * kMs);
}

}  // namespace
}  // namespace surefoot::host
