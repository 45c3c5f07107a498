#pragma once

#include <cstdint>

#include "firmware/can/frame_exchange.hpp"
#include "firmware/core/controller.hpp"
#include "firmware/core/sensor_snapshot.hpp"
#include "firmware/host/realtime/loop_report.hpp"
#include "firmware/host/tick_histogram.hpp"
#include "sim_hw/ground_truth.hpp"
#include "surefoot/bus_statistics_t.hpp"
#include "surefoot/controller_state_t.hpp"
#include "surefoot/event_t.hpp"
#include "surefoot/simulator_truth_t.hpp"
#include "surefoot/timing_statistics_t.hpp"

namespace surefoot::run {

/// One tick as telemetry shows it. @param utime_us  scenario clock
[[nodiscard]] controller_state_t state_message(std::int64_t utime_us, const TickOutput&,
                                               const SensorSnapshot&) noexcept;
[[nodiscard]] simulator_truth_t truth_message(std::int64_t utime_us, std::uint32_t tick,
                                              const sim_hw::GroundTruth&) noexcept;
[[nodiscard]] bus_statistics_t bus_message(std::int64_t utime_us, std::uint32_t tick, const can::FrameCounters&,
                                           double load_percent) noexcept;
/// Computing times of the ticks so far; what belongs to a wall-clock loop (wake-up, overruns) stays zero in lockstep.
[[nodiscard]] timing_statistics_t timing_message(std::int64_t utime_us, std::uint32_t tick,
                                                 const host::TickHistogram& tick_times) noexcept;
/// The same for a loop that has a report of its own.
[[nodiscard]] timing_statistics_t timing_message(std::int64_t utime_us, std::uint32_t tick,
                                                 const host::LoopReport& loop) noexcept;
[[nodiscard]] event_t event_message(std::int64_t utime_us, std::uint32_t tick, std::int8_t code, const char* name,
                                    double value) noexcept;

/// The way back: what a verdict needs of a recorded tick; all else stays at its default.
[[nodiscard]] TickOutput output_of(const controller_state_t&) noexcept;
[[nodiscard]] sim_hw::GroundTruth truth_of(const simulator_truth_t&) noexcept;

}  // namespace surefoot::run
