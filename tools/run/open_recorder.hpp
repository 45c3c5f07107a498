#pragma once

#include <filesystem>
#include <memory>

#include "firmware/host/run_recorder.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::run {

/// Makes the run folder with bus.log, telemetry.lcmlog and scenario.toml.
///
/// @param folder   empty: nothing is recorded
/// @param is_live  publish over LCM too (udpm, ttl 0)
/// @return null for an empty folder
/// @throws RecordingFailure naming path and remedy
[[nodiscard]] std::unique_ptr<host::RunRecorder> open_recorder(const scenario::Scenario& scenario,
                                                               const std::filesystem::path& folder, bool is_live);

}  // namespace surefoot::run
