#pragma once

#include "tools/run/telemetry_log_reader.hpp"
#include "tools/run/verdict.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::run {

/// Judges a run of two processes from what each of them recorded, tick by tick as `Judge` does beside the
/// loop. The counters of bus and loop are the caller's to fill in.
///
/// @param scenario         with its time zero set; telemetry.every_ticks must have been 1
/// @param firmware, robot  what each recorded
/// @param was_interrupted  stopped from outside before the scenario's end
/// @throws TelemetryLogError when the robot's log breaks off long before the firmware's
[[nodiscard]] Verdict judge_logs(const scenario::Scenario& scenario, const TelemetryLog& firmware,
                                 const TelemetryLog& robot, bool was_interrupted);

}  // namespace surefoot::run
