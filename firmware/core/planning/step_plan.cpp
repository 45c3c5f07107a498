#include "firmware/core/planning/step_plan.hpp"

#include <cmath>

#include "firmware/core/planning/motion_algebra.hpp"

namespace surefoot::planning {
namespace {

FootCase case_of(const StepPlan& plan) noexcept {
  if (plan.pattern == WalkingPattern::kFlatFeet) return plan.lands_hard ? FootCase::kHardFlat : FootCase::kSoftFlat;
  return plan.lands_hard ? FootCase::kHardRolled : FootCase::kSoftRolled;
}

/// Pattern 3 gives each foot one half of double support, pattern 2 all of it to both.
FootStep timed(const StepPlan& plan) noexcept {
  const double share = plan.pattern == WalkingPattern::kRolledTogether ? 1.0 : 0.5;
  FootStep step = plan.foot;
  step.step_length_m = plan.gait.step_length_m;
  step.swing_s = plan.gait.single_support_s;
  step.toe_s = step.heel_s = share * plan.gait.double_support_s;
  return step;
}

FootPoint moved(double by_m, FootPoint foot) noexcept {
  foot.x_m.position += by_m;
  return foot;
}

bool is_possible(const GaitFactors& gait) noexcept {
  return gait.com_height_m > 0.0 && gait.step_length_m > 0.0 && gait.single_support_share > 0.0 &&
         gait.single_support_share < 1.0 && gait.single_support_s > 0.0 && gait.double_support_s > 0.0 &&
         std::isfinite(gait.com_height_m + gait.step_length_m + gait.step_s());
}

}  // namespace

PlannedStep::PlannedStep(const StepPlan& plan) noexcept : plan_(plan), foot_(case_of(plan), timed(plan)) {}

bool PlannedStep::is_determined() const noexcept { return is_possible(plan_.gait) && foot_.is_determined(); }

StepInstant PlannedStep::at(double time_s) const noexcept {
  StepInstant instant;
  if (!is_determined()) return instant;
  const GaitFactors& gait = plan_.gait;
  const double half_m = 0.5 * gait.step_length_m;
  const double lifting_s = gait.double_support_s - foot_.lift_s();  // from the landing until the heel rises
  instant.is_double_support = time_s < gait.double_support_s;
  instant.swing = moved(half_m, foot_.at(time_s - lifting_s));
  instant.stance = moved(-half_m, foot_.at(foot_.landing_s() + time_s));
  instant.com_x_m = instant.is_double_support
                        ? com_in_double_support(plan_.com_method, gait, time_s)
                        : com_in_single_support(gait, time_s - gait.double_support_s) + resting(half_m);
  return instant;
}

}  // namespace surefoot::planning
