#include "firmware/host/realtime/wake_up_probe.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <thread>

#include "firmware/host/realtime/monotonic_clock.hpp"
#include "firmware/host/realtime/period_grid.hpp"

namespace surefoot::host {
namespace {

void run(const WakeUpProbe& probe, const MonotonicClock& clock, WakeUpMeasurement& measured) {
  RealtimeRequest request = probe.rights;
  request.cpu = measured.cpu;
  const RealtimeRights rights(request);
  measured.missing = rights.missing();
  PeriodGrid grid(MonotonicClock::now_ns() + probe.period_ns, probe.period_ns);
  const ResourceUsage before = thread_resource_usage();
  while (grid.tick() < probe.ticks && clock.sleep_until_ns(grid.due_ns())) {
    const std::int64_t now_ns = MonotonicClock::now_ns();
    measured.wake_up.add(now_ns - grid.due_ns());
    grid.advance(now_ns);
  }
  measured.usage = thread_resource_usage() - before;
  measured.missed_ticks = grid.missed_ticks();
}

}  // namespace

std::vector<WakeUpMeasurement> measure(const WakeUpProbe& probe, const std::atomic<bool>& stop) {
  if (probe.period_ns <= 0) {
    throw std::invalid_argument(fmt::format("period is {} ns; expected more than 0", probe.period_ns));
  }
  const MonotonicClock clock(stop);
  std::vector<WakeUpMeasurement> measured(probe.cpus.size());
  std::vector<std::jthread> threads;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    measured[i].cpu = probe.cpus[i];
    threads.emplace_back([&, i] { run(probe, clock, measured[i]); });
  }
  threads.clear();  // joins
  return measured;
}

}  // namespace surefoot::host
