#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "firmware/host/realtime/missing_right.hpp"
#include "firmware/host/realtime/realtime_rights.hpp"
#include "firmware/host/realtime/resource_usage.hpp"
#include "firmware/host/tick_histogram.hpp"

namespace surefoot::host {

/// A measurement of this machine, as cyclictest does it (rt-tests): threads that do nothing but wake up.
struct WakeUpProbe {
  std::int64_t period_ns = 1'000'000;
  std::int64_t ticks = 10'000;                      ///< instants of the grid, met or missed
  std::vector<int> cpus{RealtimeRequest::kAnyCpu};  ///< one thread for each entry, pinned to it
  RealtimeRequest rights;                           ///< its `cpu` is replaced by the entry above
};

/// What one of its threads saw.
struct WakeUpMeasurement {
  int cpu = RealtimeRequest::kAnyCpu;
  TickHistogram wake_up;          ///< wake-up after its instant
  std::int64_t missed_ticks = 0;  ///< instants that passed while an earlier wake-up was late
  ResourceUsage usage;            ///< while measuring
  MissingRights missing;
};

/// Runs for ticks * period_ns, or until `stop` is set.
///
/// @throws std::invalid_argument on a period that is not positive
/// @throws std::system_error when the machine gives no thread
[[nodiscard]] std::vector<WakeUpMeasurement> measure(const WakeUpProbe&, const std::atomic<bool>& stop);

}  // namespace surefoot::host
