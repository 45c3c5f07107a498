#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tools/batch/batch.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::batch {

/// A trial, ready to run.
struct LoadedTrial {
  scenario::Scenario scenario;
  std::string hash;  ///< of the effective scenario: 16 hexadecimal digits
};

/// One trial's scenario, read and checked.
/// @throws scenario::ScenarioError
[[nodiscard]] LoadedTrial load_trial(const Batch& batch, std::size_t trial);

/// Reads and checks some trials' scenarios.
///
/// @return the hash of every trial of the batch; empty for those not among `trials`
/// @throws scenario::ScenarioError of the first trial that cannot be run
[[nodiscard]] std::vector<std::string> check_trials(const Batch& batch, const std::vector<std::size_t>& trials,
                                                    unsigned jobs);

/// 0 to count - 1.
[[nodiscard]] std::vector<std::size_t> all_trials(std::size_t count);

}  // namespace surefoot::batch
