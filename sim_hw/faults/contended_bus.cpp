#include "sim_hw/faults/contended_bus.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace surefoot::sim_hw {
namespace {

// Kept in the identifier's upper bits, which the arbiter does not look at.
constexpr std::uint16_t kForNodes = 0x8000;
constexpr std::uint16_t kBabble = 0x4000;
constexpr std::uint16_t kIdentifierMask = 0x07FF;
constexpr std::uint64_t kJitterStream = 0x6A697474;

std::int64_t ns(double seconds) noexcept { return std::llround(seconds * 1.0e9); }

}  // namespace

ContendedBus::ContendedBus(const BusConfig& config, double control_period_s, std::uint64_t seed) noexcept
    : count_(std::min(config.count, kMaxBuses)),
      period_ns_(ns(control_period_s)),
      latency_ns_(ns(config.node_latency_s)),
      jitter_ns_(1.0e9 * config.node_jitter_s),
      compute_ns_(ns(config.compute_s)),
      random_(seed, kJitterStream) {
  for (Bus& bus : bus_) bus.arbiter = Arbiter(bit_timing(config));
}

std::optional<ContendedBus::Arrival> ContendedBus::finish_period(std::int64_t elapsed) noexcept {
  for (std::uint32_t i = 0; i < count_; ++i) {
    if (bus_[i].late) return std::exchange(bus_[i].late, std::nullopt);
    while (const auto sent = transmit(bus_[i], elapsed * period_ns_)) {
      if (auto arrival = arrival_of(sent->frame, i)) return arrival;
    }
  }
  return std::nullopt;
}

void ContendedBus::begin_period(std::int64_t period, std::int64_t elapsed) noexcept {
  period_ = period;
  heard_ns_ = 0;
  controller_ready_ns_ = 0;
  for (Bus& bus : bus_) bus.arbiter.rebase(elapsed * period_ns_);
}

bool ContendedBus::babble(const can::CanFrame& frame, double at, bool is_for_nodes) noexcept {
  const auto tag = static_cast<std::uint16_t>(kBabble | (is_for_nodes ? kForNodes : 0U));
  return queue_on(tag, frame, std::llround(at * static_cast<double>(period_ns_)));
}

bool ContendedBus::queue(const can::CanFrame& frame, bool is_for_nodes) noexcept {
  if (is_for_nodes) return queue_on(kForNodes, frame, controller_ready_ns_);
  const double jitter_ns = jitter_ns_ * FaultRandom::uniform(random_.draw(period_, frame.identifier, 0));
  return queue_on(0, frame, heard_ns_ + latency_ns_ + std::llround(jitter_ns));
}

bool ContendedBus::queue_on(std::uint16_t tag, can::CanFrame frame, std::int64_t ready_ns) noexcept {
  const auto identifier = static_cast<std::uint16_t>(frame.identifier & kIdentifierMask);
  frame.identifier = static_cast<std::uint16_t>(identifier | tag);
  bool is_taken = true;
  for (std::uint32_t i = 0; i < count_; ++i) {
    if (!travels_on(identifier, i, count_)) continue;
    std::size_t& waiting = (tag & kBabble) == 0 ? bus_[i].waiting : bus_[i].babble;
    const bool has_room = (tag & kBabble) == 0 || waiting < kBabbleBacklog;
    if (has_room && bus_[i].arbiter.queue(frame, ready_ns)) {
      ++waiting;
    } else {
      is_taken = false;
    }
  }
  return is_taken;
}

std::optional<ContendedBus::Arrival> ContendedBus::advance() noexcept {
  for (std::uint32_t i = 0; i < count_; ++i) {
    while (bus_[i].waiting > 0 && !bus_[i].late) {
      const auto sent = transmit(bus_[i], period_ns_);
      if (!sent) break;
      auto arrival = arrival_of(sent->frame, i);
      if (sent->ended_ns > period_ns_) {
        bus_[i].late = arrival;
        break;
      }
      heard_ns_ = std::max(heard_ns_, sent->ended_ns);
      if (arrival && !arrival->is_for_nodes)
        controller_ready_ns_ = std::max(controller_ready_ns_, heard_ns_ + compute_ns_);
      if (arrival) return arrival;
    }
  }
  return std::nullopt;
}

std::optional<Transmission> ContendedBus::transmit(Bus& bus, std::int64_t until_ns) noexcept {
  const auto sent = bus.arbiter.transmit_next(until_ns);
  if (sent) --((sent->frame.identifier & kBabble) == 0 ? bus.waiting : bus.babble);
  return sent;
}

std::optional<ContendedBus::Arrival> ContendedBus::arrival_of(const can::CanFrame& tagged,
                                                              std::uint32_t bus) const noexcept {
  Arrival arrival{.frame = tagged, .is_for_nodes = (tagged.identifier & kForNodes) != 0};
  arrival.frame.identifier = static_cast<std::uint16_t>(tagged.identifier & kIdentifierMask);
  if (bus > 0 && travels_on(arrival.frame.identifier, 0, count_)) return std::nullopt;
  return arrival;
}

}  // namespace surefoot::sim_hw
