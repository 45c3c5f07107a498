#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "tools/batch/load_trial.hpp"
#include "tools/run/lockstep_loop.hpp"

namespace surefoot::batch {

/// Runs trials, and walks what several of them have in common once: start-up, learning and the gait until the first
/// payload or push. Verdicts are those of `run::run_lockstep`, to the last bit, but for wall times.
///
/// Trials share a walk when they differ in payloads, pushes, duration and limits alone. The walk is kept at stops
/// 0.1 s apart until its last trial is over; a stop takes about 0.2 MB.
class SharedWalk {
 public:
  /// @param trials  outlives this object
  explicit SharedWalk(const std::vector<LoadedTrial>& trials);

  /// Runs a trial; each once. May be called from many threads at once.
  ///
  /// @param trial  its place among those of the constructor
  [[nodiscard]] run::Verdict run(std::size_t trial);

 private:
  using Stop = std::shared_ptr<const run::LockstepLoop>;

  struct Walk {
    std::mutex mutex;
    std::map<std::int64_t, Stop> stops;  ///< by tick
    std::size_t trials = 0;              ///< that will still be run
  };

  static Stop last_stop_before(Walk&, const scenario::Scenario&);

  const std::vector<LoadedTrial>& trials_;
  std::vector<Walk*> walk_of_;  ///< by trial
  std::map<std::string, Walk> walks_;
};

}  // namespace surefoot::batch
