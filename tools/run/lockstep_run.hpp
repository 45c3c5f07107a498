#pragma once

#include <atomic>
#include <filesystem>
#include <functional>

#include "tools/run/run_folder.hpp"
#include "tools/run/verdict.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::run {

/// Where a run stands, for a progress line.
struct Progress {
  double time_s = 0.0;  ///< scenario clock
  double end_s = 0.0;
  double pitch_deg = 0.0;
  double real_time_factor = 0.0;
  double remaining_wall_s = 0.0;
  const char* phase = "";
};

struct RunOptions {
  std::filesystem::path folder;                      ///< run folder, an earlier run in it is lost; empty: unrecorded
  bool is_live = false;                              ///< also publish telemetry over LCM (udpm, ttl 0)
  double pace = 0.0;                                 ///< simulated seconds per wall second; 0: as fast as it goes
  const std::atomic<bool>* stop = nullptr;           ///< set from outside to end the run early
  std::function<void(const Progress&)> on_progress;  ///< called about four times a second, between ticks
};

/// Runs firmware and simulated robot in lockstep on a memory bus until the scenario ends, the robot
/// falls or a fault latches, and judges what happened. Writes scenario.toml, bus.log,
/// telemetry.lcmlog and verdict.json into the run folder.
///
/// @throws RecordingFailure; what was recorded until then stays valid
[[nodiscard]] Verdict run_lockstep(scenario::Scenario scenario, const RunOptions& options);

}  // namespace surefoot::run
