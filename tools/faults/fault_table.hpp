#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "tools/faults/fault_catalogue.hpp"
#include "tools/faults/fault_trial.hpp"

namespace surefoot::faults {

/// One fault in every situation.
struct FaultRow {
  CatalogueEntry entry;
  std::array<TrialResult, kSituations.size()> result;  ///< by `Situation`
};

/// Tries every entry in every situation, on as many threads as there are processors.
///
/// @param on_progress  called from any thread, one at a time, after each trial
[[nodiscard]] std::vector<FaultRow> try_all(const scenario::Scenario& scenario,
                                            const std::vector<CatalogueEntry>& entries,
                                            const std::function<void(std::size_t done, std::size_t all)>& on_progress);

/// A table in Markdown: "fault 8, damp, 12 ticks; fell 1.3 s" in each cell.
[[nodiscard]] std::string to_markdown(const std::vector<FaultRow>& rows);

/// An array of {what, situation, fault, fault_name, safe_state, answer_ticks, fell_after_s, ...}.
[[nodiscard]] std::string to_json(const std::vector<FaultRow>& rows);

}  // namespace surefoot::faults
