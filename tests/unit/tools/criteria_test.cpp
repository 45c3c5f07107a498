#include "tools/floor/criteria.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "tools/floor/floor_cases.hpp"

namespace surefoot::floor {
namespace {

using stabilizer::Controller;
using ::testing::HasSubstr;

CriterionRow row(Wanted wanted, double off, double on, std::size_t less = 9, std::size_t more = 1) {
  CriterionRow row;
  row.wanted = wanted;
  row.off = {10, off};
  row.on = {10, on};
  row.compared = 10;
  row.less = less;
  row.more = more;
  row.walks = 12;
  return row;
}

TEST(CriterionVerdict, AsksForAClearChangeWhereThePaperPrintsNoNumber) {
  EXPECT_EQ(row({}, 10.0, 9.4).verdict(), CriterionVerdict::kHolds);
  EXPECT_EQ(row({}, 10.0, 9.6).verdict(), CriterionVerdict::kDoesNotHelp);
  EXPECT_EQ(row({}, 10.0, 11.0).verdict(), CriterionVerdict::kDoesNotHelp);
  EXPECT_EQ(row({}, 10.0, 5.0, 5, 5).verdict(), CriterionVerdict::kDoesNotHelp) << "one walk made the mean";
  EXPECT_EQ(row({}, 4.0, 0.0, 5, 0).verdict(), CriterionVerdict::kHolds) << "in five there was nothing to do";
  EXPECT_EQ(row({}, 0.0, 0.0).verdict(), CriterionVerdict::kDoesNotHelp);
}

TEST(CriterionVerdict, DoesNotTakeLuckForHelp) {
  EXPECT_NEAR(chance_of_luck(5, 0), 1.0 / 32.0, 1e-15);
  EXPECT_NEAR(chance_of_luck(7, 5), 1586.0 / 4096.0, 1e-15);
  EXPECT_EQ(chance_of_luck(0, 0), 1.0);
  EXPECT_EQ(row({}, 10.0, 5.0, 7, 5).verdict(), CriterionVerdict::kNotShown);
  EXPECT_EQ(row({}, 10.0, 5.0, 4, 0).verdict(), CriterionVerdict::kNotShown);
  CriterionRow alone = row({}, 10.0, 5.0, 1, 0);
  alone.walks = 1;
  EXPECT_EQ(alone.verdict(), CriterionVerdict::kHolds) << "the same bits each time";
}

TEST(CriterionVerdict, HoldsOnlyWithinTheNumberThatIsAskedFor) {
  const Wanted leg{Wanted::Kind::kNear, 3.72, 0.1};
  EXPECT_EQ(row(leg, 0.0, 3.63).verdict(), CriterionVerdict::kHolds);
  EXPECT_EQ(row(leg, 0.0, 3.83).verdict(), CriterionVerdict::kNotMet);
  EXPECT_EQ(row(leg, 0.0, -3.72).verdict(), CriterionVerdict::kNotMet) << "the sign counts";
  const Wanted vibration{Wanted::Kind::kAtMost, 1.0, 0.0};
  EXPECT_EQ(row(vibration, 9.0, 1.0).verdict(), CriterionVerdict::kHolds);
  EXPECT_EQ(row(vibration, 9.0, 1.1).verdict(), CriterionVerdict::kNotMet);
  const Wanted force{Wanted::Kind::kBelow, 30.0, 0.0};
  EXPECT_EQ(row(force, 500.0, 350.0).verdict(), CriterionVerdict::kHolds);
  EXPECT_EQ(row(force, 500.0, 351.0).verdict(), CriterionVerdict::kNotMet);
}

TEST(CriterionVerdict, JudgesNothingWithoutASample) {
  CriterionRow fallen = row({}, 1.0, 0.5);
  fallen.off = {};
  EXPECT_EQ(fallen.verdict(), CriterionVerdict::kNoSample);
  EXPECT_FALSE(fallen.change_percent());
}

TEST(Criteria, MissWhereANumberIsMissedOrCannotBeJudged) {
  CriterionRow fallen = row({Wanted::Kind::kAtMost, 1.0, 0.0}, 1.0, 0.5);
  fallen.on = {};
  const Criteria criteria{{row({}, 10.0, 20.0), row({Wanted::Kind::kNear, 3.0, 0.1}, 0.0, 2.0), fallen,
                           row({Wanted::Kind::kNear, 3.0, 0.1}, 0.0, 3.0)}};
  EXPECT_EQ(criteria.missed(), 2U) << "a controller that does not help misses no number";
}

TEST(Criteria, ReadTheSameAsTextCsvAndJson) {
  CriterionRow one = row({Wanted::Kind::kBelow, 30.0, 0.0}, 463.42, 187.11);
  one.controller = Controller::kShockAbsorber;
  one.set = "off";
  one.floor = "tiles of 8 mm";
  one.what = "peak force";
  one.unit = "N";
  one.falls_on = 2;
  const Criteria criteria{{one}};
  EXPECT_THAT(
      criteria_text(criteria),
      HasSubstr(" 463.42   187.11    -60 %  -30 %         holds           9, 1 of 10      10, 10  0, 2 of 12\n"));
  const std::string csv = criteria_csv(criteria);
  const auto columns = [](const std::string& line) { return std::count(line.begin(), line.end(), ','); };
  EXPECT_EQ(columns(csv.substr(0, csv.find('\n'))), columns(csv.substr(csv.find('\n'))));
  EXPECT_THAT(csv, HasSubstr("\nshock_absorber,off,\"tiles of 8 mm\",\"peak force\",N,10,463.42,10,187.11,-59.62,-30 %,"
                             "holds,9,1,10,12,0,2\n"));
  const auto json = nlohmann::json::parse(to_json(criteria));
  EXPECT_EQ(json.at("missed"), 0);
  EXPECT_EQ(json.at("rows").at(0).at("verdict"), "holds");
  EXPECT_EQ(json.at("rows").at(0).at("on").at("mean"), 187.11);
}

TEST(CriterionExperiments, HaveOneForEachOfTheThirteenInTheirOrder) {
  const std::vector<Experiment> experiments = criterion_experiments({1, 2});
  std::set<Controller> seen;
  Controller before = Controller::kUprightPose;
  for (const Experiment& experiment : experiments) {
    EXPECT_GE(experiment.controller, before);
    before = experiment.controller;
    seen.insert(experiment.controller);
    EXPECT_FALSE(experiment.walks.empty());
    EXPECT_FALSE(experiment.quantities.empty());
  }
  EXPECT_EQ(seen.size(), 13U);
  EXPECT_EQ(*seen.rbegin(), Controller::kTiltLandingPosition);
  EXPECT_EQ(criterion_experiments({1}, "zmp_compensator").size(), 2U);
  EXPECT_TRUE(criterion_experiments({1}, "attitude_feedback").empty()) << "ours, not the paper's";
}

}  // namespace
}  // namespace surefoot::floor
