#pragma once

#include <span>
#include <string>

#include "tools/plan/planned_gait.hpp"

namespace surefoot::plan {

/// For people: each turn of the compensation, the gait before and after, the verdict.
[[nodiscard]] std::string plan_text(const PlanResult& result);

/// The patterns beside each other.
[[nodiscard]] std::string comparison_text(std::span<const CheckedGait> gaits);

/// One line a gait of a library.
[[nodiscard]] std::string library_text(std::span<const PlanResult> gaits);

/// What is broken, in words with its numbers: "a foot slips: it needs a friction of 0.21, limits.friction is 0.1".
[[nodiscard]] std::string complaint(const PlanRequest& request, const CheckedGait& gait);

/// What to do about an infeasible request: the nearest values with which everything holds.
[[nodiscard]] std::string remedy_text(const PlanResult& result);

}  // namespace surefoot::plan
