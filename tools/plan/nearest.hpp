#pragma once

#include <string>
#include <vector>

#include "tools/plan/planned_gait.hpp"

namespace surefoot::plan {

/// Values next to those asked for that make an infeasible request feasible, each by itself; where no single one does,
/// those of the limits and the legs that do so together. Where only a check is asked for, T_d and p follow from T_s and
/// its share of the step's time, and the gait's own values are searched too.
/// @param broken  the constraint that is: what it depends on is searched
/// Cost: some hundred to a few thousand checks of a step.
[[nodiscard]] std::vector<Remedy> nearest_feasible(const PlanRequest& request, const PlanOptions& options,
                                                   const std::string& broken);

}  // namespace surefoot::plan
