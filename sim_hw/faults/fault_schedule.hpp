#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "firmware/can/identifiers.hpp"
#include "sim_hw/faults/fault_config.hpp"

namespace surefoot::sim_hw {

/// The node that a target names; the controller for the bus, which is none.
[[nodiscard]] can::Node node_of(FaultTarget target) noexcept;

/// A set of the robot's nodes.
class NodeSet {
 public:
  void add(can::Node node) noexcept { bits_ |= bit(node); }
  [[nodiscard]] bool has(can::Node node) const noexcept { return (bits_ & bit(node)) != 0; }

 private:
  [[nodiscard]] static std::uint32_t bit(can::Node node) noexcept {
    const auto number = static_cast<unsigned>(node);
    return number < 32U ? 1U << number : 0U;  // the controller is none of the robot's
  }

  std::uint32_t bits_ = 0;
};

/// Whether a fault is on at an instant of the scenario's clock that begins a control period; half a period of
/// tolerance keeps rounding out of it.
[[nodiscard]] bool is_on(const FaultConfig& fault, double time_s, double period_s) noexcept;

/// Which faults are on, and which nodes they silence: functions of time alone.
class FaultSchedule {
 public:
  FaultSchedule(std::vector<FaultConfig> faults, double period_s) : faults_(std::move(faults)), period_s_(period_s) {}

  [[nodiscard]] bool is_empty() const noexcept { return faults_.empty(); }
  [[nodiscard]] const std::vector<FaultConfig>& faults() const noexcept { return faults_; }

  /// Bit mask of the faults that are on, in the scenario's order.
  [[nodiscard]] std::uint32_t active(double time_s) const noexcept;

  /// Nodes that neither send nor hear while these faults are on.
  [[nodiscard]] NodeSet off_bus(std::uint32_t active) const noexcept;

  /// Nodes without power while these faults are on.
  [[nodiscard]] NodeSet unpowered(std::uint32_t active) const noexcept;

 private:
  std::vector<FaultConfig> faults_;
  double period_s_;
};

}  // namespace surefoot::sim_hw
