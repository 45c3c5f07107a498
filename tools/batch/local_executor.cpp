#include "tools/batch/local_executor.hpp"

#include <algorithm>
#include <span>

#include "tools/batch/load_trial.hpp"
#include "tools/batch/shared_walk.hpp"
#include "tools/batch/verdict_line.hpp"

namespace surefoot::batch {
namespace {

/// Loaded scenarios are some kB each, and there may be a million trials.
constexpr std::size_t kLoadedAtOnce = 4096;

/// @throws scenario::ScenarioError when one is no longer what was checked
std::vector<LoadedTrial> load_checked(const Batch& batch, const std::vector<std::string>& hashes,
                                      std::span<const std::size_t> trials, unsigned jobs) {
  std::vector<LoadedTrial> loaded(trials.size());
  parallel_for(trials.size(), {jobs, nullptr}, [&](std::size_t place) {
    loaded[place] = load_trial(batch, trials[place]);
    if (loaded[place].hash != hashes[trials[place]]) {
      throw scenario::ScenarioError({{batch.scenario_file.string(), "was changed while the batch ran",
                                      "remove the journal and begin anew, with the file left alone"}});
    }
  });
  return loaded;
}

}  // namespace

bool run_locally(const Batch& batch, const std::vector<std::string>& hashes, const std::vector<std::size_t>& trials,
                 const ParallelOptions& options, const std::function<void(const std::string& line)>& take) {
  for (std::size_t begin = 0; begin < trials.size(); begin += kLoadedAtOnce) {
    const auto some = std::span(trials).subspan(begin, std::min(kLoadedAtOnce, trials.size() - begin));
    const std::vector<LoadedTrial> loaded = load_checked(batch, hashes, some, options.jobs);
    SharedWalk walk(loaded);
    const bool is_complete = parallel_for(some.size(), options, [&](std::size_t place) {
      take(line_of({some[place], loaded[place].hash, walk.run(place)}));
    });
    if (!is_complete) return false;
  }
  return true;
}

}  // namespace surefoot::batch
