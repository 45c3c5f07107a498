#include "tools/plan/comparison.hpp"

#include <algorithm>

namespace surefoot::plan {
namespace {

std::vector<CheckedGait> gaits_of(const PlanRequest& request, const planning::GaitFactors& gait) {
  std::vector<CheckedGait> gaits;
  for (std::size_t pattern = 0; pattern < kPatterns.size(); ++pattern) {
    for (std::size_t method = 0; method < kComMethods.size(); ++method) {
      planning::StepPlan plan = request.step_plan();
      plan.gait = gait;
      plan.pattern = static_cast<planning::WalkingPattern>(pattern);
      plan.com_method = static_cast<planning::ComMethod>(method);
      settle_times(request.rules.double_support_share, plan.com_method, plan.gait);
      gaits.push_back(check(request, plan));
    }
  }
  return gaits;
}

}  // namespace

std::vector<CheckedGait> compare(const PlanRequest& request, planning::GaitFactors gait) {
  const auto is_stretched = [](const CheckedGait& checked) { return checked.broken() == "knee"; };
  std::vector<CheckedGait> gaits = gaits_of(request, gait);
  while (gait.com_height_m > request.rules.height_step_m && std::ranges::any_of(gaits, is_stretched)) {
    gait.com_height_m -= request.rules.height_step_m;
    gaits = gaits_of(request, gait);
  }
  return gaits;
}

}  // namespace surefoot::plan
