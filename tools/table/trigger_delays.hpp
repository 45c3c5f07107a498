#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tools/batch/batch.hpp"
#include "tools/table/experiment.hpp"
#include "tools/table/grid.hpp"

namespace surefoot::table {

/// Time from a load to its detection.
struct PrintedDelay {
  Load load;
  double delay_s = 0.0;
};

/// The instants that El-Kahlout 2003 prints: sections 4.1.2 and 4.3, figures 3.7, 4.6 and 4.7.
inline constexpr std::array kThesisDelays{PrintedDelay{{5.0, 1.2}, 0.0625}, PrintedDelay{{15.0, 1.2}, 0.0305},
                                          PrintedDelay{{15.0, 1.3}, 0.0325}, PrintedDelay{{15.0, 1.9}, 0.0725}};

/// Longest delay that is waited for: a payload that is not seen until then counts as not seen.
inline constexpr double kLongestDelay_s = 1.0;

/// How long each load of a grid went unseen.
struct TriggerDelays {
  std::string method;
  std::string plant;
  Grid grid;
  std::vector<std::optional<double>> delays_s;  ///< in the grid's order; nothing: not seen in time
};

/// Short runs, which end before what the reflex does can be judged.
[[nodiscard]] batch::Batch delay_batch(const Experiment& experiment, const Grid& grid);

/// @param verdicts  of the batch above
[[nodiscard]] TriggerDelays delays_of(const Experiment& experiment, const Grid& grid,
                                      const std::vector<run::Verdict>& verdicts);

/// Milliseconds as a matrix, then shortest, middle and longest of each load, and the thesis' instants beside ours.
[[nodiscard]] std::string delay_text(const TriggerDelays& study);
[[nodiscard]] std::string delay_csv(const TriggerDelays& study);
[[nodiscard]] std::string to_json(const TriggerDelays& study);

}  // namespace surefoot::table
