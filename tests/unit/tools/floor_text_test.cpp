#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tools/floor/ablation.hpp"
#include "tools/floor/floor_table.hpp"
#include "tools/floor/torso_trace.hpp"

namespace surefoot::floor {
namespace {

using ::testing::HasSubstr;

run::Verdict walked(double least_roll_deg, double most_roll_deg, double pitch_deg, double way_m = 0.0) {
  run::Verdict verdict;
  verdict.torso_roll_deg = {least_roll_deg, most_roll_deg, false};
  verdict.torso_pitch_deg = {-pitch_deg, 0.0, false};
  verdict.distance_m = way_m;
  return verdict;
}

run::Verdict ended(run::Outcome outcome) {
  run::Verdict verdict = walked(-80.0, 90.0, 70.0, -3.0);
  verdict.outcome = outcome;
  return verdict;
}

TEST(FloorSummary, TakesMeanAndWorstOfTheRunsThatDidNotFall) {
  const std::vector<run::Verdict> verdicts{walked(-2.0, 1.0, 0.5, 9.0), ended(run::Outcome::kFell),
                                           walked(-1.0, 4.0, 1.5, 11.0), ended(run::Outcome::kFault)};
  const Summary summary = summary_of(verdicts);
  EXPECT_EQ(summary.runs, 4U);
  EXPECT_EQ(summary.falls, 2U) << "a latched fault is no walk";
  EXPECT_DOUBLE_EQ(summary.roll.mean_deg, 3.0);
  EXPECT_DOUBLE_EQ(summary.roll.worst_deg, 4.0);
  EXPECT_DOUBLE_EQ(summary.pitch.mean_deg, 1.0);
  EXPECT_DOUBLE_EQ(summary.pitch.worst_deg, 1.5);
  EXPECT_DOUBLE_EQ(summary.shortest_way_m, 9.0);
  EXPECT_EQ(text_of(summary, summary.roll), "3.00 (4.00)");
}

TEST(FloorSummary, HasNoAnglesWhereAllFell) {
  const Summary summary = summary_of(std::vector{ended(run::Outcome::kFell)});
  EXPECT_TRUE(summary.all_fell());
  EXPECT_EQ(text_of(summary, summary.roll), "-");
  EXPECT_TRUE(json_of(summary).at("roll_mean_deg").is_null());
  EXPECT_EQ(csv_of(summary), "1,1,,,,,");
}

/// Two seeds; without controllers the second run of "both" falls, with the extended set the second in the room.
FloorTable example() {
  const FloorTableSpec spec{{"off", "extended"}, {1, 2}};
  std::vector<run::Verdict> verdicts;
  for (int run = 0; run < 16; ++run) verdicts.push_back(walked(-0.1 * run, 0.0, 0.05 * run, 10.0 + run));
  verdicts[5] = ended(run::Outcome::kFell);
  verdicts[15] = ended(run::Outcome::kFell);
  return table_of(spec, verdicts);
}

TEST(FloorTable, PutsEveryRunIntoItsRow) {
  const FloorTable table = example();
  ASSERT_EQ(table.rows.size(), 10U);
  EXPECT_EQ(table.falls("off"), 1U);
  EXPECT_EQ(table.falls("extended"), 1U);
  EXPECT_EQ(table.falls("paper"), 0U);
  EXPECT_EQ(table.rows[3].floor, FloorCase::kBoth);
  EXPECT_EQ(table.rows[3].summary.falls, 1U);
  EXPECT_NEAR(table.rows[3].summary.roll.worst_deg, 0.4, 1e-12);
  EXPECT_EQ(table.rows[9].set, "extended");
  EXPECT_NEAR(table.rows[9].summary.roll.worst_deg, 1.4, 1e-12);
}

TEST(FloorTable, PrintsThePapersFiguresBesideOurs) {
  const std::string text = floor_text(example());
  EXPECT_THAT(text, HasSubstr("off          both             2    1 of 2    0.40 (0.40)    0.20 (0.20)  falls\n"));
  EXPECT_THAT(text, HasSubstr("extended     global           3    0 of 1"));
  EXPECT_THAT(text, HasSubstr("In the room extended walks at least 24.0 m"));
}

TEST(FloorTable, GivesTheSameAsJsonAndCsv) {
  const FloorTable table = example();
  const auto json = nlohmann::json::parse(to_json(table));
  ASSERT_EQ(json.at("rows").size(), 10U);
  EXPECT_EQ(json["rows"][3]["falls"], 1);
  EXPECT_EQ(json["rows"][3]["paper_roll_deg"], "falls");
  EXPECT_EQ(json["seeds"], (std::vector<int>{1, 2}));
  const std::string csv = floor_csv(table);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 11);
  EXPECT_THAT(csv, HasSubstr("\noff,both,2,1,2,0.4000,0.4000,0.2000,0.2000,14.0000,falls\n"));
}

TEST(FloorAblation, PrintsARowForEachChoice) {
  Ablation plan = planned({"paper", {1}});
  std::vector<run::Verdict> verdicts(plan.rows.size(), walked(-1.0, 0.0, 0.5));
  verdicts[1] = ended(run::Outcome::kFell);
  const Ablation ablation = ablation_of(plan, verdicts);
  EXPECT_THAT(ablation_text(ablation), HasSubstr("upright_pose alone"));
  EXPECT_THAT(ablation_csv(ablation), HasSubstr("\nupright_pose alone,1,1,,,,,\n"));
  const auto json = nlohmann::json::parse(to_json(ablation));
  EXPECT_EQ(json.at("rows").size(), plan.rows.size());
  EXPECT_EQ(json["rows"].back()["controllers"], "paper without tilt_landing_position");
}

TEST(FloorTraces, AreTheFourFloorsOnTheSpotUnderEachSet) {
  std::vector<TracedWalk> walks = traced_walks({{"off", "extended"}, {1}});
  ASSERT_EQ(walks.size(), 8U);
  EXPECT_EQ(walks[3].slope_deg, 2.0);
  EXPECT_EQ(walks[7].slope_deg, 3.0);
  walks[3].trace = {{0.0, 0.02}, {0.5, -4.0}, {0.1, 0.2}, true};
  EXPECT_THAT(trace_text(walks), HasSubstr("roll  4.00  pitch  0.20  falls"));
  EXPECT_THAT(trace_csv(walks), HasSubstr("\noff,both,2,0.020,-4.0000,0.2000\n"));
  const auto json = nlohmann::json::parse(to_json(walks, {{"off", "extended"}, {1}}));
  EXPECT_EQ(json.at("walks").size(), 8U);
  EXPECT_EQ(json["walks"][3]["falls"], true);
}

}  // namespace
}  // namespace surefoot::floor
