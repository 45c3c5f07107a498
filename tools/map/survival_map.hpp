#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tools/batch/batch.hpp"
#include "tools/map/map_spec.hpp"
#include "tools/run/verdict.hpp"

namespace surefoot::map {

/// What each method survives of a specification's disturbances.
struct SurvivalMap {
  MapSpec spec;
  std::string plant;
  std::vector<std::size_t> survive;  ///< of the repeats: for each method, row by row

  [[nodiscard]] std::size_t at(std::size_t method, std::size_t row, std::size_t column) const {
    return survive.at((method * spec.rows.values.size() + row) * spec.columns.values.size() + column);
  }
  [[nodiscard]] std::size_t total(std::size_t method) const;
  /// Runs of one method.
  [[nodiscard]] std::size_t runs() const {
    return spec.rows.values.size() * spec.columns.values.size() * spec.repeats.values.size();
  }
};

/// All runs: methods, rows, columns, repeats, the last one fastest. Each lasts until two gait cycles after the recovery
/// from its last load, removal or push, unless the specification sets duration_s.
///
/// @param base  scenario and overrides of every run; those of the specification win over them
/// @throws scenario::ScenarioError
[[nodiscard]] batch::Batch map_batch(const MapSpec& spec, const batch::Batch& base);

/// @param verdicts  of the batch above
[[nodiscard]] SurvivalMap map_of(const MapSpec& spec, const std::string& plant,
                                 const std::vector<run::Verdict>& verdicts);

/// A panel for each method: survivors in each cell, of the repeats.
[[nodiscard]] std::string map_text(const SurvivalMap& map);
[[nodiscard]] std::string map_csv(const SurvivalMap& map);
[[nodiscard]] std::string to_json(const SurvivalMap& map);

}  // namespace surefoot::map
