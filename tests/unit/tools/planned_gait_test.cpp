#include "tools/plan/planned_gait.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>

#include "tools/plan/comparison.hpp"
#include "tools/plan/gait_file.hpp"
#include "tools/plan/plan_json.hpp"
#include "tools/plan/plan_text.hpp"
#include "tools/plan/samples.hpp"
#include "tools/plan/speeds.hpp"

namespace surefoot::plan {
namespace {

using testing::HasSubstr;

PlanRequest request_of(const std::vector<std::string>& overrides) { return load_request_text("t", "", overrides); }

/// The request with a remedy taken.
PlanRequest remedied(const PlanRequest& request, const Remedy& remedy, double value) {
  PlanRequest changed = request;
  for (const scenario::Field& field : fields(changed)) {
    if (field.key == remedy.key) **std::get_if<double*>(&field.target) = value;
  }
  return changed;
}

// Al-Shuka et al. 2014, Table 3: from (0.88, 0.7575, 0.125, 0.5) to (0.86, 0.6203, 0.3, 1.2).
TEST(PlannedGait, MakesThePapersGaitFeasibleNearThePapersResult) {
  const PlanResult result = plan_gait(preset_request("paper"));
  ASSERT_TRUE(result.is_feasible());
  EXPECT_EQ(result.before.broken(), "knee");
  const planning::GaitFactors& gait = result.after.plan.gait;
  EXPECT_NEAR(gait.com_height_m, 0.86, 0.011);
  EXPECT_NEAR(gait.single_support_share, 0.6203, 0.01);
  EXPECT_NEAR(gait.double_support_s, 0.3, 0.01);
  EXPECT_NEAR(gait.single_support_s, 1.2, 0.03);
  EXPECT_NEAR(result.after.gap_m, 0.0, 1e-9);
  EXPECT_GE(result.after.least_clearance_m, -1e-6);
}

TEST(PlannedGait, SaysThatSupportsWithTimesAndShareAtOddsDoNotJoin) {
  PlanRequest request = preset_request("khr2");
  request.limits.zmp_margin_m = 0.0;
  request.plan.gait.single_support_share -= 0.1;
  const PlanResult result = plan_gait(request, {.compensates = false});
  EXPECT_EQ(result.after.broken(), "joint");
  EXPECT_GT(std::abs(result.after.gap_m), 1e-3);
  ASSERT_EQ(result.nearest.size(), 2U);
  EXPECT_EQ(result.nearest[0].key, "gait.single_support_share");
  EXPECT_NEAR(result.nearest[0].value, request.plan.gait.single_support_share + 0.1, 1e-6);
}

TEST(PlannedGait, SaysThatAFootWouldScrape) {
  const PlanResult result = plan_gait(request_of({"foot.toe_angle_deg=30", "foot.heel_angle_deg=30"}));
  EXPECT_EQ(result.after.broken(), "clearance");
  ASSERT_EQ(result.nearest.size(), 1U);
  EXPECT_EQ(result.nearest[0].key, "foot.top_z_m");
}

// Each value that is named does, and a little less of it does not.
TEST(PlannedGait, NamesTheNearestValuesThatDo) {
  const std::vector<std::vector<std::string>> requests{
      {"limits.friction=0.0"}, {"body.link_m=0.1"}, {"limits.zmp_margin_m=0.2"}};
  for (const std::vector<std::string>& overrides : requests) {
    const PlanRequest request = request_of(overrides);
    const PlanResult result = plan_gait(request);
    ASSERT_FALSE(result.is_feasible());
    ASSERT_FALSE(result.nearest.empty()) << overrides[0];
    for (const Remedy& remedy : result.nearest) {
      EXPECT_TRUE(is_possible(remedied(request, remedy, remedy.value), {})) << remedy.key;
      const double short_of_it = remedy.value + (remedy.is_at_most ? 0.002 : -0.002);
      EXPECT_FALSE(is_possible(remedied(request, remedy, short_of_it), {})) << remedy.key;
    }
  }
}

TEST(PlannedGait, NamesTheCompensatedGaitWhereOneValueAloneDoesNotDo) {
  const PlanRequest request = preset_request("paper");
  const PlanResult checked = plan_gait(request, {.compensates = false});
  ASSERT_FALSE(checked.is_feasible());
  PlanRequest taken = request;
  for (const Remedy& remedy : checked.nearest) {
    EXPECT_TRUE(remedy.needs_the_others);
    taken = remedied(taken, remedy, remedy.value);
  }
  EXPECT_TRUE(plan_gait(taken, {.compensates = false}).is_feasible());
}

TEST(PlannedGait, WalksAtTheSpeedThatIsWanted) {
  for (const double speed_m_s : {0.1, 0.2}) {
    const PlanResult result = plan_gait(request_of({"robot=khr2", "pattern=flat_feet", "gait.step_length_m=0.2"}),
                                        {.compensates = true, .speed_m_s = speed_m_s});
    ASSERT_TRUE(result.is_feasible()) << speed_m_s;
    const planning::GaitFactors& gait = result.after.plan.gait;
    EXPECT_NEAR(gait.speed_m_s(), speed_m_s, 1e-6);
    EXPECT_EQ(gait.step_length_m, 0.2);
    EXPECT_NEAR(gait.double_support_s, planning::continuous_double_support_s(gait), 1e-9);
  }
}

TEST(PlannedGait, ChoosesAnotherStepOnlyWhereItMay) {
  const PlanRequest request = request_of({"robot=khr2", "gait.step_length_m=0.2"});
  EXPECT_FALSE(plan_gait(request, {.compensates = true, .speed_m_s = 0.1}).is_feasible());
  const PlanResult chosen = plan_gait(request, {.compensates = true, .speed_m_s = 0.1, .chooses_step = true});
  ASSERT_TRUE(chosen.is_feasible());
  EXPECT_NEAR(chosen.after.plan.gait.speed_m_s(), 0.1, 1e-6);
  EXPECT_NE(chosen.after.plan.gait.step_length_m, 0.2);
}

// Al-Shuka et al. 2014, Fig. 15.
TEST(PlanComparison, FindsPatternTwoOutsideWhenTheFootLandsAndPatternThreeNever) {
  const PlanRequest request = preset_request("paper");
  const std::vector<CheckedGait> gaits = compare(request, plan_gait(request).after.plan.gait);
  ASSERT_EQ(gaits.size(), 9U);
  for (const CheckedGait& gait : gaits) {
    EXPECT_NE(gait.broken(), "knee");
    EXPECT_LE(std::abs(gait.gap_m), 1e-6);
    if (gait.plan.pattern == planning::WalkingPattern::kRolledTogether) {
      EXPECT_LT(gait.margins.least_zmp_margin_m, -0.05);
      EXPECT_LT(gait.margins.least_zmp_margin_at_s, 0.01);
    } else {
      EXPECT_GT(gait.margins.least_zmp_margin_m, 0.0);
    }
  }
}

TEST(PlanSpeeds, AreReadUpAndDownAndRefusedWithTheReason) {
  EXPECT_THAT(parse_speeds("0.1:0.2:0.05"),
              testing::ElementsAre(0.1, testing::DoubleNear(0.15, 1e-12), testing::DoubleNear(0.2, 1e-12)));
  EXPECT_THAT(parse_speeds("0.2:0.1:0.1"), testing::ElementsAre(0.2, testing::DoubleNear(0.1, 1e-12)));
  for (const char* text : {"", "0.1", "0.1:0.2", "0.1:0.2:0", "0.1:0.2:-1", "nan:1:0.1", "0.1:9:1", "0:1:0.1",
                           "0.1:0.2:0.05x", "0.1:0.2:0.00001", "0.1:0.2:nan"}) {
    EXPECT_THROW(static_cast<void>(parse_speeds(text)), BadSpeeds) << text;
  }
}

TEST(GaitFile, HoldsTheGaitsOneAfterTheOther) {
  const PlanRequest request = request_of({"robot=khr2", "pattern=flat_feet", "gait.step_length_m=0.2"});
  const std::vector<PlanResult> gaits = library(request, {0.1, 0.2}, false);
  const std::string text = gait_file_text(gaits, 20);
  EXPECT_THAT(text, HasSubstr("robot = \"khr2\"\n"));
  const std::size_t second = text.find("[[planned_gait]]", text.find("[[planned_gait]]") + 1);
  ASSERT_NE(second, std::string::npos);
  EXPECT_LT(text.find("steps = 20"), second);
  EXPECT_NE(text.find("steps = 20", second), std::string::npos) << "the last one ends as well";
  EXPECT_THAT(text, HasSubstr("[gait]\nbody_height_m = "));
  EXPECT_THAT(text, HasSubstr("pattern = \"flat_feet\"\ncom_method = \"shared_pressure\"\nlands_hard = false\n"));
  EXPECT_THAT(text.substr(second), HasSubstr("single_support_s = 0.8\ndouble_support_s = 0.2\n"));
}

TEST(PlanSamples, EndWhereTheNextStepBegins) {
  const PlanRequest request = preset_request("paper");
  const planning::StepPlan plan = plan_gait(request).after.plan;
  const std::vector<PlanSample> samples = samples_of(request, plan, 11);
  ASSERT_EQ(samples.size(), 11U);
  EXPECT_NEAR(samples.back().instant.com_x_m.position - samples.front().instant.com_x_m.position,
              plan.gait.step_length_m, 1e-9);
  std::istringstream csv(samples_csv(samples));
  std::string line;
  std::getline(csv, line);
  const auto columns = std::ranges::count(line, ',');
  while (std::getline(csv, line)) EXPECT_EQ(std::ranges::count(line, ','), columns);
}

TEST(PlanText, ShowsEachTurnAndTheVerdict) {
  const PlanResult result = plan_gait(preset_request("paper"));
  const std::string text = plan_text(result);
  for (const CompensationTurn& turn : result.compensation.turns) EXPECT_THAT(text, HasSubstr(turn.change));
  EXPECT_THAT(text, HasSubstr("Feasible: every constraint holds"));
  EXPECT_THAT(to_json(result), HasSubstr("\"is_feasible\": true"));
}

}  // namespace
}  // namespace surefoot::plan
