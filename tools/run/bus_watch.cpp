#include "tools/run/bus_watch.hpp"

#include <cmath>

#include "sim_hw/bus/bus_budget.hpp"
#include "tools/scenario/bus_traffic.hpp"

namespace surefoot::run {
namespace {

double us(std::int64_t ns) noexcept { return static_cast<double>(ns) / 1000.0; }

BusTraffic traffic_of(const sim_hw::BusTally& tally, const sim_hw::SingleBusBudget& budget, std::int64_t elapsed_ns) {
  BusTraffic traffic{.load_percent = tally.load_percent(elapsed_ns),
                     .frames = tally.frames(),
                     .nominal_bits = tally.nominal_bits(),
                     .data_bits = tally.data_bits(),
                     .busy_ns = tally.busy_ns(),
                     .elapsed_ns = elapsed_ns,
                     .streams = {}};
  for (const sim_hw::StreamBudget& entry : budget.streams) {
    const sim_hw::StreamTally& seen = tally.stream(sim_hw::stream_of(entry.stream.identifier));
    StreamTiming timing{.identifier = entry.stream.identifier,
                        .name = entry.stream.name,
                        .frames = seen.frames,
                        .worst_case_us = {},
                        .observed_us = us(seen.worst_response_ns)};
    if (entry.worst_response_ns) timing.worst_case_us = us(*entry.worst_response_ns);
    traffic.streams.push_back(timing);
  }
  return traffic;
}

}  // namespace

BusWatch::BusWatch(const scenario::Scenario& scenario, host::RunRecorder* recorder)
    : config_(scenario.sim.bus),
      traffic_(scenario::bus_traffic(scenario)),
      period_s_(scenario.sim.control_period_s),
      period_ns_(std::llround(scenario.sim.control_period_s * 1e9)),
      recorder_(recorder),
      timeline_(scenario.sim.bus, scenario.sim.control_period_s, scenario.sim.seed) {}

std::vector<BusTraffic> BusWatch::finish(std::int64_t ticks) {
  timeline_.finish();
  const sim_hw::BusBudget budget = sim_hw::bus_budget(config_, period_s_, traffic_);
  std::vector<BusTraffic> buses;
  for (std::uint32_t bus = 0; bus < timeline_.buses(); ++bus) {
    buses.push_back(traffic_of(timeline_.tally(bus), budget.buses[bus], ticks * period_ns_));
  }
  return buses;
}

}  // namespace surefoot::run
