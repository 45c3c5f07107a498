#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>

#include "tools/run/verdict.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::run {

struct TwoProcessOptions {
  std::filesystem::path program;  ///< this very binary
  std::filesystem::path folder;   ///< run folder; needed, for the verdict is judged from what both recorded
  std::string bus;                ///< address, see `host::open_bus`
  bool is_wall_clock = false;     ///< otherwise lockstep
  int fifo_priority = 0;          ///< of the firmware; the robot gets one less; 0: none
  const std::atomic<bool>* stop = nullptr;
  std::function<void(double elapsed_wall_s)> on_progress;  ///< about four times a second
};

/// Runs firmware and simulated robot as two processes that meet only on a bus, and judges the run from
/// their logs, tick by tick as a run in one process is judged. The run folder holds what such a run's does
/// (bus.log as the firmware saw it, both telemetry logs as one) and, in `firmware/` and `robot/`, what each
/// process recorded and reported.
///
/// @throws RecordingFailure, TelemetryLogError, ProcessFailure
[[nodiscard]] Verdict run_two_processes(scenario::Scenario scenario, const TwoProcessOptions& options);

}  // namespace surefoot::run
