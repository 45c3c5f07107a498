#include "sim_hw/bus/bus_budget.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim_hw/bus/response_time.hpp"

namespace surefoot::sim_hw {
namespace {

std::int64_t ns(double seconds) noexcept { return std::llround(seconds * 1.0e9); }

bool is_emergency(const TrafficStream& stream) noexcept { return stream.kind == StreamKind::kEmergency; }
bool is_of_healthy_tick(const TrafficStream& stream) noexcept { return stream.period_ticks > 0; }

/// Response times of a healthy tick's streams; or of the emergencies, one of each a tick, among all others.
void analyse(std::vector<StreamBudget>& streams, std::int64_t bit_ns, std::int64_t node_jitter_ns, std::int64_t tick_ns,
             bool emergencies) {
  std::vector<AnalysedMessage> messages;
  std::vector<StreamBudget*> analysed;
  for (StreamBudget& entry : streams) {
    if (!is_of_healthy_tick(entry.stream) && !(emergencies && is_emergency(entry.stream))) continue;
    const bool is_node = entry.stream.sender != can::Node::kController;
    messages.push_back({.identifier = entry.stream.identifier,
                        .transmission_ns = entry.transmission_ns,
                        .period_ns = std::max(entry.period_ns, tick_ns),
                        .jitter_ns = is_node ? node_jitter_ns : 0});
    analysed.push_back(&entry);
  }
  const auto responses = response_times(messages, bit_ns);
  for (std::size_t i = 0; i < analysed.size(); ++i) {
    if (is_emergency(analysed[i]->stream) != emergencies || !responses[i]) continue;
    analysed[i]->worst_response_ns = responses[i]->worst_ns;
  }
}

SingleBusBudget single_bus(const BusConfig& config, TrafficOptions options, std::int64_t tick_ns, std::uint32_t bus) {
  const BitTiming timing = bit_timing(config);
  SingleBusBudget budget;
  for (const TrafficStream& stream : streams_of(options)) {
    if (!travels_on(stream.identifier, bus, config.count)) continue;
    StreamBudget entry{.stream = stream, .worst_bits = worst_case_frame_bits(stream.length), .worst_response_ns = {}};
    entry.transmission_ns = static_cast<std::int64_t>(duration_ns(entry.worst_bits, timing));
    entry.period_ns = stream.period_ticks * tick_ns;
    if (entry.period_ns > 0) {
      budget.worst_load_percent +=
          100.0 * static_cast<double>(entry.transmission_ns) / static_cast<double>(entry.period_ns);
    }
    budget.streams.push_back(entry);
  }
  const std::int64_t jitter_ns = ns(config.node_jitter_s);
  analyse(budget.streams, timing.nominal_bit_ns, jitter_ns, tick_ns, false);
  analyse(budget.streams, timing.nominal_bit_ns, jitter_ns, tick_ns, true);
  return budget;
}

std::int64_t wire_ns(const SingleBusBudget& bus, std::initializer_list<StreamKind> kinds) noexcept {
  std::int64_t sum_ns = 0;
  for (const StreamBudget& entry : bus.streams) {
    const bool counts = is_of_healthy_tick(entry.stream) && std::ranges::find(kinds, entry.stream.kind) != kinds.end();
    if (counts) sum_ns += entry.transmission_ns;
  }
  return sum_ns;
}

std::int64_t longest_ns(const SingleBusBudget& bus, StreamKind kind) noexcept {
  std::int64_t longest_ns = 0;
  for (const StreamBudget& entry : bus.streams) {
    if (entry.stream.kind == kind) longest_ns = std::max(longest_ns, entry.transmission_ns);
  }
  return longest_ns;
}

std::string us(std::int64_t ns) { return fmt::format("{:.1f} us", static_cast<double>(ns) * 1e-3); }

/// The shortest control period of whole 50 us that this bus carries; the chain does not depend on the period.
std::int64_t slow_enough_ns(std::int64_t chain_ns) noexcept {
  constexpr std::int64_t kStep_ns = 50'000;
  return (chain_ns + kStep_ns - 1) / kStep_ns * kStep_ns;
}

std::string remedies(const BusConfig& config, TrafficOptions options, const BusBudget& budget) {
  constexpr double kFastestDataRate_hz = 8.0e6;  // of common transceivers (CiA 601-4, signal improvement)
  const double period_s = static_cast<double>(budget.period_ns) * 1e-9;
  std::string text;
  const auto propose = [&](BusConfig changed, const std::string& keys) {
    const BusBudget better = bus_budget(changed, period_s, options);
    if (better.carries()) text += fmt::format("{} (the tick then needs {}), or ", keys, us(better.chain.total_ns()));
  };
  BusConfig two = config;
  two.count = kMaxBuses;
  BusConfig fast = config;
  fast.data_bit_rate_hz = kFastestDataRate_hz;
  BusConfig both = two;
  both.data_bit_rate_hz = kFastestDataRate_hz;
  if (config.count < kMaxBuses) propose(two, "bus.count = 2");
  if (config.data_bit_rate_hz < kFastestDataRate_hz) propose(fast, "bus.data_bit_rate_hz = 8e6");
  if (text.empty()) propose(both, "bus.count = 2 with bus.data_bit_rate_hz = 8e6");
  return text + fmt::format("control_period_s = {:.6g} or more",
                            static_cast<double>(slow_enough_ns(budget.chain.total_ns())) * 1e-9);
}

}  // namespace

BusBudget bus_budget(const BusConfig& config, double control_period_s, TrafficOptions options) {
  BusBudget budget;
  budget.period_ns = ns(control_period_s);
  for (std::uint32_t bus = 0; bus < config.count; ++bus) {
    const SingleBusBudget& single = budget.buses.emplace_back(single_bus(config, options, budget.period_ns, bus));
    TickChain& chain = budget.chain;
    chain.sync_and_states_ns =
        std::max(chain.sync_and_states_ns, wire_ns(single, {StreamKind::kSync, StreamKind::kState}));
    chain.commands_ns = std::max(chain.commands_ns, wire_ns(single, {StreamKind::kCommand}));
    chain.heartbeat_ns = std::max(chain.heartbeat_ns, longest_ns(single, StreamKind::kHeartbeat));
    budget.emergency_ns = std::max(budget.emergency_ns, longest_ns(single, StreamKind::kEmergency));
  }
  budget.chain.node_ns = ns(config.node_latency_s) + ns(config.node_jitter_s);
  budget.chain.compute_ns = ns(config.compute_s);
  return budget;
}

std::optional<BusRefusal> refuse_overload(const BusConfig& config, double control_period_s, TrafficOptions options) {
  const BusBudget budget = bus_budget(config, control_period_s, options);
  if (budget.carries()) return std::nullopt;
  const TickChain& chain = budget.chain;
  return BusRefusal{
      fmt::format("the bus cannot carry its traffic: from SYNC to the last command frame a tick takes up to {} "
                  "(SYNC and states {}, nodes {}, computing {}, commands {}, a heartbeat {}), {} ({:.1f} %) more than "
                  "control_period_s = {}",
                  us(chain.total_ns()), us(chain.sync_and_states_ns), us(chain.node_ns), us(chain.compute_ns),
                  us(chain.commands_ns), us(chain.heartbeat_ns), us(-budget.spare_ns()),
                  -100.0 * static_cast<double>(budget.spare_ns()) / static_cast<double>(budget.period_ns),
                  us(budget.period_ns)),
      remedies(config, options, budget)};
}

}  // namespace surefoot::sim_hw
