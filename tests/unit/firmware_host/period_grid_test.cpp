#include "firmware/host/realtime/period_grid.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace surefoot::host {
namespace {

constexpr std::int64_t kMs = 1'000'000;

/// A grid that misses `missed` ticks with the tick that it is at.
void overrun(PeriodGrid& grid, std::int64_t missed) { grid.advance(grid.due_ns() + missed * kMs + 1); }

TEST(PeriodGrid, BeginsWithTickZeroAtItsStart) {
  const PeriodGrid grid(7 * kMs, kMs);
  EXPECT_EQ(grid.tick(), 0);
  EXPECT_EQ(grid.due_ns(), 7 * kMs);
}

TEST(PeriodGrid, ATickThatEndsInTimeIsFollowedByTheNext) {
  PeriodGrid grid(0, kMs);
  const Wake wake = grid.advance(kMs - 1);
  EXPECT_EQ(wake.tick, 1);
  EXPECT_EQ(wake.due_ns, kMs);
  EXPECT_EQ(wake.missed, 0);
  EXPECT_EQ(grid.overruns(), 0);
}

// The boundary decides whether a loop that uses its whole period runs at full or at half rate.
TEST(PeriodGrid, EndingExactlyWhenTheNextTickIsDueIsInTimeAndOneNanosecondLaterIsNot) {
  PeriodGrid in_time(0, kMs);
  EXPECT_EQ(in_time.advance(kMs).tick, 1);
  EXPECT_EQ(in_time.overruns(), 0);
  PeriodGrid late(0, kMs);
  const Wake wake = late.advance(kMs + 1);
  EXPECT_EQ(wake.tick, 2);
  EXPECT_EQ(wake.missed, 1);
  EXPECT_EQ(late.overruns(), 1);
}

TEST(PeriodGrid, AStallOfEightMillisecondsCostsItsTicksAndKeepsThePhase) {
  PeriodGrid grid(500, kMs);
  const Wake wake = grid.advance(500 + 8 * kMs + 300'000);
  EXPECT_EQ(wake.tick, 9);
  EXPECT_EQ(wake.due_ns, 500 + 9 * kMs);
  EXPECT_EQ(wake.missed, 8);
  EXPECT_EQ(grid.overruns(), 1);
  EXPECT_EQ(grid.missed_ticks(), 8);
}

TEST(PeriodGrid, IsExactAfterAYearOfTicksThatDoNotDivideASecond) {
  constexpr std::int64_t kPeriodNs = 333'333;
  constexpr std::int64_t kYearNs = 31'557'600'000'000'000;
  PeriodGrid grid(11, kPeriodNs);
  const Wake wake = grid.advance(11 + kYearNs);
  EXPECT_EQ(wake.tick, kYearNs / kPeriodNs + 1);
  EXPECT_EQ(wake.due_ns, 11 + wake.tick * kPeriodNs);
}

TEST(PeriodGrid, IsDegradedByExactlyThePolicysNumberOfMissedTicks) {
  PeriodGrid grid(0, kMs, {.degrade_after_missed_ticks = 5, .window_ticks = 100});
  overrun(grid, 4);
  EXPECT_FALSE(grid.is_degraded());
  overrun(grid, 1);
  EXPECT_TRUE(grid.is_degraded());
}

// Missed are ticks 1 and then 10 or 11: 10 ticks from the first to the last are a window, 11 are not.
TEST(PeriodGrid, MissedTicksCountWithinTheirWindowOnly) {
  const OverrunPolicy policy{.degrade_after_missed_ticks = 2, .window_ticks = 10};
  for (const int good_ticks : {7, 8}) {
    PeriodGrid grid(0, kMs, policy);
    overrun(grid, 1);
    for (int i = 0; i < good_ticks; ++i) grid.advance(grid.due_ns());
    overrun(grid, 1);
    EXPECT_EQ(grid.missed_ticks(), 2);
    EXPECT_EQ(grid.is_degraded(), good_ticks == 7) << good_ticks;
  }
}

TEST(PeriodGrid, StaysDegradedHoweverWellItGoesOn) {
  PeriodGrid grid(0, kMs, {.degrade_after_missed_ticks = 3, .window_ticks = 10});
  overrun(grid, 300);
  for (int i = 0; i < 1000; ++i) grid.advance(grid.due_ns());
  EXPECT_TRUE(grid.is_degraded());
}

TEST(PeriodGrid, IsNeverDegradedWithoutAPolicy) {
  PeriodGrid grid(0, kMs, {.degrade_after_missed_ticks = 0, .window_ticks = 10});
  for (int i = 0; i < 100; ++i) overrun(grid, 100);
  EXPECT_FALSE(grid.is_degraded());
}

TEST(PeriodGrid, RefusesPeriodsAndPoliciesThatMeanNothing) {
  EXPECT_THROW(PeriodGrid(0, 0), std::invalid_argument);
  EXPECT_THROW(PeriodGrid(0, -1), std::invalid_argument);
  EXPECT_THROW(PeriodGrid(0, kMs, {.degrade_after_missed_ticks = -1}), std::invalid_argument);
  EXPECT_THROW(PeriodGrid(0, kMs, {.degrade_after_missed_ticks = OverrunPolicy::kMostMissedTicks + 1}),
               std::invalid_argument);
  EXPECT_THROW(PeriodGrid(0, kMs, {.degrade_after_missed_ticks = 5, .window_ticks = 4}), std::invalid_argument);
  EXPECT_NO_THROW(PeriodGrid(0, kMs, {.degrade_after_missed_ticks = 5, .window_ticks = 5}));
}

}  // namespace
}  // namespace surefoot::host
