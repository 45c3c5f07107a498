#include "firmware/host/realtime/loop_report.hpp"

#include <fmt/format.h>

namespace surefoot::host {

DurationSummary summarise(const TickHistogram& histogram) noexcept {
  return {histogram.count(), histogram.p50_us(), histogram.p999_us(), histogram.max_us(), histogram.mean_us(), histogram.bins()};
}

LoopReport report_of(std::int64_t ticks, const PeriodGrid& grid, const TickHistogram& wake_up,
                     const TickHistogram& compute, const TickHistogram& frame, const ResourceUsage& usage) noexcept {
  return {.ticks = ticks,
          .wake_up = summarise(wake_up),
          .compute = summarise(compute),
          .frame = summarise(frame),
          .overruns = grid.overruns(),
          .missed_ticks = grid.missed_ticks(),
          .is_degraded = grid.is_degraded(),
          .usage = usage};
}

std::string duration_table_head() {
  return fmt::format("  {:<12} {:>10} {:>10} {:>10} {:>10}\n", "us", "p50", "p99.9", "max", "count");
}

std::string to_text(const char* name, const DurationSummary& summary) {
  return fmt::format("  {:<12} {:>10.1f} {:>10.1f} {:>10.1f} {:>10}\n", name, summary.p50_us, summary.p999_us,
                     summary.max_us, summary.count);
}

std::string to_text(const LoopReport& report) {
  std::string text = duration_table_head();
  if (report.wake_up.count > 0) text += to_text("wake-up", report.wake_up);
  if (report.compute.count > 0) text += to_text("compute", report.compute);
  if (report.frame.count > 0) text += to_text("frame", report.frame);
  text += fmt::format("  ticks        {} ran, {} overran, {} missed{}\n", report.ticks, report.overruns,
                      report.missed_ticks, report.is_degraded ? ": degraded" : "");
  text += fmt::format("  page faults  {} minor, {} major\n", report.usage.minor_page_faults,
                      report.usage.major_page_faults);
  text += fmt::format("  switches     {} voluntary, {} involuntary\n", report.usage.voluntary_switches,
                      report.usage.involuntary_switches);
  return text;
}

}  // namespace surefoot::host
