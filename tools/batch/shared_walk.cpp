#include "tools/batch/shared_walk.hpp"

#include <utility>

#include "tools/run/schedule.hpp"
#include "tools/run/shared_past.hpp"

namespace surefoot::batch {
namespace {

constexpr std::int64_t kTicksBetweenStops = 100;

}  // namespace

SharedWalk::SharedWalk(const std::vector<LoadedTrial>& trials) : trials_(trials), walk_of_(trials.size(), nullptr) {
  for (std::size_t trial = 0; trial < trials.size(); ++trial) {
    const std::string key = run::past_key(trials[trial].scenario);
    if (key.empty()) continue;
    walk_of_[trial] = &walks_[key];
    ++walk_of_[trial]->trials;
  }
  for (Walk*& walk : walk_of_) {
    if (walk != nullptr && walk->trials == 1) walk = nullptr;
  }
}

run::Verdict SharedWalk::run(std::size_t trial) {
  Walk* const walk = walk_of_[trial];
  if (walk == nullptr) return run::run_lockstep(trials_[trial].scenario, {});

  const scenario::Scenario scenario = run::scheduled(trials_[trial].scenario);
  run::LockstepLoop loop(*last_stop_before(*walk, scenario), scenario);
  loop.run_to(run::schedule_of(scenario).ticks, {});
  run::Verdict verdict = loop.finish();
  const std::scoped_lock lock(walk->mutex);
  if (--walk->trials == 0) walk->stops.clear();
  return verdict;
}

SharedWalk::Stop SharedWalk::last_stop_before(Walk& walk, const scenario::Scenario& scenario) {
  const std::int64_t tick = run::undisturbed_ticks(scenario) / kTicksBetweenStops * kTicksBetweenStops;
  const std::scoped_lock lock(walk.mutex);
  const auto next = walk.stops.upper_bound(tick);
  if (next != walk.stops.begin() && std::prev(next)->first == tick) return std::prev(next)->second;

  const scenario::Scenario walking = run::undisturbed(scenario);
  const auto loop = next == walk.stops.begin() ? std::make_shared<run::LockstepLoop>(walking, nullptr, false)
                                               : std::make_shared<run::LockstepLoop>(*std::prev(next)->second, walking);
  loop->run_to(tick, {});
  return walk.stops[tick] = loop;
}

}  // namespace surefoot::batch
