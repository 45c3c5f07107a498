#pragma once

#include <string>
#include <vector>

#include "firmware/core/stabilizer/nominal_table.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::floor {

/// Walks on a flat floor without controllers and averages what the controllers would see, place by place of the step,
/// both feet's steps folded into one.
///
/// @param step_length_m  0 or more
/// @param overrides      as `surefoot run --set` takes them
/// @throws std::runtime_error when the robot falls
/// @throws scenario::ScenarioError for an override that is none
[[nodiscard]] stabilizer::NominalTable record_nominal(double step_length_m, const std::vector<std::string>& overrides);

/// The table as the firmware's sources take it, one sample a line.
[[nodiscard]] std::string to_source(const stabilizer::NominalTable& table);

}  // namespace surefoot::floor
