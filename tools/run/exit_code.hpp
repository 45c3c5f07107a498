#pragma once

namespace surefoot::run {

/// What the process returns; scripts rely on it.
enum class ExitCode : int {
  kVerdictHolds = 0,
  kFellOrLimit = 2,    ///< the robot fell, a limit broke, or a replay differed
  kFault = 3,          ///< the firmware latched a fault
  kUsage = 64,         ///< EX_USAGE
  kBadInput = 65,      ///< EX_DATAERR: scenario, run folder or log cannot be used as it is
  kMachineLacks = 69,  ///< EX_UNAVAILABLE: disk full, folder not writable or taken
  kBug = 70,           ///< EX_SOFTWARE
  kInterrupted = 130,  ///< stopped by SIGINT or SIGTERM; what was recorded is kept
};

}  // namespace surefoot::run
