#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim_hw/bus/traffic.hpp"

namespace surefoot::sim_hw {

/// One stream on one bus, at its worst. Times in ns.
struct StreamBudget {
  TrafficStream stream;
  FrameBits worst_bits;
  std::int64_t transmission_ns = 0;
  std::int64_t period_ns = 0;  ///< 0: none
  /// From the instant that it may be queued at its node, jitter included; nothing: without bound, or no part of a
  /// healthy tick. Emergencies: when every node sends one in the same tick.
  std::optional<std::int64_t> worst_response_ns;
};

/// All streams of one bus.
struct SingleBusBudget {
  std::vector<StreamBudget> streams;  ///< by rising identifier
  double worst_load_percent = 0.0;    ///< every frame at its longest; emergencies not counted
};

/// The longest a healthy tick can take from SYNC to the end of its command frames, in ns. Where there are two
/// buses each part is that of the slower.
struct TickChain {
  std::int64_t sync_and_states_ns = 0;  ///< on the wire
  std::int64_t node_ns = 0;             ///< latency and jitter of the nodes
  std::int64_t compute_ns = 0;
  std::int64_t commands_ns = 0;   ///< on the wire
  std::int64_t heartbeat_ns = 0;  ///< one a tick, wherever it comes between

  [[nodiscard]] std::int64_t total_ns() const noexcept {
    return sync_and_states_ns + node_ns + compute_ns + commands_ns + heartbeat_ns;
  }
};

/// Whether a bus carries the walking robot, and how.
///
/// The bound on a tick is simple: the bus is idle at its begin, and idle within it only while nodes or
/// controller work. When the tick's chain ends within the control period, no frame meets one of the tick before,
/// and the response times hold as Davis et al. give them for streams of that period. They are those of a healthy
/// tick: emergencies, repeated frames and intruders come on top, `spare_emergencies` of them without harm.
struct BusBudget {
  std::vector<SingleBusBudget> buses;
  TickChain chain;
  std::int64_t period_ns = 0;
  std::int64_t emergency_ns = 0;  ///< longest time of one on the wire

  [[nodiscard]] bool carries() const noexcept { return chain.total_ns() <= period_ns; }
  /// Time left in the tick; negative: that much too little.
  [[nodiscard]] std::int64_t spare_ns() const noexcept { return period_ns - chain.total_ns(); }
  [[nodiscard]] std::int64_t spare_emergencies() const noexcept { return carries() ? spare_ns() / emergency_ns : 0; }
};

/// @param control_period_s  time between two SYNC frames, > 0
[[nodiscard]] BusBudget bus_budget(const BusConfig&, double control_period_s, TrafficOptions options = {});

/// How far a bus is from carrying its traffic, and what would mend it, for people.
struct BusRefusal {
  std::string statement;  ///< with the figures
  std::string remedy;     ///< each with the time that the tick then needs
};

/// Nothing when the bus carries its traffic.
[[nodiscard]] std::optional<BusRefusal> refuse_overload(const BusConfig&, double control_period_s,
                                                        TrafficOptions options = {});

}  // namespace surefoot::sim_hw
