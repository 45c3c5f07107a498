#include "tools/batch/batch.hpp"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <optional>
#include <utility>

#include "tools/batch/finished_trials.hpp"
#include "tools/batch/journal.hpp"
#include "tools/batch/load_trial.hpp"
#include "tools/batch/local_executor.hpp"

namespace surefoot::batch {
namespace {

using WallClock = std::chrono::steady_clock;

/// Tells how far a batch is.
class ProgressTeller {
 public:
  ProgressTeller(const BatchOptions& options, std::size_t done, std::size_t all)
      : options_(options), done_before_(done), progress_{done, all, 0.0} {}

  void one_done() {
    ++progress_.done;
    const std::chrono::duration<double> elapsed = WallClock::now() - start_;
    progress_.remaining_wall_s = elapsed.count() * static_cast<double>(progress_.all - progress_.done) /
                                 static_cast<double>(progress_.done - done_before_);
    if (options_.on_progress) options_.on_progress(progress_);
  }
  [[nodiscard]] Interrupted interrupted() const noexcept { return {progress_.done, progress_.all}; }

 private:
  const BatchOptions& options_;
  std::size_t done_before_;
  Progress progress_;
  WallClock::time_point start_ = WallClock::now();
};

}  // namespace

std::vector<run::Verdict> run_batch(const Batch& batch, const BatchOptions& options) {
  FinishedTrials finished(check_trials(batch, all_trials(batch.trials.size()), options.jobs));
  std::optional<Journal> journal;
  if (!options.journal.empty()) journal.emplace(options.journal, finished);

  const std::vector<std::size_t> missing = finished.missing();
  ProgressTeller teller(options, batch.trials.size() - missing.size(), batch.trials.size());
  std::mutex mutex;
  const auto take = [&](const std::string& line) {
    const std::scoped_lock lock(mutex);
    finished.take("executor", line);  // every verdict goes through its line, as a resumed batch would read it
    if (journal) journal->append(line);
    teller.one_done();
  };
  const Executor& executor = options.executor;
  const bool is_complete = missing.empty() || (executor ? executor(missing, take)
                                                        : run_locally(batch, finished.hashes(), missing,
                                                                      {options.jobs, options.stop}, take));
  if (!is_complete || !finished.missing().empty()) throw teller.interrupted();
  return std::move(finished).verdicts();
}

}  // namespace surefoot::batch
