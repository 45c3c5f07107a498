#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tools/table/grid.hpp"

namespace surefoot::table {
namespace {

// A sum of floating-point steps would give 0.30000000000000004, and no reference cell would be found.
TEST(ListOfNumbers, TakesARangeWhoseElementsAreTheDecimalsThatOneWouldType) {
  const std::vector<double> times_s = parse_list("0.1:4.8:0.1");
  ASSERT_EQ(times_s.size(), 48U);
  EXPECT_EQ(times_s[2], 0.3);
  EXPECT_EQ(times_s[28], 2.9);
  EXPECT_EQ(times_s.back(), 4.8);
}

TEST(ListOfNumbers, IsSortedAndHoldsEachNumberOnce) {
  EXPECT_EQ(parse_list("15,2.5,5,10:15:5"), (std::vector<double>{2.5, 5.0, 10.0, 15.0}));
}

TEST(ListOfNumbers, LeavesOutARangesLastNumberThatTheStepMisses) {
  EXPECT_EQ(parse_list("1:2:0.4"), (std::vector<double>{1.0, 1.4, 1.8}));
}

TEST(ListOfNumbers, RefusesWhatIsNone) {
  for (const char* text : {"", ",", "1,", "a", "1:2", "1:2:3:4", "1:2:0", "1:2:-1", "2:1:1", "nan", "inf", "0:1:1e-9",
                           "1 ", "0x10", "1e999"}) {
    EXPECT_THROW(static_cast<void>(parse_list(text)), BadList) << text;
  }
}

TEST(Bounds, TakesTwoNumbersTheSecondAboveTheFirst) {
  EXPECT_EQ(parse_bounds("1:20").low, 1.0);
  EXPECT_EQ(parse_bounds("1:20").high, 20.0);
  for (const char* text : {"", "1", "1:1", "2:1", "1:2:3", "a:b", "1:nan"}) {
    EXPECT_THROW(static_cast<void>(parse_bounds(text)), BadList) << text;
  }
}

TEST(ThesisGrid, HasFortyEightInstantsAndSixLoadsRowByRow) {
  const Grid grid = thesis_grid();
  EXPECT_EQ(grid.size(), 288U);
  const std::vector<Load> loads = loads_of(grid);
  ASSERT_EQ(loads.size(), 288U);
  EXPECT_EQ(loads[grid.index(11, 1)].at_s, 1.2);
  EXPECT_EQ(loads[grid.index(11, 1)].mass_kg, 5.0);
}

}  // namespace
}  // namespace surefoot::table
