#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "firmware/core/planning/motion_algebra.hpp"
#include "firmware/core/planning/step_check.hpp"

namespace surefoot::planning {
namespace {

constexpr double kGravity_m_s2 = 9.81;

StepPlan plan_of(WalkingPattern pattern, double single_support_s = 1.179, double height_m = 0.865) {
  StepPlan plan;
  plan.pattern = pattern;
  plan.gait.com_height_m = height_m;
  plan.gait.single_support_s = single_support_s;
  plan.gait.single_support_share =
      continuous_single_support_share(height_m, single_support_s, 0.25 * single_support_s).value();
  plan.gait.double_support_s = continuous_double_support_s(plan.gait);
  plan.foot.toe_angle_rad = plan.foot.heel_angle_rad = 12.0 * M_PI / 180.0;
  return plan;
}

SagittalBody body_of(double leg_share = 1.0) {
  SagittalBody body{.link_m = 0.47};
  for (double* leg :
       {&body.thigh_kg, &body.shank_kg, &body.foot_kg, &body.thigh_inertia_kg_m2, &body.shank_inertia_kg_m2}) {
    *leg *= leg_share;
  }
  return body;
}

TEST(MotionAlgebra, HasTheDerivativesOfItsFunctions) {
  const auto at = [](double t) {
    const ScalarMotion x{std::sin(t), std::cos(t), -std::sin(t)};
    const ScalarMotion z{2.0 + t * t, 2.0 * t, 2.0};
    return square_root(z) * inverse(z + x) + pitch_of(x, z) - 3.0 * sine(x) * cosine(z);
  };
  constexpr double kStep_s = 1e-5;
  for (const double t : {0.1, 0.7, 2.0}) {
    EXPECT_NEAR(at(t).velocity, (at(t + kStep_s).position - at(t - kStep_s).position) / (2.0 * kStep_s), 1e-7);
    EXPECT_NEAR(at(t).acceleration, (at(t + kStep_s).velocity - at(t - kStep_s).velocity) / (2.0 * kStep_s), 1e-7);
  }
}

TEST(PlannedStep, HandsTheFeetOverWithoutAStepFromOneStepToTheNext) {
  for (const WalkingPattern pattern :
       {WalkingPattern::kFlatFeet, WalkingPattern::kRolledTogether, WalkingPattern::kRolledInTurn}) {
    const PlannedStep step(plan_of(pattern));
    ASSERT_TRUE(step.is_determined());
    const double length_m = step.plan().gait.step_length_m;
    const StepInstant end = step.at(step.plan().gait.step_s() - 1e-12);
    const StepInstant begin = step.at(0.0);
    EXPECT_NEAR(end.com_x_m.position - length_m, begin.com_x_m.position, 1e-9);
    EXPECT_NEAR(end.com_x_m.velocity, begin.com_x_m.velocity, 1e-9);
    for (const auto& [before, after] : {std::pair{end.swing, begin.stance}, std::pair{end.stance, begin.swing}}) {
      EXPECT_NEAR(before.x_m.position - length_m, after.x_m.position, 1e-9);
      EXPECT_NEAR(before.z_m.position, after.z_m.position, 1e-9);
      EXPECT_NEAR(before.pitch_rad.position, after.pitch_rad.position, 1e-9);
      EXPECT_NEAR(before.pitch_rad.velocity, after.pitch_rad.velocity, 1e-8);
    }
  }
}

TEST(PlannedStep, RollsTheFeetTogetherInPatternTwoAndOneAfterTheOtherInPatternThree) {
  const auto pitches = [](WalkingPattern pattern, double share) {
    const PlannedStep step(plan_of(pattern));
    const StepInstant instant = step.at(share * step.plan().gait.double_support_s);
    return std::pair{instant.swing.pitch_rad.position, instant.stance.pitch_rad.position};
  };
  for (const double share : {0.25, 0.75}) {
    const auto [rear, front] = pitches(WalkingPattern::kRolledTogether, share);
    EXPECT_GT(rear, 0.0);
    EXPECT_LT(front, 0.0);
    const auto [flat_rear, flat_front] = pitches(WalkingPattern::kFlatFeet, share);
    EXPECT_EQ(flat_rear, 0.0);
    EXPECT_EQ(flat_front, 0.0);
  }
  const auto [rear_first, front_first] = pitches(WalkingPattern::kRolledInTurn, 0.25);
  EXPECT_NEAR(rear_first, 0.0, 1e-9);
  EXPECT_LT(front_first, 0.0);
  const auto [rear_then, front_then] = pitches(WalkingPattern::kRolledInTurn, 0.75);
  EXPECT_GT(rear_then, 0.0);
  EXPECT_NEAR(front_then, 0.0, 1e-9);
}

// Without legs the body is the pendulum that the gait was planned with.
TEST(SagittalBody, HasThePendulumsZmpWhenItsLegsWeighNothing) {
  const PlannedStep step(plan_of(WalkingPattern::kRolledInTurn));
  const GaitFactors& gait = step.plan().gait;
  for (const double share : {0.02, 0.1, 0.19, 0.3, 0.6, 0.99}) {
    const StepInstant instant = step.at(share * gait.step_s());
    const auto found = loads(body_of(1e-12), gait.com_height_m, instant, 0.5);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->zmp_x_m, ideal_zmp_m(gait, instant.com_x_m), 1e-9);
  }
}

// The floor's moment is the change of angular momentum less gravity's moment, whatever the instants' derivation.
TEST(SagittalBody, BalancesTheMomentsOfItsLinks) {
  const SagittalBody body = body_of();
  const PlannedStep step(plan_of(WalkingPattern::kRolledInTurn, 0.5, 0.86));
  const double height_m = step.plan().gait.com_height_m;
  struct Link {
    double kg, inertia_kg_m2, x_m, z_m, pitch_rad;
  };
  const auto links_at = [&](double time_s) {
    const StepInstant instant = step.at(time_s);
    std::vector<Link> links{{body.trunk_kg, 0.0, instant.com_x_m.position, height_m, 0.0}};
    for (const FootPoint* foot : {&instant.stance, &instant.swing}) {
      const double dx = foot->x_m.position - instant.com_x_m.position;
      const double dz = foot->z_m.position - height_m;
      const double length = std::hypot(dx, dz);
      const double bend = std::acos(0.5 * length / body.link_m);
      const double thigh = std::atan2(-dx, -dz) - bend;  // pitch of the line from the link's lower end to its upper
      const double shank = std::atan2(-dx, -dz) + bend;
      const double knee_x = instant.com_x_m.position - body.link_m * std::sin(thigh);
      const double knee_z = height_m - body.link_m * std::cos(thigh);
      links.push_back({body.thigh_kg, body.thigh_inertia_kg_m2, 0.5 * (knee_x + instant.com_x_m.position),
                       0.5 * (knee_z + height_m), thigh});
      links.push_back({body.shank_kg, body.shank_inertia_kg_m2, 0.5 * (knee_x + foot->x_m.position),
                       0.5 * (knee_z + foot->z_m.position), shank});
      links.push_back({body.foot_kg, 0.0, foot->x_m.position, foot->z_m.position, 0.0});
    }
    return links;
  };
  constexpr double kStep_s = 1e-4;
  for (const double time_s : {0.03, 0.09, 0.2, 0.37, 0.55}) {
    const auto before = links_at(time_s - kStep_s);
    const auto now = links_at(time_s);
    const auto after = links_at(time_s + kStep_s);
    double moment_nm = 0.0;
    double normal_n = 0.0;
    for (std::size_t i = 0; i < now.size(); ++i) {
      const auto second = [&](double Link::*member) {
        return (before[i].*member - 2.0 * now[i].*member + after[i].*member) / (kStep_s * kStep_s);
      };
      const double lift = second(&Link::z_m) + kGravity_m_s2;
      normal_n += now[i].kg * lift;
      moment_nm += now[i].kg * (lift * now[i].x_m - second(&Link::x_m) * now[i].z_m) -
                   now[i].inertia_kg_m2 * second(&Link::pitch_rad);
    }
    const auto found = loads(body, height_m, step.at(time_s), time_s / step.plan().gait.double_support_s);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->normal_n[0] + found->normal_n[1], normal_n, 1e-2);
    EXPECT_NEAR(found->zmp_x_m, moment_nm / normal_n, 1e-5) << time_s;
  }
}

// Al-Shuka et al. 2014, Fig. 15: the ideal ZMP starts double support at the ankle behind. There pattern 2 has a toe
// only, pattern 3 the whole sole.
TEST(StepCheck, FindsTheZmpOutsideByTheToesLengthInPatternTwoAndInsideByTheHeelsInPatternThree) {
  const SagittalBody body = body_of(1e-12);
  const PlannedStep together(plan_of(WalkingPattern::kRolledTogether));
  const StepMargins outside = check_step(body, {}, together, 0.865, 20'000);
  EXPECT_EQ(outside.broken, StepConstraint::kZmp);
  EXPECT_NEAR(outside.least_zmp_margin_m, -together.plan().foot.toe_m, 1e-3);
  EXPECT_LT(outside.least_zmp_margin_at_s, 1e-3);
  const PlannedStep in_turn(plan_of(WalkingPattern::kRolledInTurn));
  const StepMargins inside = check_step(body, {}, in_turn, 0.865, 20'000);
  EXPECT_EQ(inside.broken, StepConstraint::kNone);
  EXPECT_NEAR(inside.least_zmp_margin_m, in_turn.plan().foot.heel_m, 1e-4);
  EXPECT_EQ(inside.zmp_outside_share, 0.0);
}

TEST(StepCheck, NamesTheFirstConstraintThatBreaks) {
  const PlannedStep step(plan_of(WalkingPattern::kRolledInTurn));
  EXPECT_EQ(check_step({.link_m = 0.40}, {}, step, 0.865).broken, StepConstraint::kKnee);
  EXPECT_EQ(check_step(body_of(), {.friction = 0.1}, step, 0.865).broken, StepConstraint::kFriction);
  EXPECT_EQ(check_step(body_of(), {.zmp_margin_m = 0.07}, step, 0.865).broken, StepConstraint::kZmp);
  StepPlan impossible = step.plan();
  impossible.gait.single_support_s = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(check_step(body_of(), {}, PlannedStep(impossible), 0.865).broken, StepConstraint::kDetermined);
  EXPECT_STREQ(name(StepConstraint::kKnee), "knee");
  EXPECT_STREQ(name(static_cast<StepConstraint>(99)), "unknown");
}

// The walk with massless legs slips where the pendulum does.
TEST(StepCheck, AsksForThePendulumsFriction) {
  const PlannedStep step(plan_of(WalkingPattern::kRolledInTurn));
  EXPECT_NEAR(check_step(body_of(1e-12), {}, step, 0.865, 5000).greatest_friction, least_friction(step.plan().gait),
              1e-3);
}

}  // namespace
}  // namespace surefoot::planning
