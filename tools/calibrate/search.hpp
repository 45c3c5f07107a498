#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/batch/batch.hpp"
#include "tools/calibrate/calibration.hpp"

namespace surefoot::calibrate {

/// Runs a batch; `what` says what it is for.
using Runner = std::function<std::vector<run::Verdict>(const std::string& what, const batch::Batch& batch)>;

/// Searches the plant whose table without a reflex is nearest to Table 4.1 of El-Kahlout 2003.
///
/// Free are friction and toe length; everything else stays as the plant `thesis` has it. See docs/calibration.md.
/// @throws as the runner
[[nodiscard]] Calibration calibrate(const Search& search, const Runner& run);

}  // namespace surefoot::calibrate
