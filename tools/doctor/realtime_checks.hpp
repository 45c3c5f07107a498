#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "firmware/host/realtime/missing_right.hpp"
#include "tools/doctor/check.hpp"

namespace surefoot::doctor {

/// @param begin    of the right's name, as the real-time loop calls it
/// @param granted  what to say when it is not among the missing ones
[[nodiscard]] Finding judge_right(const host::MissingRights&, std::string_view begin, const std::string& granted);

/// @param runtime_us  text of /proc/sys/kernel/sched_rt_runtime_us, empty: there is no such file
/// @param period_us   text of /proc/sys/kernel/sched_rt_period_us
[[nodiscard]] Finding judge_throttling(const std::string& runtime_us, const std::string& period_us);

/// @param version  of the kernel, `uname -v`
/// @param mode     text of /sys/kernel/debug/sched/preempt, e.g. "none voluntary (full)"; empty: not readable
/// @param command_line  of the kernel, /proc/cmdline
[[nodiscard]] Finding judge_preemption(std::string_view version, const std::string& mode,
                                       std::string_view command_line);

/// @param governors  text of each processor's scaling_governor; none: the machine has no frequency scaling
[[nodiscard]] Finding judge_governor(const std::vector<std::string>& governors);

/// @param isolated    text of /sys/devices/system/cpu/isolated, e.g. "2-3"
/// @param processors  of this machine
[[nodiscard]] Finding judge_isolation(const std::string& isolated, unsigned processors);

/// @param current, available  texts of /sys/devices/system/clocksource/clocksource0/
[[nodiscard]] Finding judge_clock_source(const std::string& current, const std::string& available);

/// @param resolution_ns  of CLOCK_MONOTONIC
[[nodiscard]] Finding judge_timers(std::int64_t resolution_ns);

/// @param cpu_info  text of /proc/cpuinfo
[[nodiscard]] Finding judge_hardware(std::string_view cpu_info);

}  // namespace surefoot::doctor
