#include "firmware/core/gait/planned_stride.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "firmware/core/planning/motion_algebra.hpp"

namespace surefoot::gait {
namespace {

using planning::StepPlan;
using planning::WalkingPattern;

StepPlan plan_of(WalkingPattern pattern, double step_length_m = 0.15, double single_support_s = 1.0) {
  StepPlan plan;
  plan.pattern = pattern;
  plan.gait.com_height_m = 0.57;
  plan.gait.step_length_m = step_length_m;
  plan.gait.single_support_s = single_support_s;
  plan.gait.double_support_s = 0.25 * single_support_s;
  plan.gait.single_support_share =
      planning::continuous_single_support_share(0.57, single_support_s, 0.25 * single_support_s).value();
  plan.foot.toe_m = 0.128;
  plan.foot.heel_m = 0.105;
  plan.foot.toe_angle_rad = 0.14;
  plan.foot.heel_angle_rad = 0.14;
  plan.foot.top_z_m = 0.05;
  return plan;
}

/// A walk from standing on, stride by stride, with the place of each stride's origin.
struct Walk {
  std::vector<PlannedStride> strides{PlannedStride()};
  std::vector<double> origin_x_m{0.0};

  void add(const StepPlan& plan, bool closes = false) {
    const PlannedStride& before = strides.back();
    StrideBorders borders;
    borders.from_m = before.borders().to_m;
    borders.to_m = closes ? 0.0 : plan.gait.step_length_m;
    borders.comes_to_rest = closes;
    const double origin_m = origin_x_m.back() + before.borders().to_m;
    if (strides.size() > 1) {
      borders.com_x_m = before.at(before.duration_s()).com_x_m;
      borders.com_x_m.position += origin_x_m.back() - origin_m;
    }
    strides.emplace_back(plan, borders, before);
    origin_x_m.push_back(origin_m);
  }
};

void expect_joined(const ScalarMotion& end, double end_origin_m, const ScalarMotion& begin, double begin_origin_m) {
  EXPECT_NEAR(end.position + end_origin_m, begin.position + begin_origin_m, 1e-12);
  EXPECT_NEAR(end.velocity, begin.velocity, 1e-10);
  EXPECT_NEAR(end.acceleration, begin.acceleration, 1e-8);
}

/// Start, a slow gait, a fast one, a slow one, stop.
Walk changing_walk(WalkingPattern pattern) {
  Walk walk;
  for (int i = 0; i < 3; ++i) walk.add(plan_of(pattern, 0.10, 1.2));
  for (int i = 0; i < 3; ++i) walk.add(plan_of(pattern, 0.20, 0.8));
  for (int i = 0; i < 2; ++i) walk.add(plan_of(pattern, 0.12, 1.0));
  walk.add(plan_of(pattern, 0.12, 1.0), true);
  return walk;
}

class OfEachPattern : public ::testing::TestWithParam<WalkingPattern> {};

INSTANTIATE_TEST_SUITE_P(PlannedStride, OfEachPattern,
                         ::testing::Values(WalkingPattern::kFlatFeet, WalkingPattern::kRolledTogether,
                                           WalkingPattern::kRolledInTurn));

TEST_P(OfEachPattern, JoinsStrideToStrideUpToTheAcceleration) {
  const Walk walk = changing_walk(GetParam());
  for (std::size_t i = 2; i < walk.strides.size(); ++i) {
    const StrideInstant end = walk.strides[i - 1].at(walk.strides[i - 1].duration_s());
    const StrideInstant begin = walk.strides[i].at(0.0);
    const double end_m = walk.origin_x_m[i - 1];
    const double begin_m = walk.origin_x_m[i];
    expect_joined(end.com_x_m, end_m, begin.com_x_m, begin_m);
    expect_joined(end.swing.x_m, end_m, begin.stance.x_m, begin_m);  // the foot that swung carries now
    expect_joined(end.swing.z_m, 0.0, begin.stance.z_m, 0.0);
    expect_joined(end.swing.pitch_rad, 0.0, begin.stance.pitch_rad, 0.0);
    expect_joined(end.stance.x_m, end_m, begin.swing.x_m, begin_m);
    expect_joined(end.stance.pitch_rad, 0.0, begin.swing.pitch_rad, 0.0);
  }
}

TEST_P(OfEachPattern, HasNoJumpWithinAStride) {
  for (const PlannedStride& stride : changing_walk(GetParam()).strides) {
    constexpr double kStep_s = 1e-4;
    for (double time_s = kStep_s; time_s < stride.duration_s(); time_s += kStep_s) {
      const StrideInstant before = stride.at(time_s - kStep_s);
      const StrideInstant now = stride.at(time_s);
      ASSERT_NEAR(now.com_x_m.position, before.com_x_m.position + kStep_s * before.com_x_m.velocity, 1e-6) << time_s;
      ASSERT_NEAR(now.com_x_m.velocity, before.com_x_m.velocity, 1e-3) << time_s;
      ASSERT_NEAR(now.swing.x_m.position, before.swing.x_m.position, 5e-4) << time_s;
      ASSERT_NEAR(now.swing.z_m.position, before.swing.z_m.position, 5e-4) << time_s;
    }
  }
}

TEST_P(OfEachPattern, StartsFromRestAndEndsThereWithItsFeetSideBySide) {
  const Walk walk = changing_walk(GetParam());
  const StrideInstant begin = walk.strides[1].at(0.0);
  EXPECT_NEAR(begin.com_x_m.position, 0.0, 1e-12);
  EXPECT_NEAR(begin.com_x_m.velocity, 0.0, 1e-12);
  EXPECT_NEAR(begin.com_x_m.acceleration, 0.0, 1e-12);
  const PlannedStride& last = walk.strides.back();
  const StrideInstant end = last.at(last.duration_s());
  EXPECT_NEAR(end.com_x_m.position, 0.0, 1e-12);
  EXPECT_NEAR(end.com_x_m.velocity, 0.0, 1e-10);
  EXPECT_NEAR(end.com_x_m.acceleration, 0.0, 1e-9);
  EXPECT_NEAR(end.swing.x_m.position + (GetParam() == WalkingPattern::kFlatFeet ? 0.0 : 0.105 * (1 - std::cos(0.14))),
              0.0, 1e-12)
      << "beside the other foot, on its heel where it rolls";
  EXPECT_NEAR(walk.origin_x_m.back(), 3 * 0.10 + 3 * 0.20 + 2 * 0.12, 1e-12);
}

// In the middle of a gait nothing is joined: the stride is the planner's step.
TEST_P(OfEachPattern, IsThePlannersStepInTheMiddleOfAGait) {
  const StepPlan plan = plan_of(GetParam());
  Walk walk;
  for (int i = 0; i < 4; ++i) walk.add(plan);
  const planning::PlannedStep step(plan);
  for (double time_s = 0.0; time_s < plan.gait.step_s(); time_s += 0.01) {
    const planning::StepInstant planned = step.at(time_s);
    const StrideInstant walked = walk.strides.back().at(time_s);
    EXPECT_NEAR(walked.com_x_m.position, planned.com_x_m.position - 0.075, 1e-9) << time_s;
    EXPECT_NEAR(walked.com_x_m.acceleration, planned.com_x_m.acceleration, 1e-6) << time_s;
    EXPECT_NEAR(walked.swing.x_m.position, planned.swing.x_m.position - 0.075, 1e-12) << time_s;
    EXPECT_NEAR(walked.stance.pitch_rad.position, planned.stance.pitch_rad.position, 1e-12) << time_s;
  }
}

TEST(PlannedGaits, AreWalkedOneAfterTheOther) {
  PlannedGaits gaits;
  gaits.count = 3;
  for (std::size_t i = 0; i < 3; ++i) {
    gaits.gait[i] = {plan_of(WalkingPattern::kFlatFeet, 0.1 * static_cast<double>(i + 1)), 2};
  }
  EXPECT_EQ(gaits.steps(), 6U);
  const std::vector<double> expected{0.1, 0.1, 0.2, 0.2, 0.3, 0.3, 0.3, 0.3};
  for (std::uint32_t step = 0; step < expected.size(); ++step) {
    EXPECT_NEAR(gaits.of_step(step).gait.step_length_m, expected[step], 1e-12) << step;
  }
  gaits.gait[2].steps = 0;
  EXPECT_EQ(gaits.steps(), 0U) << "without end";
  EXPECT_EQ(PlannedGaits{}.steps(), 0U);
}

}  // namespace
}  // namespace surefoot::gait
