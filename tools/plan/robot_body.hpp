#pragma once

#include "firmware/core/planning/sagittal_body.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::plan {

/// A scenario's robot in the sagittal plane: both links of a leg as long as their mean, slender rods; the trunk's mass
/// above the hip, whatever it is ahead of or behind it: the walk moves its pelvis so that the centre of mass is over
/// the feet. Its height above the hip is that of the stance in `gait.body_height_m`.
[[nodiscard]] planning::SagittalBody sagittal_body(const scenario::Scenario& scenario);

}  // namespace surefoot::plan
