#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tools/batch/batch.hpp"
#include "tools/floor/criteria_quantities.hpp"

namespace surefoot::floor {

/// What a figure with the controller on shall be.
struct Wanted {
  enum class Kind : std::uint8_t {
    kLess,    ///< clearly below the figure without it: by `kClear_percent`, and not by luck
    kNear,    ///< a printed number, within a tolerance
    kAtMost,  ///< no more than a number
    kBelow,   ///< below the figure without it by so many percent
  };
  Kind kind = Kind::kLess;
  double value = 0.0;  ///< number, or percent
  double tolerance = 0.0;
};

/// A change that counts, percent.
inline constexpr double kClear_percent = 5.0;

/// Sign test, one-sided: how likely at least `less` of the walks that differ are less when a controller does nothing.
[[nodiscard]] double chance_of_luck(std::size_t less, std::size_t more) noexcept;

/// Below this it is not luck. One walk alone cannot be: it is judged by its figure.
inline constexpr double kLuck = 0.05;

enum class CriterionVerdict : std::uint8_t {
  kHolds,
  kDoesNotHelp,  ///< no number is asked for, and the figure with the controller is not clearly less
  kNotShown,     ///< it is less, in too few of the walks to tell it from luck
  kNotMet,       ///< a number is asked for, and missed
  kNoSample,     ///< nothing to judge, such as all runs fallen
};

/// "holds", "does not help", "not shown", "not met", "no sample".
[[nodiscard]] const char* name(CriterionVerdict verdict) noexcept;

/// A figure of the walks of an experiment.
struct Quantity {
  std::string what;
  std::string unit;
  Samples (*samples)(const ObservedWalk&) = nullptr;
  Wanted wanted;
};

/// Walks with one controller and without it, otherwise alike.
struct Experiment {
  stabilizer::Controller controller = stabilizer::Controller::kUprightPose;
  std::string set;                     ///< of the others: "off" or "extended"
  std::string floor;                   ///< and what happens on it, in words
  std::vector<std::string> overrides;  ///< "key=value", of all its walks
  std::vector<batch::Trial> walks;     ///< what differs from walk to walk; at least one
  std::vector<Quantity> quantities;
};

/// One or two for each of the thirteen, in the order of `Controller`.
///
/// @param seeds       of the tiles
/// @param controller  its name; empty: all
[[nodiscard]] std::vector<Experiment> criterion_experiments(const std::vector<std::uint64_t>& seeds,
                                                            const std::string& controller = {});

/// The samples of the walks of an experiment in which the robot falls neither with nor without the controller.
struct Figure {
  std::size_t samples = 0;
  double mean = 0.0;  ///< 0 without samples
};

/// One line of the table.
struct CriterionRow {
  stabilizer::Controller controller = stabilizer::Controller::kUprightPose;
  std::string set;
  std::string floor;
  std::size_t walks = 0;
  std::size_t falls_off = 0;
  std::size_t falls_on = 0;
  std::string what;
  std::string unit;
  Wanted wanted;
  Figure off;
  Figure on;
  std::size_t compared = 0;  ///< walks that both figures have samples of
  std::size_t less = 0;      ///< those of them in which the mean is less with the controller
  std::size_t more = 0;      ///< and more

  /// Of `on` against `off`, percent; nothing where one is missing, `off` is 0, or a number is wanted near.
  [[nodiscard]] std::optional<double> change_percent() const noexcept;
  [[nodiscard]] CriterionVerdict verdict() const noexcept;
};

struct Criteria {
  std::vector<CriterionRow> rows;

  /// Rows that miss their number, or have nothing to judge one by.
  [[nodiscard]] std::size_t missed() const noexcept;
};

struct CriteriaOptions {
  unsigned jobs = 0;                                                   ///< threads; 0: one for each core
  const std::atomic<bool>* stop = nullptr;                             ///< set from outside
  std::function<void(std::size_t done, std::size_t all)> on_progress;  ///< from worker threads, several at a time
};

/// Walks all experiments. Same experiments, same figures, whatever the number of threads.
/// @throws scenario::ScenarioError before the first walk; batch::Interrupted
[[nodiscard]] Criteria measure(const std::vector<Experiment>& experiments, const batch::Batch& base,
                               const CriteriaOptions& options);

[[nodiscard]] std::string criteria_text(const Criteria& criteria);
[[nodiscard]] std::string criteria_csv(const Criteria& criteria);
[[nodiscard]] std::string to_json(const Criteria& criteria);

}  // namespace surefoot::floor
