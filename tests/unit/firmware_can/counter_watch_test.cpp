#include "firmware/can/counter_watch.hpp"

#include <gtest/gtest.h>

namespace surefoot::can {
namespace {

TEST(CounterWatch, TakesAnyFirstCounterAndCountsNothingLost) {
  for (const int first : {0, 1, 128, 255}) {
    CounterWatch watch;
    EXPECT_EQ(watch.step(static_cast<std::uint8_t>(first)), Rejection::kNone);
    EXPECT_EQ(watch.lost(), 0U);
  }
}

TEST(CounterWatch, LosesNothingOverAThousandFramesInARow) {
  CounterWatch watch;
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(watch.step(static_cast<std::uint8_t>(i)), Rejection::kNone);
  EXPECT_EQ(watch.lost(), 0U);
}

TEST(CounterWatch, RefusesACounterThatStandsStill) {
  CounterWatch watch;
  ASSERT_EQ(watch.step(0), Rejection::kNone);
  EXPECT_EQ(watch.step(0), Rejection::kRepeated);
  EXPECT_EQ(watch.step(0), Rejection::kRepeated);
  EXPECT_EQ(watch.step(1), Rejection::kNone);
  EXPECT_EQ(watch.lost(), 0U);
}

TEST(CounterWatch, CountsGapsAlsoAcrossTheWrapAround) {
  CounterWatch watch;
  ASSERT_EQ(watch.step(250), Rejection::kNone);
  EXPECT_EQ(watch.step(253), Rejection::kNone);  // 251 and 252 are missing
  EXPECT_EQ(watch.lost(), 2U);
  EXPECT_EQ(watch.step(2), Rejection::kNone);  // 254, 255, 0 and 1 are missing
  EXPECT_EQ(watch.lost(), 6U);
  EXPECT_EQ(watch.step(3), Rejection::kNone);
  EXPECT_EQ(watch.lost(), 6U);
}

}  // namespace
}  // namespace surefoot::can
