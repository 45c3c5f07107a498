#include "firmware/host/tick_histogram.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace surefoot::host {
namespace {

TEST(TickHistogram, IsAllZeroWhileEmpty) {
  const TickHistogram histogram;
  EXPECT_EQ(histogram.count(), 0U);
  EXPECT_EQ(histogram.mean_us(), 0.0);
  EXPECT_EQ(histogram.p50_us(), 0.0);
  EXPECT_EQ(histogram.p999_us(), 0.0);
  EXPECT_EQ(histogram.max_us(), 0.0);
}

// 1 to 1000 microseconds: by nearest rank the median is 500 and the 99.9 percentile 999.
TEST(TickHistogram, GivesNearestRankPercentilesToOnePartIn128AndTheMaximumExactly) {
  TickHistogram histogram;
  for (int us = 1000; us >= 1; --us) histogram.add(us * 1000);
  EXPECT_EQ(histogram.count(), 1000U);
  EXPECT_GE(histogram.p50_us(), 500.0);
  EXPECT_LE(histogram.p50_us(), 500.0 * (1.0 + 1.0 / 128.0));
  EXPECT_GE(histogram.p999_us(), 999.0);
  EXPECT_LE(histogram.p999_us(), 1000.0);
  EXPECT_DOUBLE_EQ(histogram.max_us(), 1000.0);
  EXPECT_DOUBLE_EQ(histogram.mean_us(), 500.5);
}

TEST(TickHistogram, OneOutlierInAThousandIsTheMaximumAndNotTheMedian) {
  TickHistogram histogram;
  for (int i = 0; i < 999; ++i) histogram.add(100);
  histogram.add(5'000'000);
  EXPECT_DOUBLE_EQ(histogram.p50_us(), 0.1);
  EXPECT_DOUBLE_EQ(histogram.p999_us(), 0.1);
  EXPECT_DOUBLE_EQ(histogram.percentile_us(1.0), 5000.0);
}

TEST(TickHistogram, BinsJoinAndCountEveryDurationOnce) {
  TickHistogram histogram;
  for (const std::int64_t ns : {0, 31, 32, 127, 128, 159, 160, 5000, 5001}) histogram.add(ns);
  const TickHistogram::Bins bins = histogram.bins();
  EXPECT_EQ(bins[0], 2U);  // 0 to 31 ns
  EXPECT_EQ(bins[1], 1U);
  EXPECT_EQ(bins[3], 1U);  // 96 to 127 ns
  EXPECT_EQ(bins[4], 2U);  // 128 to 159 ns
  EXPECT_EQ(bins[5], 1U);
  std::uint64_t sum = 0;
  for (std::size_t bin = 0; bin < bins.size(); ++bin) {
    sum += bins[bin];
    EXPECT_LT(TickHistogram::bin_begin_us(bin), TickHistogram::bin_begin_us(bin + 1));
    if (bins[bin] == 2 && bin > 4) {
      EXPECT_LE(TickHistogram::bin_begin_us(bin), 5.0);
      EXPECT_GT(TickHistogram::bin_begin_us(bin + 1), 5.001);
    }
  }
  EXPECT_EQ(sum, histogram.count());
  EXPECT_DOUBLE_EQ(TickHistogram::bin_begin_us(5), 0.160);
}

TEST(TickHistogram, CountsImpossibleDurationsAtItsEnds) {
  TickHistogram histogram;
  histogram.add(std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(histogram.max_us(), 0.0);
  histogram.add(std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(histogram.count(), 2U);
  EXPECT_DOUBLE_EQ(histogram.max_us(), 1.0e-3 * static_cast<double>(TickHistogram::kLargestNs));
  EXPECT_EQ(histogram.percentile_us(1.0), histogram.max_us());
}

}  // namespace
}  // namespace surefoot::host
