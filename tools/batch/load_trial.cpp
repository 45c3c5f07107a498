#include "tools/batch/load_trial.hpp"

#include <numeric>

#include "firmware/host/sha256.hpp"
#include "tools/batch/parallel_for.hpp"

namespace surefoot::batch {

LoadedTrial load_trial(const Batch& batch, std::size_t trial) {
  std::vector<std::string> overrides = batch.common;
  const std::vector<std::string>& own = batch.trials.at(trial).overrides;
  overrides.insert(overrides.end(), own.begin(), own.end());
  LoadedTrial loaded{
      batch.scenario_file.empty() ? scenario::load_default(overrides) : scenario::load(batch.scenario_file, overrides),
      ""};
  const std::string text = scenario::to_toml(loaded.scenario);
  host::Sha256 digest;
  digest.update(text.data(), text.size());
  loaded.hash = digest.hex().substr(0, 16);
  return loaded;
}

std::vector<std::string> check_trials(const Batch& batch, const std::vector<std::size_t>& trials, unsigned jobs) {
  std::vector<std::string> hashes(batch.trials.size());
  parallel_for(trials.size(), {jobs, nullptr},
               [&](std::size_t place) { hashes[trials[place]] = load_trial(batch, trials[place]).hash; });
  return hashes;
}

std::vector<std::size_t> all_trials(std::size_t count) {
  std::vector<std::size_t> trials(count);
  std::iota(trials.begin(), trials.end(), std::size_t{0});
  return trials;
}

}  // namespace surefoot::batch
