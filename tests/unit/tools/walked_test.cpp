#include "tools/plan/walked.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace surefoot::plan {
namespace {

using testing::HasSubstr;

/// Both feet side by side; the left one alone carries, with these forces at its front and rear corners.
sim_hw::GroundTruth standing_truth(double yaw_rad, double front_n, double rear_n) {
  sim_hw::GroundTruth truth;
  truth.yaw_rad = yaw_rad;
  truth.body_position_world_m = {3.0, -2.0, 0.5};
  truth.corner_force_n[index(Side::kLeft)] = {front_n, front_n, rear_n, rear_n};
  return truth;
}

// Lever rule on a sole from -0.08 to 0.17 m: 30 N in front and 10 N behind press at 0.17 - 0.25 / 4.
TEST(TruePressure, FollowsTheLeverRuleWhateverTheHeading) {
  const geometry::RobotGeometry robot;
  for (const double yaw_rad : {0.0, 0.7, -2.0}) {
    const auto pressure = true_pressure(robot, standing_truth(yaw_rad, 30.0, 10.0));
    ASSERT_TRUE(pressure);
    const double foot_m = pressure->foot_m[index(Side::kLeft)];
    EXPECT_NEAR(pressure->zmp_m - foot_m, 0.17 - 0.25 / 4.0, 1e-9);
    EXPECT_NEAR(pressure->front_m - foot_m, 0.17, 1e-9);
    EXPECT_NEAR(pressure->rear_m - foot_m, -0.08, 1e-9);
    EXPECT_NEAR(pressure->margin_m(), 0.25 / 4.0, 1e-9);
  }
}

TEST(TruePressure, HasNoMarginOnTheToeAlone) {
  const auto pressure = true_pressure(geometry::RobotGeometry{}, standing_truth(0.0, 30.0, 0.0));
  ASSERT_TRUE(pressure);
  EXPECT_NEAR(pressure->margin_m(), 0.0, 1e-12);
}

TEST(TruePressure, IsNotThereInTheAir) {
  EXPECT_FALSE(true_pressure(geometry::RobotGeometry{}, standing_truth(0.0, 0.5, 0.5)));
}

ZmpSample sample_of(double planned_m, double measured_m) {
  return {.time_s = 0.0, .planned_m = planned_m, .measured_m = measured_m, .rear_m = -0.1, .front_m = 0.1};
}

TEST(SumUp, LeavesOutTheFirstThreeSteps) {
  const std::vector<ZmpSample> wild{sample_of(0.0, 0.5)};
  const std::vector<std::vector<ZmpSample>> steps{wild, wild, wild, {sample_of(0.0, 0.03), sample_of(0.0, -0.04)}};
  Walked walked;
  sum_up(steps, walked);
  ASSERT_TRUE(walked.least_margin_m);
  EXPECT_NEAR(*walked.least_margin_m, 0.06, 1e-12);
  EXPECT_NEAR(*walked.rms_difference_m, 0.05 / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(*walked.most_difference_m, 0.04, 1e-12);
}

TEST(SumUp, TakesTheFifthPercentileFromTheWorstEnd) {
  std::vector<ZmpSample> step;
  for (int i = 0; i <= 100; ++i) step.push_back(sample_of(0.0, 0.001 * i));  // margins 100 to 0 mm
  const std::vector<std::vector<ZmpSample>> steps{{}, {}, {}, step};
  Walked walked;
  sum_up(steps, walked);
  EXPECT_NEAR(walked.fifth_margin_m.value_or(1.0), 0.005, 1e-12);
}

TEST(SumUp, KnowsNothingOfAWalkOfThreeSteps) {
  const std::vector<std::vector<ZmpSample>> steps(3, {sample_of(0.0, 0.0)});
  Walked walked;
  walked.file = "short.toml";
  sum_up(steps, walked);
  EXPECT_FALSE(walked.least_margin_m);
  EXPECT_THAT(walked_text(std::vector{walked}), HasSubstr(" -"));
  EXPECT_THAT(walked_json(std::vector{walked}, false), HasSubstr("\"least_margin_m\": null"));
}

// Planned and true pressure centre share a frame: seen from the wrong foot they would be a step apart, 0.12 m.
TEST(Walk, MeasuresThePressureCentreWhereItIsPlanned) {
  const std::string text =
      "robot = \"khr2\"\nduration_s = 8.0\n[pattern]\nstanding_s = 1.0\n[[planned_gait]]\nsteps = 6\n"
      "step_length_m = 0.12\nsingle_support_share = 0.664571\nsingle_support_s = 0.8\ndouble_support_s = 0.2\n";
  const Walked walked = walk("t", scenario::load_text("t", text, {}));
  EXPECT_STREQ(walked.verdict(), "walked");
  EXPECT_GE(walked.steps, 6);
  EXPECT_LT(walked.rms_difference_m.value_or(1.0), 0.5 * 0.12);
  EXPECT_LT(walked.least_margin_m.value_or(1.0), walked.planned_margin_m.value_or(0.0));
  EXPECT_FALSE(walked.picture.empty());
}

}  // namespace
}  // namespace surefoot::plan
