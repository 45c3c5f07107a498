#include "sim_hw/faults/sensor_faults.hpp"

#include <algorithm>

#include "sim_hw/faults/fault_schedule.hpp"
#include "sim_hw/nodes/noise_source.hpp"

namespace surefoot::sim_hw {
namespace {

/// Place of a signal among those of its kind of node.
std::size_t slot_of(FaultSignal signal) noexcept {
  switch (signal) {
    case FaultSignal::kRate:
    case FaultSignal::kAccelerometer:
    case FaultSignal::kInclinometer:
      return 1;
    case FaultSignal::kTorque:
    case FaultSignal::kFootAccelerometer:
      return 2;
    case FaultSignal::kHipGyro:
      return 3;
    default:
      return 0;
  }
}

/// Places [first, last) of the values that an element names; `kAll` names all.
struct Places {
  std::size_t first;
  std::size_t last;
};

Places places_of(FaultElement element, std::size_t count) noexcept {
  if (element == FaultElement::kAll) return {0, count};
  FaultElement first = FaultElement::kHipYaw;
  if (element >= FaultElement::kFrontLeft) first = FaultElement::kFrontLeft;
  if (element >= FaultElement::kX) first = FaultElement::kX;
  const std::size_t place = static_cast<std::size_t>(element) - static_cast<std::size_t>(first);
  return {place, std::min(place + 1, count)};
}

}  // namespace

SensorFaults::SensorFaults(std::span<const FaultConfig> all, FaultTarget target, std::uint64_t seed, double period_s)
    : period_s_(period_s) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!is_sensor_fault(all[i].kind) || all[i].target != target) continue;
    entries_.push_back({.fault = all[i], .random = FaultRandom(seed, fault_stream(all, i))});
  }
}

void SensorFaults::begin_tick(double time_s, std::int64_t period) noexcept {
  time_s_ = time_s;
  period_ = period;
  for (Entry& entry : entries_) {
    entry.is_on = is_on(entry.fault, time_s, period_s_);
    if (!entry.is_on) entry.is_holding.fill(false);
  }
}

void SensorFaults::apply(FaultSignal signal, std::span<double> values) noexcept {
  const std::size_t slot = slot_of(signal);
  for (Entry& entry : entries_) {
    const FaultConfig& fault = entry.fault;
    if (!entry.is_on || (fault.signal != FaultSignal::kAll && fault.signal != signal)) continue;
    if (fault.element != FaultElement::kAll && is_of_inertial_legs(signal)) continue;
    if (fault.kind == FaultKind::kStuck && !entry.is_holding[slot]) {
      std::copy_n(values.begin(), std::min(values.size(), kJointsPerLeg), entry.held[slot].begin());
      entry.is_holding[slot] = true;
    }
    const Places places = places_of(fault.element, values.size());
    for (std::size_t i = places.first; i < places.last; ++i) {
      switch (fault.kind) {
        case FaultKind::kStuck:
          values[i] = entry.held[slot][i];
          break;
        case FaultKind::kDrift:
          values[i] += fault.value * (time_s_ - fault.at_s);
          break;
        case FaultKind::kNoise: {
          const auto measurement = static_cast<std::uint32_t>(slot * kJointsPerLeg + i);
          values[i] += NoiseSource(entry.random.draw(period_, measurement, 0), 0).sample(fault.value);
          break;
        }
        case FaultKind::kSaturate:
          values[i] = std::clamp(values[i], -fault.value, fault.value);
          break;
        default:
          break;
      }
    }
  }
}

}  // namespace surefoot::sim_hw
