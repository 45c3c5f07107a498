#include "tools/plan/planned_gait.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tools/plan/nearest.hpp"

namespace surefoot::plan {
namespace {

using planning::FootPoint;
using planning::PlannedStep;
using planning::StepConstraint;

constexpr double kLargestGap_m = 1e-3;
constexpr double kDeepestScrape_m = 1e-3;

double gap_m(const planning::StepPlan& plan) {
  return planning::com_in_double_support(plan.com_method, plan.gait, plan.gait.double_support_s).position -
         plan.gait.double_support_half_way_m();
}

double least_clearance_m(const PlannedStep& step) {
  constexpr int kSamples = 200;
  const planning::GaitFactors& gait = step.plan().gait;
  const planning::FootStep& foot = step.plan().foot;
  double least_m = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kSamples; ++i) {
    const FootPoint swing = step.at(gait.double_support_s + (i + 0.5) / kSamples * gait.single_support_s).swing;
    const double sine = std::sin(swing.pitch_rad.position);
    least_m = std::min(least_m, swing.z_m.position + std::min(-foot.toe_m * sine, foot.heel_m * sine));
  }
  return least_m;
}

/// With a speed to keep only the height is free.
CompensationRules for_speed(const CompensationRules& rules) {
  CompensationRules kept = rules;
  kept.longest_single_support_s = 0.0;
  kept.shortest_step_m = std::numeric_limits<double>::infinity();
  return kept;
}

Compensation at_speed(const PlanRequest& request, double speed_m_s, double step_length_m) {
  planning::StepPlan plan = request.step_plan();
  plan.gait.step_length_m = step_length_m;
  plan.gait.single_support_s = (1.0 - request.rules.double_support_share) * step_length_m / speed_m_s;
  return compensate(request.body, request.limits, plan, for_speed(request.rules));
}

/// The step's length next to the one asked for with which the speed is feasible; that one itself where none is.
Compensation at_speed_with_any_step(const PlanRequest& request, double speed_m_s) {
  constexpr double kFactor = 1.05;
  constexpr int kTries = 40;
  const double wanted_m = request.plan.gait.step_length_m;
  Compensation wanted = at_speed(request, speed_m_s, wanted_m);
  if (wanted.is_feasible()) return wanted;
  for (int i = 1; i <= kTries; ++i) {
    for (const double step_m : {wanted_m * std::pow(kFactor, -i), wanted_m * std::pow(kFactor, i)}) {
      Compensation tried = at_speed(request, speed_m_s, step_m);
      if (tried.is_feasible()) return tried;
    }
  }
  return wanted;
}

Compensation answer(const PlanRequest& request, const PlanOptions& options) {
  if (!options.speed_m_s) return compensate(request.body, request.limits, request.step_plan(), request.rules);
  return options.chooses_step ? at_speed_with_any_step(request, *options.speed_m_s)
                              : at_speed(request, *options.speed_m_s, request.plan.gait.step_length_m);
}

}  // namespace

std::string CheckedGait::broken() const {
  if (margins.broken != StepConstraint::kNone) return planning::name(margins.broken);
  if (std::abs(gap_m) > kLargestGap_m) return "joint";
  return least_clearance_m < -kDeepestScrape_m ? "clearance" : "none";
}

CheckedGait check(const PlanRequest& request, const planning::StepPlan& plan) {
  const PlannedStep step(plan);
  return {.plan = plan,
          .margins = check_step(request.body, request.limits, step, request.body.hip_height_m(plan.gait.com_height_m)),
          .joining_double_support_s = joining_double_support_s(plan.com_method, plan.gait),
          .gap_m = gap_m(plan),
          .least_clearance_m = least_clearance_m(step)};
}

namespace {

CheckedGait answered(const PlanRequest& request, const Compensation& compensation) {
  planning::StepPlan plan = request.step_plan();
  plan.gait = compensation.last().gait;
  return check(request, plan);
}

}  // namespace

bool is_possible(const PlanRequest& request, const PlanOptions& options) {
  if (options.compensates) return answered(request, answer(request, options)).is_feasible();
  planning::StepPlan plan = request.step_plan();
  settle_times(plan.gait.double_support_s / plan.gait.step_s(), plan.com_method, plan.gait);
  return check(request, plan).is_feasible();
}

PlanResult plan_gait(const PlanRequest& request, const PlanOptions& options) {
  PlanResult result;
  result.request = request;
  result.wanted_speed_m_s = options.speed_m_s;
  result.before = result.after = check(request, request.step_plan());
  if (options.compensates) {
    result.compensation = answer(request, options);
    result.after = answered(request, result.compensation);
  }
  if (!result.is_feasible()) result.nearest = nearest_feasible(request, options, result.after.broken());
  return result;
}

}  // namespace surefoot::plan
