#pragma once

#include <cstdint>
#include <string>

#include "firmware/host/realtime/period_grid.hpp"
#include "firmware/host/realtime/resource_usage.hpp"
#include "firmware/host/tick_histogram.hpp"

namespace surefoot::host {

/// A histogram in short; percentiles at most 1/128 too high.
struct DurationSummary {
  std::uint64_t count = 0;
  double p50_us = 0.0;
  double p999_us = 0.0;
  double max_us = 0.0;
  double mean_us = 0.0;
  TickHistogram::Bins bins{};

  friend bool operator==(const DurationSummary&, const DurationSummary&) = default;
};

[[nodiscard]] DurationSummary summarise(const TickHistogram&) noexcept;

/// How a wall-clock loop fared since its start: what it says at exit and over LCM. Making one does not allocate.
struct LoopReport {
  std::int64_t ticks = 0;     ///< that ran
  DurationSummary wake_up;    ///< begin of a tick after its instant
  DurationSummary compute;    ///< begin of a tick to its end, without the wait for frames
  DurationSummary frame;      ///< latency of frames
  std::int64_t overruns = 0;  ///< ticks that ended after the next one was due
  std::int64_t missed_ticks = 0;
  bool is_degraded = false;  ///< missed too many, see OverrunPolicy
  ResourceUsage usage;       ///< of the loop's thread

  friend bool operator==(const LoopReport&, const LoopReport&) = default;
};

/// @param ticks  that ran
/// @param usage  of the loop's thread, since the loop started
[[nodiscard]] LoopReport report_of(std::int64_t ticks, const PeriodGrid&, const TickHistogram& wake_up,
                                   const TickHistogram& compute, const TickHistogram& frame,
                                   const ResourceUsage& usage) noexcept;

/// A small table for people, with one line for each kind of figure. Kinds that were never measured are left out.
[[nodiscard]] std::string to_text(const LoopReport&);

/// One line of that table, e.g. for measurements beside the loop's own.
[[nodiscard]] std::string to_text(const char* name, const DurationSummary&);

/// The head of that table, above such lines.
[[nodiscard]] std::string duration_table_head();

}  // namespace surefoot::host
