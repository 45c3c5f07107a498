#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/plan/request.hpp"

namespace surefoot::plan {

/// A planned step at one instant, with what the floor does. Frame: `planning::StepInstant`.
struct PlanSample {
  double time_s = 0.0;  ///< since the foot ahead landed
  planning::StepInstant instant;
  double ideal_zmp_m = 0.0;                  ///< of the point mass that the gait was planned with
  std::optional<planning::StepLoads> loads;  ///< of the bodies in motion; nothing where a knee is stretched
  planning::SupportEdges edges;
};

/// Evenly spaced over a step, both its ends among them.
/// @param count  2 or more
[[nodiscard]] std::vector<PlanSample> samples_of(const PlanRequest& request, const planning::StepPlan& plan, int count);

/// One row a sample: COG, ZMP, support, both feet with their loads.
[[nodiscard]] std::string samples_csv(const std::vector<PlanSample>& samples);

}  // namespace surefoot::plan
