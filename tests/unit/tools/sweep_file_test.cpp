#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tools/batch/load_trial.hpp"
#include "tools/sweep/draw.hpp"
#include "tools/sweep/sweep.hpp"

namespace surefoot::sweep {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string refusal(const std::string& text) {
  try {
    static_cast<void>(load_text("s.toml", text));
  } catch (const scenario::ScenarioError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(SweepFile, RowsAreEveryDrawWithEveryCombinationWithEveryListRow) {
  const Sweep sweep = load_text("dir/s.toml", R"(
scenario = "../a.toml"
draws = 2
[set]
limits.max_abs_pitch_deg = 0
[grid]
reflex.method = ["off", "original"]
floor.friction = [1, 0.5]
[list]
payload.0.mass_kg = [5, 10]
payload.0.at_s = [1.2, 3.6]
[random]
seed = {min = 1, max = 1000}
)");
  EXPECT_EQ(sweep.name, "s");
  EXPECT_EQ(sweep.batch.scenario_file, "a.toml");
  EXPECT_THAT(sweep.batch.common, ElementsAre("limits.max_abs_pitch_deg=0.0"));
  EXPECT_THAT(sweep.keys,
              ElementsAre("reflex.method", "floor.friction", "payload.0.mass_kg", "payload.0.at_s", "seed"));
  ASSERT_EQ(sweep.values.size(), 2U * 2U * 2U * 2U);
  const std::string& seed = sweep.values[0][4];
  EXPECT_THAT(sweep.values[0], ElementsAre("off", "1.0", "5.0", "1.2", seed));
  EXPECT_THAT(sweep.values[1], ElementsAre("off", "1.0", "10.0", "3.6", seed));
  EXPECT_THAT(sweep.values[2], ElementsAre("off", "0.5", "5.0", "1.2", seed));
  EXPECT_THAT(sweep.values[7], ElementsAre("original", "0.5", "10.0", "3.6", seed));
  EXPECT_NE(sweep.values[8][4], seed);
  EXPECT_EQ(sweep.batch.trials[7].overrides.at(1), "floor.friction=0.5");
}

TEST(SweepFile, DrawKIsTheSameHoweverManyThereAreAndWhateverElseIsDrawn) {
  const Sweep few = load_text("s.toml", "draws = 3\n[random]\nfloor.friction = {min = 0.1, max = 0.9}\n");
  const Sweep many = load_text("s.toml",
                               "draws = 50\n[random]\npayload.0.mass_kg = {min = 1, max = 9}\n"
                               "floor.friction = {min = 0.1, max = 0.9}\n");
  std::set<std::string> different;
  for (std::size_t row = 0; row < 50; ++row) different.insert(many.values[row][1]);
  for (std::size_t row = 0; row < 3; ++row) EXPECT_EQ(few.values[row][0], many.values[row][1]);
  EXPECT_EQ(different.size(), 50U);
  const Sweep other = load_text("s.toml", "draws = 3\ndraw_seed = 2\n[random]\nfloor.friction = {min=0.1,max=0.9}\n");
  EXPECT_NE(other.values[0][0], few.values[0][0]);
}

// Mean and variance of 20,000 uniform numbers in [2, 5): 3.5 and 0.75, standard error of the mean 0.0061.
TEST(Draw, IsUniform) {
  double sum = 0.0, squares = 0.0;
  for (std::uint64_t k = 0; k < 20000; ++k) {
    const double value = uniform(draw(7, "floor.friction", k), 2.0, 5.0);
    ASSERT_GE(value, 2.0);
    ASSERT_LT(value, 5.0);
    sum += value;
    squares += (value - 3.5) * (value - 3.5);
  }
  EXPECT_NEAR(sum / 20000, 3.5, 5 * 0.0061);
  EXPECT_NEAR(squares / 20000, 0.75, 0.03);
}

TEST(Draw, OfAnIntegerReachesBothEndsAndNothingBeyond) {
  std::set<std::int64_t> seen;
  for (std::uint64_t k = 0; k < 200; ++k) seen.insert(uniform_integer(draw(1, "seed", k), -1, 2));
  EXPECT_THAT(seen, ElementsAre(-1, 0, 1, 2));
  EXPECT_EQ(uniform_integer(~0ULL, INT64_MIN, INT64_MAX), INT64_MAX);
}

TEST(SweepFile, ValuesReachTheScenarioToTheLastBit) {
  const Sweep sweep = load_text("s.toml",
                                "[list]\nfloor.friction = [0.1234567890123456789]\n"
                                "payload.0.position_m = [[0.2, -0.1, 0.30000000000000004]]\n"
                                "fault = [[{kind = \"dead_node\", target = \"foot_left\", at_s = 3}]]\n");
  const scenario::Scenario scenario = batch::load_trial(sweep.batch, 0).scenario;
  EXPECT_EQ(scenario.sim.contact.friction, 0.1234567890123456789);
  EXPECT_EQ(scenario.sim.payloads.at(0).position_m[2], 0.30000000000000004);
  EXPECT_EQ(scenario.sim.faults.at(0).at_s, 3.0);
}

TEST(SweepFile, WhatAScenarioSaysOfAValueNamesItsPlaceInTheSweep) {
  const Sweep sweep = load_text("s.toml", "[grid]\nfloor.friction = [0.5,\n  -1]\n");
  try {
    static_cast<void>(batch::load_trial(sweep.batch, 1));
    FAIL();
  } catch (const scenario::ScenarioError& error) {
    EXPECT_THAT(with_places(sweep, error).what(), StartsWith("s.toml:3:3: floor.friction is -1"));
  }
}

TEST(SweepFile, EveryMistakeIsRefusedWithLineAndKey) {
  const std::vector<std::pair<std::string, std::string>> mistakes{
      {"", "s.toml: varies nothing"},
      {"[set]\nseed = 1\n", "s.toml: varies nothing"},
      {"[grid\n", "s.toml:1:"},
      {"[grid]\nfloor.frictoin = [1]\n", "s.toml:2:7: floor.frictoin is unknown; did you mean floor.friction?"},
      {"[grid]\nfloor.friction = []\n", "s.toml:2:18: floor.friction is an empty array"},
      {"[grid]\nfloor.friction = 1\n", "s.toml:2:18: floor.friction is 1; expected an array"},
      {"[grid]\nfloor.friction = {min = 1}\n", "s.toml:2:"},
      {"[set]\nseed = 1\n[grid]\nseed = [2]\n", "s.toml:4:1: seed stands in two tables"},
      {"[list]\nseed = [1, 2]\nfloor.friction = [1]\n", "s.toml:3:19: floor.friction has 1 values, seed has 2"},
      {"[random]\nseed = {min = 1, max = 2}\n", "s.toml:2:8: [random] needs a number of draws"},
      {"draws = 3\n[grid]\nseed = [1]\n", "s.toml:1:9: draws has nothing to draw"},
      {"draws = 0\n[random]\nseed = {min = 1, max = 2}\n", "s.toml:1:9: draws is 0; expected an integer"},
      {"draws = 1e3\n[random]\nseed = {min = 1, max = 2}\n", "s.toml:1:9: draws is 1000.0; expected an integer"},
      {"draws = 2\n[random]\nseed = {min = 2, max = 1}\n", "s.toml:3:8: seed has a min above its max"},
      {"draws = 2\n[random]\nseed = {min = 1.5, max = 3}\n", "s.toml:3:8: seed needs integers"},
      {"draws = 2\n[random]\nseed = {min = 1}\n", "s.toml:3:8: seed needs min and max and nothing else"},
      {"draws = 2\n[random]\nseed = {min = 1, max = 2, step = 1}\n", "s.toml:3:8: seed needs min and max"},
      {"draws = 2\n[random]\nseed = 4\n", "s.toml:3:8: seed is 4; expected its smallest and largest value"},
      {"draws = 2\n[random]\nreflex.method = {min = 1, max = 2}\n", "s.toml:3:17: reflex.method is no number"},
      {"draws = 2\n[random]\nfloor.friction = {min = nan, max = 2}\n", "s.toml:3:18: floor.friction needs finite"},
      {"draws = 2\n[random]\nfloor.friction = {min = -inf, max = 2}\n", "s.toml:3:18: floor.friction needs finite"},
      {"grid = 5\n", "s.toml:1:8: grid is 5; expected a table"},
      {"floor.friction = [1]\n", "s.toml:1:1: floor is no key of a sweep"},
      {"scenario = 5\n[grid]\nseed = [1]\n", "s.toml:1:12: scenario is not the name of a file"},
      {"draws = 1000000\n[grid]\nseed = [1, 2]\n[random]\nfloor.friction = {min = 0.1, max = 1}\n",
       "s.toml: has more than 1000000 rows"},
  };
  for (const auto& [text, message] : mistakes) {
    EXPECT_THAT(refusal(text), StartsWith(message)) << text;
    EXPECT_THAT(refusal(text), HasSubstr("\n  remedy: ")) << text;
  }
}

TEST(SweepFile, AllMistakesAreToldAtOnceInTheOrderOfTheLines) {
  const std::string message = refusal("wrong = 1\n[grid]\nfloor.friction = []\nseed = 3\n");
  EXPECT_LT(message.find("s.toml:1:"), message.find("s.toml:3:"));
  EXPECT_LT(message.find("s.toml:3:"), message.find("s.toml:4:"));
  EXPECT_NE(message.find("s.toml:4:"), std::string::npos);
}

}  // namespace
}  // namespace surefoot::sweep
