#include "tools/plan/compensation.hpp"

#include <fmt/format.h>

#include <optional>

namespace surefoot::plan {
namespace {

using planning::GaitFactors;
using planning::StepConstraint;

/// @return what was changed; empty where nothing is left to change
std::string slow_down(const CompensationRules& rules, const char* reason, GaitFactors& gait) {
  const double slower_s = rules.slower * gait.single_support_s;
  if (slower_s <= rules.longest_single_support_s) {
    gait.single_support_s = slower_s;
    return fmt::format("{}: T_s to {:.3f} s", reason, slower_s);
  }
  if (rules.shorter * gait.step_length_m < rules.shortest_step_m) return {};
  gait.step_length_m *= rules.shorter;
  return fmt::format("{}: S to {:.3f} m", reason, gait.step_length_m);
}

std::string change_for(StepConstraint broken, const CompensationRules& rules, GaitFactors& gait) {
  switch (broken) {
    case StepConstraint::kKnee:
      gait.com_height_m -= rules.height_step_m;
      return fmt::format("a knee is stretched: H to {:.3f} m", gait.com_height_m);
    case StepConstraint::kLift:
      return slow_down(rules, "a foot would have to pull", gait);
    case StepConstraint::kFriction:
      return slow_down(rules, "a foot slips", gait);
    case StepConstraint::kZmp:
      return slow_down(rules, "the ZMP leaves its support", gait);
    default:
      return {};
  }
}

}  // namespace

bool settle_times(double double_support_share, planning::ComMethod method, GaitFactors& gait) {
  gait.double_support_s = gait.single_support_s * double_support_share / (1.0 - double_support_share);
  const std::optional<double> share =
      planning::continuous_single_support_share(gait.com_height_m, gait.single_support_s, gait.double_support_s);
  if (!share) return false;
  gait.single_support_share = *share;
  gait.double_support_s = joining_double_support_s(method, gait);
  return true;
}

double joining_double_support_s(planning::ComMethod method, const GaitFactors& gait) {
  return method == planning::ComMethod::kMirroredAcceleration ? planning::mirrored_double_support_s(gait)
                                                              : planning::continuous_double_support_s(gait);
}

Compensation compensate(const planning::SagittalBody& body, const planning::StepLimits& limits,
                        const planning::StepPlan& wanted, const CompensationRules& rules) {
  Compensation result;
  planning::StepPlan plan = wanted;
  for (int i = 0; i < rules.most_iterations; ++i) {
    CompensationTurn turn;
    const bool has_share = settle_times(rules.double_support_share, plan.com_method, plan.gait);
    turn.gait = plan.gait;
    if (has_share) {
      turn.margins = check_step(body, limits, planning::PlannedStep(plan), body.hip_height_m(plan.gait.com_height_m));
    } else {
      turn.margins.broken = StepConstraint::kDetermined;
    }
    turn.change = change_for(turn.margins.broken, rules, plan.gait);
    const bool goes_on = !turn.change.empty() && plan.gait.com_height_m > 0.0;
    result.turns.push_back(std::move(turn));
    if (!goes_on) break;
  }
  return result;
}

}  // namespace surefoot::plan
