#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>

#include "firmware/host/loop/firmware_loop.hpp"
#include "firmware/host/loop/start_up.hpp"
#include "firmware/host/realtime/realtime_rights.hpp"
#include "tools/run/exit_code.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::run {

struct FirmwareProcessOptions {
  host::LoopClock clock = host::LoopClock::kLockstep;
  std::filesystem::path folder;     ///< controller's telemetry and bus log; empty: unrecorded
  bool is_live = false;             ///< also publish telemetry over LCM
  bool ends_with_scenario = false;  ///< end with the scenario's last tick, or with a fault
  bool starts_again = false;        ///< after a fault: once the robot announces itself anew, power up anew
  double patience_s = 30.0;         ///< how long the robot's nodes are awaited before tick 0
  bool is_realtime = false;         ///< take the rights below
  host::RealtimeRequest rights{};
  host::OverrunPolicy overruns{};
  const std::atomic<bool>* stop = nullptr;             ///< set from outside to end the loop
  std::function<void(const std::string&)> on_message;  ///< what a person wants to hear of, before and after the loop
};

/// How the firmware fared.
struct FirmwareProcessReport {
  host::FirmwareLoopResult loop{};
  can::FrameCounters frames{};
  host::BusReport bus{};
  std::uint64_t starts = 0;  ///< power-ups
  std::uint64_t allocations_in_loop = 0;
  bool allocations_were_counted = false;
  double real_time_factor = 0.0;
  std::uint64_t telemetry_dropped = 0;
};

/// As printed with `--json`, and kept as `firmware.json` in the folder.
[[nodiscard]] std::string to_json(const FirmwareProcessReport&);
[[nodiscard]] std::string to_text(const FirmwareProcessReport&, host::LoopClock);

/// The firmware as a process on a bus: waits for the robot, runs the loop, says how it went.
///
/// @throws host::StartUpError, RecordingFailure
[[nodiscard]] FirmwareProcessReport run_firmware(const scenario::Scenario& scenario, host::HostBus& bus,
                                                 const FirmwareProcessOptions& options);

}  // namespace surefoot::run
