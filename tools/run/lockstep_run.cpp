#include "tools/run/lockstep_run.hpp"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "tools/run/lockstep_loop.hpp"
#include "tools/run/open_recorder.hpp"

namespace surefoot::run {

Verdict run_lockstep(scenario::Scenario scenario, const RunOptions& options) {
  const Schedule schedule = schedule_of(scenario);
  scenario = scheduled(std::move(scenario));
  const std::unique_ptr<host::RunRecorder> recorder = open_recorder(scenario, options.folder, options.is_live);
  LockstepLoop loop(scenario, recorder.get(), options.is_live);
  loop.run_to(schedule.ticks, options);
  Verdict verdict = loop.finish();
  if (!recorder) return verdict;

  const host::RecordingSummary recorded = recorder->finish();
  verdict.bus_log_sha256 = recorded.bus_log_sha256;
  verdict.frames_lost += recorded.frames_dropped;
  if (recorded.error) {
    throw RecordingFailure(
        fmt::format("{}\n  the run ended at {:.3f} s; what was recorded until then is kept\n  remedy: "
                    "free disk space, or name another folder with --out",
                    recorded.error->message, verdict.ended_at_s));
  }
  write_whole_file(options.folder / "verdict.json", to_json(verdict));
  return verdict;
}

}  // namespace surefoot::run
