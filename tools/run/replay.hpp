#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace surefoot::run {

/// A folder that holds no run to replay; the message names path and remedy.
class RunFolderError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// How a replay went.
struct ReplayResult {
  std::uint64_t ticks = 0;
  std::uint64_t controller_frames = 0;  ///< frames of the controller in the log
  std::uint64_t differing_frames = 0;   ///< of those, not sent again bit by bit
  std::string first_difference;         ///< empty when there is none
  bool ends_in_mid_tick = false;        ///< the log stops before the last tick's torques: a run that was killed
};

/// Feeds the node frames of a recorded run to the firmware and compares what it sends with what it
/// sent then: SYNC, heartbeats and torques, bit by bit.
///
/// @param run_folder  holds scenario.toml and bus.log
/// @throws RunFolderError, ScenarioError, CandumpLogError with the remedy
[[nodiscard]] ReplayResult replay(const std::filesystem::path& run_folder);

}  // namespace surefoot::run
