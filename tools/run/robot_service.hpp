#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "firmware/host/bus/host_bus.hpp"
#include "sim_hw/simulated_robot.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::run {

struct RobotServiceOptions {
  sim_hw::WorldClock clock = sim_hw::WorldClock::kLockstep;
  std::filesystem::path folder;  ///< truth and bus log of the first master, of later ones in master_2, ...; empty: none
  bool is_live = false;          ///< also publish the truth over LCM
  bool ends_with_master = false;  ///< end when the first master is gone, or the robot has fallen
  /// Lockstep: a master that sends nothing for so long is gone. Twice the firmware's own patience for an answer, in
  /// which it sends nothing either.
  double silence_s = 2.0;
  double lie_s = 3.0;                       ///< free running: what a robot without a master gets to sink down
  const std::atomic<bool>* stop = nullptr;  ///< set from outside to end the service
  std::function<void(const std::string&)> on_message;  ///< what a person wants to hear of; between frames
};

/// What a service amounts to.
struct RobotServiceReport {
  std::uint64_t masters = 0;  ///< that have driven this robot
  std::uint64_t falls = 0;
  std::uint64_t periods = 0;  ///< simulated under the last master
  double real_time_factor = 0.0;
  std::uint64_t telemetry_dropped = 0;  ///< messages and frames that found the recorder's ring full
  sim_hw::NodeCounters counters{};      ///< of the last master's robot
  host::BusReport bus{};
};

/// As printed with `--json`, and kept as `robot.json` in the folder.
[[nodiscard]] std::string to_json(const RobotServiceReport&);

/// The simulated robot as a service on a bus: announces its nodes until a master comes, serves it, and
/// once it is gone is put back on its feet for the next, as an operator would do with a hoist. Until the
/// first SYNC of a master the world stands still.
///
/// @throws RecordingFailure
[[nodiscard]] RobotServiceReport serve_robot(const scenario::Scenario& scenario, host::HostBus& bus,
                                             const RobotServiceOptions& options);

}  // namespace surefoot::run
