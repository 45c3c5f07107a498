// A whole walk over the bus model: nothing that was seen may pass what the analysis allows.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/closed_loop/run_scenario.hpp"

namespace surefoot {
namespace {

struct Case {
  const char* name;
  std::vector<std::string> overrides;
};

class WalkingBus : public ::testing::TestWithParam<Case> {};

TEST_P(WalkingBus, NoFrameTakesLongerThanTheWorstCase) {
  const run::Verdict verdict = testing::run_scenario("main", GetParam().overrides);
  ASSERT_FALSE(verdict.bus.empty());
  for (const run::BusTraffic& bus : verdict.bus) {
    EXPECT_GT(bus.load_percent, 10.0);
    EXPECT_LE(bus.load_percent, verdict.bus_load_percent);
    for (const run::StreamTiming& stream : bus.streams) {
      ASSERT_TRUE(stream.worst_case_us.has_value()) << stream.name;
      EXPECT_LE(stream.observed_us, *stream.worst_case_us) << stream.name;
    }
  }
}

// The bus model watches; it does not touch the robot.
TEST(BusModel, DoesNotChangeTheWalk) {
  const run::Verdict one = testing::run_scenario("main");
  const run::Verdict two = testing::run_scenario("main", {"bus.count=2", "bus.data_bit_rate_hz=8e6"});
  EXPECT_EQ(one.frames_sent, two.frames_sent);
  EXPECT_EQ(one.torso_pitch_deg.max, two.torso_pitch_deg.max);
  EXPECT_LT(two.bus_load_percent, one.bus_load_percent);
}

INSTANTIATE_TEST_SUITE_P(Buses, WalkingBus,
                         ::testing::Values(Case{"one", {}}, Case{"two", {"bus.count=2"}},
                                           Case{"one_with_jitter",
                                                {"bus.node_latency_s=20e-6", "bus.node_jitter_s=150e-6"}},
                                           Case{"two_with_jitter", {"bus.count=2", "bus.node_jitter_s=300e-6"}},
                                           Case{"one_fast", {"bus.data_bit_rate_hz=8e6", "bus.compute_s=0"}}),
                         [](const auto& test_case) { return test_case.param.name; });

}  // namespace
}  // namespace surefoot
