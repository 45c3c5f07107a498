#include "tools/doctor/realtime_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>

namespace surefoot::doctor {
namespace {

std::optional<long> number_in(const std::string& text) {
  long number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

bool has_word(std::string_view text, std::string_view word) {
  for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
    const bool begins = at == 0 || text[at - 1] == ' ' || text[at - 1] == '\t';
    const std::size_t end = at + word.size();
    if (begins && (end == text.size() || text[end] == ' ' || text[end] == '\n')) return true;
  }
  return false;
}

}  // namespace

Finding judge_right(const host::MissingRights& missing_rights, std::string_view begin, const std::string& granted) {
  for (const host::MissingRight& right : missing_rights) {
    if (right.what.starts_with(begin)) return missing(right.why, right.remedy);
  }
  return ok(granted);
}

Finding judge_throttling(const std::string& runtime_us, const std::string& period_us) {
  constexpr const char* kRemedy = "sudo sysctl -w kernel.sched_rt_runtime_us=950000 kernel.sched_rt_period_us=1000000";
  if (runtime_us.empty()) return ok("this kernel has none");
  const std::optional<long> runtime = number_in(runtime_us);
  const std::optional<long> period = number_in(period_us);
  if (!runtime || !period || *period <= 0) return warning("its settings are unreadable", kRemedy);
  if (*runtime < 0) return ok("off");
  const double share = static_cast<double>(*runtime) / static_cast<double>(*period);
  const std::string detail = fmt::format("real-time threads may use {:.0f} % of a processor", 100.0 * share);
  // The loop waits for its frames most of the time; half a processor is more than it ever needs.
  return share >= 0.5 ? ok(detail) : warning(detail, kRemedy);
}

Finding judge_preemption(std::string_view version, const std::string& mode, std::string_view command_line) {
  constexpr const char* kRealtimeKernel = "sudo apt-get install -y linux-image-rt-amd64, and boot it";
  if (has_word(version, "PREEMPT_RT")) return ok("PREEMPT_RT");
  if (has_word(version, "PREEMPT_DYNAMIC")) {
    // Only root reads the mode.
    const bool is_full = mode.empty() ? has_word(command_line, "preempt=full") : has_word(mode, "(full)");
    if (is_full) return ok("PREEMPT_DYNAMIC, full");
    const std::string now = mode.empty() ? "its mode is not readable" : mode;
    return warning(fmt::format("PREEMPT_DYNAMIC ({}): a system call of another program can delay the loop", now),
                   fmt::format("boot with preempt=full on the kernel's command line; or {}", kRealtimeKernel));
  }
  if (has_word(version, "PREEMPT")) return ok("PREEMPT");
  return warning("none inside the kernel: a system call of another program can delay the loop by milliseconds",
                 kRealtimeKernel);
}

Finding judge_governor(const std::vector<std::string>& governors) {
  if (governors.empty()) return ok("the machine sets no frequencies");
  const std::set<std::string> kinds(governors.begin(), governors.end());
  if (kinds.size() == 1 && *kinds.begin() == "performance") return ok("performance");
  std::string list;
  for (const std::string& kind : kinds) list += (list.empty() ? "" : ", ") + kind;
  return warning(fmt::format("{}: a processor that is asked little runs slowly when the tick comes", list),
                 "echo performance | sudo tee /sys/devices/system/cpu/cpu*/cpufreq/scaling_governor");
}

Finding judge_isolation(const std::string& isolated, unsigned processors) {
  if (!isolated.empty()) return ok(fmt::format("processor {} is kept free: --cpu", isolated));
  if (processors < 2) return ok("one processor: nothing to keep free");
  const unsigned last = processors - 1;
  return warning("no processor is kept free for the loop",
                 fmt::format("boot with isolcpus={0} nohz_full={0} rcu_nocbs={0} on the kernel's command line", last));
}

Finding judge_clock_source(const std::string& current, const std::string& available) {
  for (const std::string_view slow : {"hpet", "acpi_pm", "jiffies", "pit", "refined-jiffies"}) {
    if (current != slow) continue;
    const std::string detail = fmt::format("{}: reading the time costs microseconds", current);
    return has_word(available, "tsc")
               ? warning(detail, "echo tsc | sudo tee /sys/devices/system/clocksource/clocksource0/current_clocksource")
               : warning(detail, "boot with tsc=reliable on the kernel's command line");
  }
  return ok(current.empty() ? "not told by this kernel" : current);
}

Finding judge_timers(std::int64_t resolution_ns) {
  if (resolution_ns <= 1000) return ok(fmt::format("resolution {} ns", resolution_ns));
  return missing(fmt::format("resolution {} us: a tick of 1 ms cannot be met", resolution_ns / 1000),
                 "boot with highres=on, or a kernel with CONFIG_HIGH_RES_TIMERS");
}

Finding judge_hardware(std::string_view cpu_info) {
  const std::size_t flags = cpu_info.find("\nflags");
  const std::string_view first = flags == std::string_view::npos
                                     ? std::string_view{}
                                     : cpu_info.substr(flags + 1, cpu_info.find('\n', flags + 1) - flags - 1);
  if (!has_word(first, "hypervisor")) return ok("no hypervisor");
  return warning("a virtual machine: its host can stop it for milliseconds, at any priority",
                 "surefoot firmware --probe measures by how much; for deadlines run on hardware");
}

}  // namespace surefoot::doctor
