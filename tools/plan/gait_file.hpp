#pragma once

#include <span>
#include <string>

#include "tools/plan/planned_gait.hpp"

namespace surefoot::plan {

inline constexpr std::size_t kMostGaits = 8;  ///< that a scenario takes

/// A gait file: the scenario in which the request's robot walks these gaits one after the other, `surefoot run` walks
/// it.
/// @param gaits  1 to `kMostGaits`, feasible, all of one robot
/// @param steps  with each gait; then the feet close and the robot stands
[[nodiscard]] std::string gait_file_text(std::span<const PlanResult> gaits, int steps);

}  // namespace surefoot::plan
