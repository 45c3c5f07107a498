#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "surefoot/controller_state_t.hpp"
#include "surefoot/event_t.hpp"
#include "surefoot/simulator_truth_t.hpp"

namespace surefoot::run {

/// An LCM log that cannot be read; the message names file and remedy.
class TelemetryLogError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What a telemetry log holds of one process, each kind in the order of its recording.
struct TelemetryLog {
  std::vector<controller_state_t> states;
  std::vector<simulator_truth_t> truths;
  std::vector<event_t> events;
};

/// Reads the channels SUREFOOT_STATE, _TRUTH and _EVENT.
/// @throws TelemetryLogError when the file is missing or a message is of another version
[[nodiscard]] TelemetryLog read_telemetry_log(const std::filesystem::path& path);

/// Writes the messages of several logs into one, by their time stamps; equal ones in the order of the files.
/// @throws TelemetryLogError
void merge_telemetry_logs(const std::vector<std::filesystem::path>& from, const std::filesystem::path& to);

}  // namespace surefoot::run
