#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "firmware/core/gait/planned_stride.hpp"

namespace surefoot::gait {
namespace {

double uniform(double low, double high) { return low + (high - low) * (*rc::gen::inRange(0, 1'000'001)) * 1e-6; }

/// Any gait whose supports join, of any pattern, landing softly or hard.
planning::StepPlan any_plan() {
  planning::StepPlan plan;
  plan.pattern = *rc::gen::element(planning::WalkingPattern::kFlatFeet, planning::WalkingPattern::kRolledTogether,
                                   planning::WalkingPattern::kRolledInTurn);
  plan.com_method = *rc::gen::element(planning::ComMethod::kSharedPressure, planning::ComMethod::kHangingPendulum);
  plan.lands_hard = *rc::gen::arbitrary<bool>();
  plan.gait.com_height_m = uniform(0.3, 1.2);
  plan.gait.step_length_m = uniform(0.02, 0.6);
  plan.gait.single_support_s = uniform(0.3, 2.0);
  plan.gait.single_support_share = uniform(0.3, 0.9);
  plan.gait.double_support_s = planning::continuous_double_support_s(plan.gait);
  plan.foot.toe_angle_rad = uniform(0.0, 0.6);
  plan.foot.heel_angle_rad = uniform(0.0, 0.6);
  return plan;
}

void assert_joined(const ScalarMotion& end, double moved_m, const ScalarMotion& begin) {
  RC_ASSERT(std::abs(end.position - moved_m - begin.position) < 1e-9);
  RC_ASSERT(std::abs(end.velocity - begin.velocity) < 1e-8 * (1.0 + std::abs(end.velocity)));
  RC_ASSERT(std::abs(end.acceleration - begin.acceleration) < 1e-6 * (1.0 + std::abs(end.acceleration)));
}

// Whatever gaits follow each other, the centre of mass goes on from stride to stride up to its acceleration, and the
// foot that was set down stays where it is.
RC_GTEST_PROP(PlannedStride, JoinsAnyGaitToAnyOther, ()) {
  PlannedStride before;
  bool before_hits = false;  // a level foot of case 2 hits the floor and stops there
  for (int i = 0; i < 4; ++i) {
    const planning::StepPlan plan = any_plan();
    const bool closes = i == 3;
    StrideBorders borders;
    borders.from_m = before.borders().to_m;
    borders.to_m = closes ? 0.0 : plan.gait.step_length_m;
    borders.comes_to_rest = closes;
    const StrideInstant end = before.at(before.duration_s());
    if (i > 0) {
      borders.com_x_m = end.com_x_m;
      borders.com_x_m.position -= before.borders().to_m;
    }
    const PlannedStride stride(plan, borders, before);
    const StrideInstant begin = stride.at(0.0);
    assert_joined(borders.com_x_m, 0.0, begin.com_x_m);
    RC_ASSERT(std::abs(end.swing.x_m.position - before.borders().to_m - begin.stance.x_m.position) < 1e-9);
    RC_ASSERT(std::abs(end.swing.z_m.position - begin.stance.z_m.position) < 1e-9);
    if (!before_hits) {
      assert_joined(end.swing.x_m, before.borders().to_m, begin.stance.x_m);
      assert_joined(end.swing.z_m, 0.0, begin.stance.z_m);
      assert_joined(end.swing.pitch_rad, 0.0, begin.stance.pitch_rad);
    }
    RC_ASSERT(std::abs(begin.swing.x_m.position + borders.from_m) < 1e-9);
    before = stride;
    before_hits = plan.lands_hard && plan.pattern == planning::WalkingPattern::kFlatFeet;
  }
  const StrideInstant rest = before.at(before.duration_s());
  assert_joined(rest.com_x_m, 0.0, {});
}

}  // namespace
}  // namespace surefoot::gait
