// The capture reflex on both plants: loads off the thesis' grid, drawn once at random, not chosen.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/closed_loop/run_scenario.hpp"

namespace surefoot::run {
namespace {

using testing::run_scenario;
using testing::time_of;

struct Load {
  const char* name;
  const char* mass_kg;
  const char* at_s;
  const char* position_m;
  const char* plant;
  std::vector<std::string> also = {};
};

void PrintTo(const Load& load, std::ostream* stream) { *stream << load.name; }

std::vector<std::string> overrides_for(const char* method, const Load& load) {
  std::vector<std::string> overrides{std::string("plant=") + load.plant,
                                     std::string("reflex.method=") + method,
                                     std::string("payload.0.mass_kg=") + load.mass_kg,
                                     std::string("payload.0.at_s=") + load.at_s,
                                     std::string("payload.0.position_m=") + load.position_m,
                                     "duration_s=24",
                                     "limits.max_abs_pitch_deg=0"};
  overrides.insert(overrides.end(), load.also.begin(), load.also.end());
  return overrides;
}

constexpr const char* kChest = "[0.2, 0.0, 0.25]";
constexpr const char* kBack = "[-0.2, 0.0, 0.25]";
constexpr const char* kLeftSide = "[0.0, 0.25, 0.25]";
constexpr const char* kRightSide = "[0.0, -0.25, 0.25]";

class CaptureReflex : public ::testing::TestWithParam<Load> {};

TEST_P(CaptureReflex, CarriesTheLoadOn) {
  const Verdict verdict = run_scenario("main", overrides_for("capture", GetParam()));
  ASSERT_EQ(verdict.outcome, Outcome::kWalked) << verdict.reason;
  EXPECT_GE(verdict.cycles_after_recovery, 2.0);
  EXPECT_EQ(verdict.payloads_detected, 1);
  EXPECT_LT(verdict.time_at_torque_limit_percent, 1.0);
  EXPECT_EQ(verdict.unreachable_ticks, 0);
}

INSTANTIATE_TEST_SUITE_P(
    Loads, CaptureReflex,
    ::testing::Values(Load{"chest_15_kg_where_the_modified_reflex_falls", "15", "1.35", kChest, "thesis"},
                      Load{"chest_23_kg", "23.4", "3.713", kChest, "thesis"},
                      Load{"chest_18_kg_double_support", "17.9", "2.281", kChest, "thesis"},
                      Load{"chest_21_kg_early_swing", "21.2", "0.742", kChest, "thesis"},
                      Load{"chest_22_kg_nominal", "22.1", "1.087", kChest, "nominal"},
                      Load{"chest_12_kg_rough_floor", "12.3", "1.519", kChest, "thesis", {"floor.friction=0.2"}},
                      Load{"chest_16_kg_short_toe", "16.4", "3.362", kChest, "thesis", {"geometry.sole_toe_m=0.118"}},
                      Load{"back_14_kg", "14.1", "0.837", kBack, "thesis"},
                      Load{"left_12_kg", "12.7", "1.431", kLeftSide, "thesis"},
                      Load{"right_11_kg_nominal", "11.3", "2.917", kRightSide, "nominal"}),
    [](const auto& load) { return std::string(load.param.name); });

TEST(CaptureReflex, HoldsWhereTheThesisReflexFalls) {
  const Load load{"", "15", "1.35", kChest, "thesis"};
  EXPECT_EQ(run_scenario("main", overrides_for("original", load)).outcome, Outcome::kFell);
}

TEST(CaptureReflex, TakesASecondLoadDuringTheRecovery) {
  auto overrides = overrides_for("capture", {"", "10", "1.2", kChest, "thesis"});
  overrides.insert(overrides.end(), {"payload.1.mass_kg=5", "payload.1.at_s=5.2", "duration_s=34"});
  // The second load may be felt while standing, or when the walk begins: what counts is that it is carried on.
  EXPECT_EQ(run_scenario("second_payload", overrides).outcome, Outcome::kWalked);
}

}  // namespace
}  // namespace surefoot::run
