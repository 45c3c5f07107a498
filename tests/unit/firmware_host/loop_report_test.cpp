#include "firmware/host/realtime/loop_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace surefoot::host {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TickHistogram histogram_of(std::int64_t first_us, std::int64_t last_us) {
  TickHistogram histogram;
  for (std::int64_t us = first_us; us <= last_us; ++us) histogram.add(us * 1000);
  return histogram;
}

TEST(LoopReport, TakesEachFigureFromItsOwnSource) {
  PeriodGrid grid(0, 1000, {.degrade_after_missed_ticks = 3, .window_ticks = 10});
  grid.advance(3500);
  const ResourceUsage usage{1, 2, 3, 4};
  const LoopReport report =
      report_of(42, grid, histogram_of(1, 100), histogram_of(101, 300), histogram_of(301, 600), usage);
  EXPECT_EQ(report.ticks, 42);
  EXPECT_EQ(report.wake_up.count, 100U);
  EXPECT_DOUBLE_EQ(report.wake_up.max_us, 100.0);
  EXPECT_NEAR(report.compute.p50_us, 200.0, 200.0 / 128.0);
  EXPECT_DOUBLE_EQ(report.frame.max_us, 600.0);
  EXPECT_EQ(report.overruns, 1);
  EXPECT_EQ(report.missed_ticks, 3);
  EXPECT_TRUE(report.is_degraded);
  EXPECT_EQ(report.usage, usage);
}

TEST(LoopReport, ShowsPeopleATable) {
  LoopReport report;
  report.ticks = 60'000;
  report.wake_up = {59'990, 14.25, 47.0, 8123.5};
  report.compute = {59'990, 55.0, 80.0, 120.0};
  report.overruns = 2;
  report.missed_ticks = 10;
  report.usage = {0, 0, 60'001, 3};
  EXPECT_EQ(to_text(report),
            "  us                  p50      p99.9        max      count\n"
            "  wake-up            14.2       47.0     8123.5      59990\n"
            "  compute            55.0       80.0      120.0      59990\n"
            "  ticks        60000 ran, 2 overran, 10 missed\n"
            "  page faults  0 minor, 0 major\n"
            "  switches     60001 voluntary, 3 involuntary\n");
}

TEST(LoopReport, SaysThatItDegradedAndWhatFramesTookWhereTheyWereMeasured) {
  LoopReport report;
  EXPECT_THAT(to_text(report), Not(HasSubstr("degraded")));
  EXPECT_THAT(to_text(report), Not(HasSubstr("frame")));
  report.is_degraded = true;
  report.frame.count = 1;
  EXPECT_THAT(to_text(report), HasSubstr("missed: degraded\n"));
  EXPECT_THAT(to_text(report), HasSubstr("\n  frame  "));
}

}  // namespace
}  // namespace surefoot::host
