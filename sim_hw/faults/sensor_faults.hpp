#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "firmware/core/joints.hpp"
#include "sim_hw/faults/fault_config.hpp"
#include "sim_hw/faults/fault_random.hpp"

namespace surefoot::sim_hw {

/// What is wrong with the sensors of one node: stuck, drift, noise, saturate, in the scenario's order. Applied to
/// measured values, after the sensor's own noise and resolution, before they are encoded.
class SensorFaults {
 public:
  SensorFaults() = default;

  /// Keeps the sensor faults of one target. Allocates; nothing after it does.
  SensorFaults(std::span<const FaultConfig> all, FaultTarget target, std::uint64_t seed, double period_s);

  /// @param time_s  scenario's clock at the begin of the tick
  /// @param period  number of the tick
  void begin_tick(double time_s, std::int64_t period) noexcept;

  /// Changes the measurements of one kind, in the order of their frame; at most six.
  void apply(FaultSignal signal, std::span<double> values) noexcept;

 private:
  static constexpr std::size_t kSignalsPerNode = 4;

  struct Entry {
    FaultConfig fault;
    FaultRandom random;
    bool is_on = false;
    std::array<bool, kSignalsPerNode> is_holding{};
    std::array<LegVector, kSignalsPerNode> held{};
  };

  std::vector<Entry> entries_;
  double period_s_ = 0.0;
  double time_s_ = 0.0;
  std::int64_t period_ = 0;
};

}  // namespace surefoot::sim_hw
