#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "tools/run/verdict.hpp"

namespace surefoot::batch {

/// One run of a batch: what it changes in the batch's scenario, "key=value" each, as given to `--set`.
struct Trial {
  std::vector<std::string> overrides;
};

/// Many runs of one scenario. A trial runs with `common` overrides first and its own after them, so that a
/// row can be run again alone: `surefoot run FILE --set ...`.
struct Batch {
  std::filesystem::path scenario_file;  ///< empty: the main job
  std::vector<std::string> common;
  std::vector<Trial> trials;
};

/// Where a batch stands, for a progress line.
struct Progress {
  std::size_t done = 0;
  std::size_t all = 0;
  double remaining_wall_s = 0.0;  ///< 0 until it can be estimated
};

/// Runs trials: gives the `journal.hpp` line of each to `take` as soon as it has ended, from any thread.
///
/// @param missing  the trials to run
/// @return false when it was stopped before all of them were given
using Executor = std::function<bool(const std::vector<std::size_t>& missing,
                                    const std::function<void(const std::string& line)>& take)>;

struct BatchOptions {
  unsigned jobs = 0;                                 ///< threads; 0: one for each core
  std::filesystem::path journal;                     ///< finished trials, kept for a resumed batch; empty: none
  const std::atomic<bool>* stop = nullptr;           ///< set from outside: begun trials end, no further one begins
  std::function<void(const Progress&)> on_progress;  ///< called from worker threads, one at a time
  Executor executor;                                 ///< empty: the threads of this process
};

/// The batch was stopped before its last trial; what the journal holds stays valid.
struct Interrupted {
  std::size_t done = 0;
  std::size_t all = 0;
};

/// Verdicts in the order of the trials. Same batch, same verdicts, whatever the number of threads; those
/// fields of a verdict that tell of wall time or of a recording are left empty, and so is `bus`
/// (`verdict_line.cpp` lists what is kept).
///
/// All scenarios are loaded and checked before the first one runs.
/// @throws scenario::ScenarioError with the trial's overrides, or for a journal of another batch or build;
///         run::RecordingFailure where the journal cannot be written; Interrupted
[[nodiscard]] std::vector<run::Verdict> run_batch(const Batch&, const BatchOptions&);

}  // namespace surefoot::batch
