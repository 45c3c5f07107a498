#pragma once

#include <vector>

#include "tools/scenario/checks.hpp"

namespace surefoot::scenario {

/// Gaits that no leg reaches, whose supports do not join, or that are never walked.
void check_planned_gaits(const Scenario& scenario, std::vector<Finding>& findings);

}  // namespace surefoot::scenario
