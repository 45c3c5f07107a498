#pragma once

#include <span>
#include <string>

#include "tools/plan/planned_gait.hpp"

namespace surefoot::plan {

/// The result for programs: request, turns, gait before and after, verdict, nearest feasible values.
[[nodiscard]] std::string to_json(const PlanResult& result);

/// The same with samples over a step, before, after and for each of the patterns: what the picture is drawn from.
[[nodiscard]] std::string picture_json(const PlanResult& result);

/// An array of the compared gaits.
[[nodiscard]] std::string to_json(std::span<const CheckedGait> gaits);

/// An array of a library's results.
[[nodiscard]] std::string to_json(std::span<const PlanResult> gaits);

}  // namespace surefoot::plan
