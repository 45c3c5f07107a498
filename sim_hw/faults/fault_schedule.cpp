#include "sim_hw/faults/fault_schedule.hpp"

#include <bit>

#include "sim_hw/faults/fault_random.hpp"

namespace surefoot::sim_hw {
namespace {

bool is_power_fault(FaultKind kind) noexcept { return kind == FaultKind::kDeadNode || kind == FaultKind::kRestart; }

/// What tells one fault from another. When it ends is left out, so that a longer fault begins like a shorter one.
std::uint64_t identity(const FaultConfig& fault) noexcept {
  const std::uint64_t words = static_cast<std::uint64_t>(fault.kind) | static_cast<std::uint64_t>(fault.target) << 8U |
                              static_cast<std::uint64_t>(fault.signal) << 16U |
                              static_cast<std::uint64_t>(fault.element) << 24U;
  return FaultRandom::mixed(words ^ FaultRandom::mixed(std::bit_cast<std::uint64_t>(fault.at_s)));
}

}  // namespace

std::uint64_t fault_stream(std::span<const FaultConfig> faults, std::size_t place) noexcept {
  const std::uint64_t own = identity(faults[place]);
  std::uint64_t equals_before = 0;
  for (std::size_t i = 0; i < place; ++i) equals_before += identity(faults[i]) == own ? 1U : 0U;
  return own + equals_before;
}

can::Node node_of(FaultTarget target) noexcept {
  switch (target) {
    case FaultTarget::kLegRight:
      return can::Node::kLegRight;
    case FaultTarget::kLegLeft:
      return can::Node::kLegLeft;
    case FaultTarget::kFootRight:
      return can::Node::kFootRight;
    case FaultTarget::kFootLeft:
      return can::Node::kFootLeft;
    case FaultTarget::kTorso:
      return can::Node::kTorsoImu;
    default:
      return can::Node::kController;
  }
}

bool is_on(const FaultConfig& fault, double time_s, double period_s) noexcept {
  const double since_s = time_s - fault.at_s + 0.5 * period_s;
  return since_s > 0.0 && (fault.kind == FaultKind::kDeadNode || since_s < fault.for_s);
}

std::uint32_t FaultSchedule::active(double time_s) const noexcept {
  std::uint32_t mask = 0;
  for (std::size_t i = 0; i < faults_.size(); ++i) {
    if (is_on(faults_[i], time_s, period_s_)) mask |= 1U << i;
  }
  return mask;
}

NodeSet FaultSchedule::off_bus(std::uint32_t active) const noexcept {
  NodeSet nodes = unpowered(active);
  for (std::size_t i = 0; i < faults_.size(); ++i) {
    if (((active >> i) & 1U) != 0 && faults_[i].kind == FaultKind::kBusOff) nodes.add(node_of(faults_[i].target));
  }
  return nodes;
}

NodeSet FaultSchedule::unpowered(std::uint32_t active) const noexcept {
  NodeSet nodes;
  for (std::size_t i = 0; i < faults_.size(); ++i) {
    if (((active >> i) & 1U) != 0 && is_power_fault(faults_[i].kind)) nodes.add(node_of(faults_[i].target));
  }
  return nodes;
}

}  // namespace surefoot::sim_hw
