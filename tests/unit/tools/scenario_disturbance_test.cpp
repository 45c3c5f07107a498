#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/tools/scenario_testing.hpp"

namespace surefoot::scenario {
namespace {

using testing::HasSubstr;

TEST(ScenarioDisturbance, EveryKeyArrives) {
  const Scenario scenario = load_text("walk.toml",
                                      "[floor]\nslope_pitch_deg = -3\nslope_roll_deg = 1.5\n"
                                      "[[payload]]\nat_s = 2\nremoved_at_s = 7.5\n"
                                      "[[push]]\nat_s = 4\nduration_s = 0.2\nforce_n = [10, -20, 30]\n"
                                      "point_body_m = [0.1, -0.2, 0.3]\n");
  EXPECT_EQ(scenario.sim.contact.slope_pitch_deg, -3.0);
  EXPECT_EQ(scenario.sim.contact.slope_roll_deg, 1.5);
  EXPECT_EQ(scenario.sim.payloads.at(0).removed_at_s, 7.5);
  const sim_hw::PushConfig& push = scenario.sim.pushes.at(0);
  EXPECT_EQ(push.at_s, 4.0);
  EXPECT_EQ(push.duration_s, 0.2);
  EXPECT_EQ(push.force_n, (std::array{10.0, -20.0, 30.0}));
  EXPECT_EQ(push.point_body_m, (std::array{0.1, -0.2, 0.3}));
}

TEST(ScenarioDisturbance, WithoutTheirKeysTheFloorIsLevelLoadsStayAndNobodyPushes) {
  const Scenario scenario = load_default();
  EXPECT_EQ(scenario.sim.contact.slope_pitch_deg, 0.0);
  EXPECT_EQ(scenario.sim.contact.slope_roll_deg, 0.0);
  EXPECT_EQ(scenario.sim.payloads.at(0).removed_at_s, sim_hw::kNever_s);
  EXPECT_TRUE(scenario.sim.pushes.empty());
  EXPECT_EQ(load_text("w", "[[push]]").sim.pushes.at(0).point_body_m, (std::array{0.0, 0.0, 0.25}));
}

// "inf" goes through the effective scenario, a file and the command line alike.
TEST(ScenarioDisturbance, NeverIsWrittenAsInf) {
  EXPECT_THAT(to_toml(load_default()), HasSubstr("\nremoved_at_s = inf  #"));
  const std::string text = "[[payload]]\nremoved_at_s = 7\n";
  EXPECT_EQ(load_text("w", text, std::vector<std::string>{"payload.0.removed_at_s=inf"}).sim.payloads[0].removed_at_s,
            sim_hw::kNever_s);
  EXPECT_EQ(load_default(std::vector<std::string>{"payload.0.removed_at_s=9"}).sim.payloads[0].removed_at_s, 9.0);
}

TEST(ScenarioDisturbance, PushesKeepTheOrderOfTheFileAndAreSetFromTheCommandLine) {
  const Scenario scenario = load_text("w", "[[push]]\nat_s = 9\n[[push]]\nat_s = 3\n");
  EXPECT_EQ(scenario.sim.pushes.at(0).at_s, 9.0);
  const std::vector<std::string> set{"push.0.force_n=[0, 200, 0]", "push.0.at_s=2"};
  EXPECT_EQ(load_default(set).sim.pushes.at(0).force_n[1], 200.0);
  EXPECT_TRUE(load_text("w", "[[push]]", std::vector<std::string>{"push=[]"}).sim.pushes.empty());
}

TEST(ScenarioDisturbance, TooManyPushesAreRefused) {
  std::string text;
  for (std::size_t i = 0; i < sim_hw::kMaxPushes; ++i) text += "[[push]]\n";
  EXPECT_EQ(load_text("w", text).sim.pushes.size(), sim_hw::kMaxPushes);
  EXPECT_THAT(refusal_of(text + "[[push]]\n"), HasSubstr("push has 17 tables; expected at most 16"));
}

struct BadDisturbance {
  const char* text;
  const char* message;  ///< begins with the place
};

void PrintTo(const BadDisturbance& bad, std::ostream* stream) { *stream << on_one_line(bad.text); }

class RefusedDisturbance : public testing::TestWithParam<BadDisturbance> {};

TEST_P(RefusedDisturbance, NamesFileLineColumnKeyExpectationAndRemedy) {
  const std::string message = refusal_of(GetParam().text);
  EXPECT_THAT(message, testing::StartsWith(GetParam().message));
  EXPECT_THAT(message, HasSubstr("\n  remedy: "));
}

INSTANTIATE_TEST_SUITE_P(
    Table, RefusedDisturbance,
    testing::Values(
        BadDisturbance{"[[payload]]\nat_s = 3\nremoved_at_s = 2",
                       "walk.toml:3:16: payload[0].removed_at_s is 2; expected later than payload[0].at_s = 3 s"},
        BadDisturbance{"[[payload]]\nremoved_at_s = 1.2", "walk.toml:2:16: payload[0].removed_at_s is 1.2; expected"},
        BadDisturbance{"[[payload]]\n[[payload]]\nat_s = 9\nremoved_at_s = 8",
                       "walk.toml:4:16: payload[1].removed_at_s is 8; expected later than payload[1].at_s = 9 s"},
        BadDisturbance{"[[payload]]\nremoved_at_s = nan",
                       "walk.toml:2:16: payload[0].removed_at_s is nan; expected 0 to 3600 s, or inf for never"},
        BadDisturbance{"[[payload]]\nremoved_at_s = -inf",
                       "walk.toml:2:16: payload[0].removed_at_s is -inf; expected 0 to 3600 s, or inf for never"},
        BadDisturbance{
            "[[payload]]\nremoved_at_s = \"never\"",
            "walk.toml:2:16: payload[0].removed_at_s is the string \"never\"; expected a number, 0 to 3600 s, "
            "or inf for never"},
        BadDisturbance{"[[payload]]\nat_s = inf", "walk.toml:2:8: payload[0].at_s is inf; expected 0 to 3600 s\n"},
        BadDisturbance{"[[push]]\nduration_s = 0", "walk.toml:2:14: push[0].duration_s is 0; expected more than 0"},
        BadDisturbance{"[[push]]\nduration_s = inf", "walk.toml:2:14: push[0].duration_s is inf; expected more than 0"},
        BadDisturbance{"[[push]]\nforce_n = [1, 2]",
                       "walk.toml:2:11: push[0].force_n is an array of 2; expected an array of 3 numbers"},
        BadDisturbance{"[[push]]\nforce_n = [0, nan, 0]", "walk.toml:2:15: push[0].force_n[1] is nan; expected"},
        BadDisturbance{"[[push]]\nforce_n = [1e6, 0, 0]", "walk.toml:2:12: push[0].force_n[0] is 1000000.0; expected"},
        BadDisturbance{"[[push]]\npoint_body_m = [0, 0, 2]",
                       "walk.toml:2:23: push[0].point_body_m[2] is 2; expected -1 to 1 m"},
        BadDisturbance{"[[push]]\nforce = [1, 2, 3]",
                       "walk.toml:2:1: push[0].force is unknown; did you mean push[0].force_n?"},
        BadDisturbance{"[push]\nat_s = 3", "walk.toml:1:1: push is a table; expected an array of tables"},
        BadDisturbance{"[floor]\nslope_pitch_deg = 15.5",
                       "walk.toml:2:19: floor.slope_pitch_deg is 15.5; expected -15 to 15 deg"},
        BadDisturbance{"[floor]\nslope_roll_deg = nan", "walk.toml:2:18: floor.slope_roll_deg is nan; expected"}));

}  // namespace
}  // namespace surefoot::scenario
