#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tools/plan/request.hpp"
#include "tools/scenario/preset.hpp"
#include "tools/scenario/scenario_error.hpp"

namespace surefoot::plan {
namespace {

using testing::HasSubstr;

std::string refusal_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    static_cast<void>(load_request_text("gait.toml", text, overrides));
  } catch (const scenario::ScenarioError& error) {
    return error.what();
  }
  return "no refusal";
}

// Al-Shuka et al. 2014, Table 3, before compensation.
TEST(PlanRequest, IsThePapersGaitWhereNothingIsAsked) {
  const PlanRequest request = load_request_text("nothing", "");
  EXPECT_EQ(request.plan.gait.com_height_m, 0.88);
  EXPECT_EQ(request.plan.gait.single_support_share, 0.7575);
  EXPECT_EQ(request.plan.gait.single_support_s, 0.5);
  EXPECT_EQ(request.plan.gait.double_support_s, 0.125);
  EXPECT_NEAR(request.step_plan().foot.toe_angle_rad, 12.0 * M_PI / 180.0, 1e-12);
}

TEST(PlanRequest, TakesLengthsMassesAndFrictionOfTheScenariosRobots) {
  for (const char* robot : {"khr2", "elkahlout"}) {
    const PlanRequest request = load_request_text("t", std::string("robot = \"") + robot + "\"");
    const scenario::Scenario scenario = scenario::preset({.robot = robot, .plant = "nominal"});
    const geometry::RobotGeometry& lengths = scenario.firmware.geometry;
    const sim_hw::MassConfig& mass = scenario.sim.mass;
    EXPECT_DOUBLE_EQ(2.0 * request.body.link_m, lengths.thigh_m + lengths.calf_m);
    EXPECT_EQ(request.body.ankle_height_m, lengths.ankle_height_m);
    EXPECT_EQ(request.plan.foot.toe_m, lengths.sole_toe_m);
    EXPECT_EQ(request.plan.foot.heel_m, lengths.sole_heel_m);
    EXPECT_EQ(request.limits.friction, scenario.sim.contact.friction);
    EXPECT_DOUBLE_EQ(request.body.mass_kg(), mass.trunk_kg + 2.0 * (mass.thigh_kg + mass.calf_kg + mass.foot_kg));
  }
}

// By hand for KHR-2's stance, hip 0.55 m above the ankles: (34 * 0.25 - 22 kg of legs below the hip) / 56 kg.
TEST(PlanRequest, PutsTheCentreOfMassAboveTheHipWhereItStands) {
  const PlanRequest request = preset_request("khr2");
  const double below_kg_m = 2.0 * (5.0 * 0.1375 + 3.5 * 0.4125 + 2.5 * 0.55);
  EXPECT_NEAR(request.body.com_above_hip_m, (34.0 * 0.25 - below_kg_m) / 56.0, 1e-12);
  EXPECT_NEAR(request.body.hip_height_m(0.57), 0.57 - request.body.com_above_hip_m + 0.1, 1e-12);
}

TEST(PlanRequest, JoinsTheSupportsWhereTimesAreGivenWithoutAShare) {
  const PlanRequest joined = load_request_text("t",
                                               "[gait]\nsingle_support_s = 1.2\ndouble_support_s = 0.3\n"
                                               "com_height_m = 0.86");
  EXPECT_NEAR(joined.plan.gait.single_support_share, 0.62013, 1e-5);  // eq. (16), inverted
  const PlanRequest given = load_request_text("t", "[gait]\nsingle_support_s = 1.2\nsingle_support_share = 0.5");
  EXPECT_EQ(given.plan.gait.single_support_share, 0.5);
}

TEST(PlanRequest, OverridesWhatTheFileSays) {
  const std::vector<std::string> overrides{"gait.step_length_m=0.3", "pattern=flat_feet"};
  const PlanRequest request = load_request_text("t", "[gait]\nstep_length_m = 0.4", overrides);
  EXPECT_EQ(request.plan.gait.step_length_m, 0.3);
  EXPECT_EQ(request.plan.pattern, planning::WalkingPattern::kFlatFeet);
}

TEST(PlanRequest, RefusesWithPlaceValueRangeAndRemedy) {
  const std::string said = refusal_of("[gait]\nsingle_support_s = -0.5\nstep_length_m = nan\n");
  EXPECT_THAT(said, HasSubstr("gait.toml:2:20: gait.single_support_s is -0.5; expected 0.05 to 10 s\n  remedy: "));
  EXPECT_THAT(said, HasSubstr("gait.toml:3:17: gait.step_length_m is nan; expected 0.01 to 2 m\n  remedy: "));
  EXPECT_THAT(refusal_of("[gait]\ncom_hight_m = 0.8"), HasSubstr("did you mean gait.com_height_m?"));
  EXPECT_THAT(refusal_of("robot = \"hubo\""), HasSubstr("one of \"paper\", \"khr2\", \"elkahlout\""));
  EXPECT_THAT(refusal_of("pattern = 3"), HasSubstr("gait.toml:1:11: pattern is the integer 3"));
  EXPECT_THAT(refusal_of("gait = 1"), HasSubstr("expected a table"));
  EXPECT_THAT(refusal_of("", {"foot.toe_m=long"}), HasSubstr("--set foot.toe_m=long: foot.toe_m is the string"));
}

TEST(PlanRequest, ShowsEveryKey) {
  PlanRequest request = preset_request("paper");
  const std::string shown = describe_request_keys();
  for (const scenario::Field& field : fields(request)) EXPECT_THAT(shown, HasSubstr("  " + field.key + " "));
}

}  // namespace
}  // namespace surefoot::plan
