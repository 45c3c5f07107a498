#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "tools/batch/batch.hpp"
#include "tools/batch/parallel_for.hpp"

namespace surefoot::batch {

/// Runs trials on the threads of this process; the lines are given from them.
///
/// @param hashes  of `check_trials`
/// @return false when it was stopped before the last trial began
/// @throws scenario::ScenarioError when the scenario file has changed since
bool run_locally(const Batch& batch, const std::vector<std::string>& hashes, const std::vector<std::size_t>& trials,
                 const ParallelOptions& options, const std::function<void(const std::string& line)>& take);

}  // namespace surefoot::batch
