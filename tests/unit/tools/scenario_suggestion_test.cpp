#include <gtest/gtest.h>

#include <vector>

#include "tools/scenario/suggestion.hpp"

namespace surefoot::scenario {
namespace {

TEST(EditDistance, CountsInsertionsDeletionsReplacementsAndSwaps) {
  EXPECT_EQ(edit_distance("", ""), 0U);
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
  EXPECT_EQ(edit_distance("step", "stpe"), 1U);
  EXPECT_EQ(edit_distance("mass", "mas"), 1U);
  EXPECT_EQ(edit_distance("ca", "abc"), 3U);  // optimal string alignment; unrestricted Damerau has 2
}

TEST(NearestKey, IsTheOneWithTheSmallestDistance) {
  const std::vector<std::string> known{"gait.sway_m", "gait.half_step_m", "servo.kp_nm_per_rad", "seed"};
  EXPECT_EQ(nearest_key("gait.swya_m", known), "gait.sway_m");
  EXPECT_EQ(nearest_key("half_step_m", known), "gait.half_step_m");
  EXPECT_EQ(nearest_key("reflex.half_step_m", known), "gait.half_step_m");
  EXPECT_EQ(nearest_key("servo.kp", known), "servo.kp_nm_per_rad");
  EXPECT_EQ(nearest_key("sede", known), "seed");
}

TEST(NearestKey, IsEmptyWhenNothingIsNear) {
  const std::vector<std::string> known{"gait.sway_m", "seed"};
  EXPECT_EQ(nearest_key("chocolate", known), "");
  EXPECT_EQ(nearest_key("", known), "");
  EXPECT_EQ(nearest_key(std::string(100000, 'a'), known), "");
  EXPECT_EQ(nearest_key("seed", {}), "");
}

}  // namespace
}  // namespace surefoot::scenario
