#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tools/batch/batch.hpp"
#include "tools/table/cell.hpp"
#include "tools/table/experiment.hpp"
#include "tools/table/grid.hpp"

namespace surefoot::table {

/// The same table on a band of plants: floor friction by toe length.
struct Band {
  std::string method;
  std::string plant;
  std::vector<double> frictions;
  std::vector<double> toes_m;  ///< geometry.sole_toe_m
  Grid grid;
  std::vector<Cell> cells;  ///< the grid's, for each friction, for each toe

  /// Cells of the grid that survive on one plant.
  [[nodiscard]] std::size_t survive(std::size_t friction, std::size_t toe) const;
};

/// 0.8, 1 and 1.25 times the scenario's friction; its toe, 4 mm less and 4 mm more.
struct BandAxes {
  std::vector<double> frictions;
  std::vector<double> toes_m;
};
[[nodiscard]] BandAxes band_around(const scenario::Scenario& scenario);

/// @throws scenario::ScenarioError
[[nodiscard]] batch::Batch band_batch(const Experiment& experiment, const BandAxes& axes, const Grid& grid);

/// @param verdicts  of the batch above
[[nodiscard]] Band band_of(const Experiment& experiment, const BandAxes& axes, const Grid& grid,
                           const std::vector<run::Verdict>& verdicts);

/// Counts as a matrix, friction by toe.
[[nodiscard]] std::string band_text(const Band& band);

[[nodiscard]] std::string band_csv(const Band& band);

[[nodiscard]] std::string to_json(const Band& band);

}  // namespace surefoot::table
