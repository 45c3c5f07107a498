#pragma once

#include <vector>

#include "tools/plan/planned_gait.hpp"

namespace surefoot::plan {

/// The three patterns with each of the three ways of the centre of mass, all of the same height, step and T_s; T_d and
/// p as each joins. The height is that of the gait, or the one below it at which no pattern stretches a knee: level
/// feet need longer legs than feet that roll.
[[nodiscard]] std::vector<CheckedGait> compare(const PlanRequest& request, planning::GaitFactors gait);

}  // namespace surefoot::plan
