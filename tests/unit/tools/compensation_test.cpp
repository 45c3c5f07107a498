#include "tools/plan/compensation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace surefoot::plan {
namespace {

using planning::SagittalBody;
using planning::StepConstraint;
using planning::StepPlan;

/// Al-Shuka et al. 2014, Table 3, before compensation.
StepPlan infeasible_gait() {
  StepPlan plan;
  plan.gait = {.com_height_m = 0.88,
               .step_length_m = 0.5,
               .single_support_share = 0.7575,
               .single_support_s = 0.5,
               .double_support_s = 0.125};
  plan.foot.toe_angle_rad = plan.foot.heel_angle_rad = 12.0 * M_PI / 180.0;
  return plan;
}

// The paper ends at (0.86, 0.6203, 0.3, 1.2). Its body and its rules are lost: with ours the gait goes the same way and
// ends nearby.
TEST(Compensation, LowersTheHipAndWalksMoreSlowlyUntilThePapersGaitIsFeasible) {
  const Compensation found = compensate({.link_m = 0.46}, {.zmp_margin_m = 0.05}, infeasible_gait());
  ASSERT_TRUE(found.is_feasible());
  const planning::GaitFactors& gait = found.last().gait;
  EXPECT_NEAR(gait.com_height_m, 0.86, 0.02);
  EXPECT_NEAR(gait.single_support_share, 0.6203, 0.02);
  EXPECT_NEAR(gait.double_support_s, 0.3, 0.03);
  EXPECT_NEAR(gait.single_support_s, 1.2, 0.1);
  EXPECT_DOUBLE_EQ(gait.step_length_m, 0.5);
  EXPECT_NEAR(gait.double_support_s, 0.25 * gait.single_support_s, 1e-12);
  EXPECT_GE(found.last().margins.least_zmp_margin_m, 0.05);
  EXPECT_EQ(found.turns.front().margins.broken, StepConstraint::kKnee);
  EXPECT_EQ(found.last().change, "");
}

TEST(Compensation, SaysInEachTurnWhatItChangesAndChangesNothingElse) {
  const Compensation found = compensate({.link_m = 0.46}, {.zmp_margin_m = 0.05}, infeasible_gait());
  for (std::size_t i = 0; i + 1 < found.turns.size(); ++i) {
    const CompensationTurn& turn = found.turns[i];
    const planning::GaitFactors& next = found.turns[i + 1].gait;
    EXPECT_NE(turn.change, "");
    if (turn.margins.broken == StepConstraint::kKnee) {
      EXPECT_NEAR(next.com_height_m, turn.gait.com_height_m - 0.005, 1e-12);
      EXPECT_EQ(next.single_support_s, turn.gait.single_support_s);
    } else {
      EXPECT_EQ(next.com_height_m, turn.gait.com_height_m);
      EXPECT_NEAR(next.single_support_s, 1.1 * turn.gait.single_support_s, 1e-12);
    }
  }
}

TEST(Compensation, LeavesAFeasibleGaitAsItIs) {
  StepPlan plan = infeasible_gait();
  plan.gait.com_height_m = 0.845;
  plan.gait.single_support_s = 1.2;
  const Compensation found = compensate({.link_m = 0.46}, {}, plan);
  EXPECT_TRUE(found.is_feasible());
  EXPECT_EQ(found.turns.size(), 1U);
}

TEST(Compensation, ShortensTheStepWhenItMayWalkNoMoreSlowly) {
  CompensationRules rules;
  rules.longest_single_support_s = 0.55;
  const Compensation found = compensate({.link_m = 0.47}, {.zmp_margin_m = 0.02}, infeasible_gait(), rules);
  ASSERT_TRUE(found.is_feasible());
  EXPECT_LT(found.last().gait.step_length_m, 0.5);
  EXPECT_LE(found.last().gait.single_support_s, 0.55);
}

TEST(Compensation, EndsWithTheConstraintThatCannotBeMet) {
  const Compensation no_friction = compensate({.link_m = 0.47}, {.friction = 0.0}, infeasible_gait());
  EXPECT_FALSE(no_friction.is_feasible());
  EXPECT_EQ(no_friction.last().margins.broken, StepConstraint::kFriction);
  EXPECT_GE(no_friction.last().gait.step_length_m, 0.1);
  StepPlan backwards = infeasible_gait();
  backwards.gait.single_support_s = -1.0;
  const Compensation impossible = compensate({}, {}, backwards);
  EXPECT_EQ(impossible.last().margins.broken, StepConstraint::kDetermined);
  EXPECT_EQ(impossible.turns.size(), 1U);
  StepPlan no_number = infeasible_gait();
  no_number.gait.com_height_m = std::nan("");
  EXPECT_EQ(compensate({}, {}, no_number).last().margins.broken, StepConstraint::kDetermined);
}

}  // namespace
}  // namespace surefoot::plan
