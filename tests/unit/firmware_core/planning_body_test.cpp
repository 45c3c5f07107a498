#include <gtest/gtest.h>

#include <cmath>

#include "firmware/core/planning/motion_algebra.hpp"
#include "firmware/core/planning/sagittal_body.hpp"

namespace surefoot::planning {
namespace {

constexpr double kGravity_m_s2 = 9.81;

StepPlan rolled_plan() {
  StepPlan plan;
  plan.gait = {.com_height_m = 0.8, .step_length_m = 0.4, .single_support_s = 1.0, .double_support_s = 0.25};
  plan.gait.single_support_share = continuous_single_support_share(0.8, 1.0, 0.25).value();
  plan.foot.toe_angle_rad = plan.foot.heel_angle_rad = 0.2;
  return plan;
}

// The foot is a rigid body that turns about its toe's tip: the ankle stays as far from the tip as it was.
TEST(SagittalBody, TurnsARaisedAnkleAboutTheToeWithTheFoot) {
  const SagittalBody body{.ankle_height_m = 0.1};
  const PlannedStep step(rolled_plan());
  const double toe_m = step.plan().foot.toe_m;
  const double end_s = step.plan().gait.double_support_s - 1e-9;
  const AnklePoint before = ankle_of(body, step.at(0.0).swing);
  const double tip_m = before.x_m.position + toe_m;
  EXPECT_DOUBLE_EQ(before.z_m.position, 0.1);
  for (const double time_s : {0.6 * end_s, 0.8 * end_s, end_s}) {
    const AnklePoint after = ankle_of(body, step.at(time_s).swing);
    EXPECT_GT(after.x_m.position, before.x_m.position);
    EXPECT_NEAR(std::hypot(after.x_m.position - tip_m, after.z_m.position), std::hypot(toe_m, 0.1), 1e-12);
  }
}

TEST(SagittalBody, GivesTheRaisedAnkleTheDerivativesOfItsPlace) {
  const SagittalBody body{.ankle_height_m = 0.1};
  const PlannedStep step(rolled_plan());
  constexpr double kStep_s = 1e-5;
  for (const double time_s : {0.05, 0.2, 0.5, 1.0}) {
    const auto at = [&](double t) { return ankle_of(body, step.at(t).swing); };
    const AnklePoint now = at(time_s);
    const AnklePoint before = at(time_s - kStep_s);
    const AnklePoint after = at(time_s + kStep_s);
    EXPECT_NEAR(now.x_m.velocity, (after.x_m.position - before.x_m.position) / (2.0 * kStep_s), 1e-6);
    EXPECT_NEAR(now.z_m.acceleration, (after.z_m.velocity - before.z_m.velocity) / (2.0 * kStep_s), 1e-5);
  }
}

TEST(SagittalBody, HasItsAnkleOnTheSoleUnlessToldOtherwise) {
  const FootPoint foot = PlannedStep(rolled_plan()).at(0.2).swing;
  const AnklePoint ankle = ankle_of(SagittalBody{}, foot);
  EXPECT_EQ(ankle.x_m.position, foot.x_m.position);
  EXPECT_EQ(ankle.z_m.acceleration, foot.z_m.acceleration);
}

// A point mass: x_zmp = x - z x'' / g, with z above the floor, however high the ankles are.
TEST(SagittalBody, HasItsZmpOnTheFloorBelowTheAnkles) {
  SagittalBody body{.link_m = 0.5, .ankle_height_m = 0.1, .com_above_hip_m = 0.05, .trunk_com_m = 0.05};
  for (double* leg :
       {&body.thigh_kg, &body.shank_kg, &body.foot_kg, &body.thigh_inertia_kg_m2, &body.shank_inertia_kg_m2}) {
    *leg = 1e-12;
  }
  EXPECT_NEAR(body.hip_height_m(0.8), 0.85, 1e-12);
  const PlannedStep step(rolled_plan());
  for (const double time_s : {0.05, 0.2, 0.6, 1.2}) {
    const StepInstant instant = step.at(time_s);
    const auto found = loads(body, body.hip_height_m(0.8), instant, 0.5);
    ASSERT_TRUE(found);
    const gait::ScalarMotion& com = instant.com_x_m;
    EXPECT_NEAR(found->zmp_x_m, com.position - 0.9 * com.acceleration / kGravity_m_s2, 1e-9);
  }
}

}  // namespace
}  // namespace surefoot::planning
