#include "sim_hw/bus/tick_timeline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace surefoot::sim_hw {
namespace {

constexpr std::int64_t kEver = std::numeric_limits<std::int64_t>::max();

std::int64_t ns(double seconds) noexcept { return std::llround(seconds * 1.0e9); }

/// Nothing for a stranger's frame.
const TrafficStream* find_stream(std::uint16_t identifier) noexcept {
  const std::size_t place = stream_of(identifier);
  return place == kNoStream ? nullptr : &robot_traffic()[place];
}

bool is_from_controller(const TrafficStream* stream) noexcept {
  return stream != nullptr && stream->sender == can::Node::kController;
}

bool is_kind(const TrafficStream* stream, StreamKind kind) noexcept {
  return stream != nullptr && stream->kind == kind;
}

}  // namespace

TickTimeline::TickTimeline(const BusConfig& config, double control_period_s, std::uint64_t seed) noexcept
    : count_(std::min(config.count, kMaxBuses)),
      period_ns_(ns(control_period_s)),
      latency_ns_(ns(config.node_latency_s)),
      jitter_ns_(ns(config.node_jitter_s)),
      compute_ns_(ns(config.compute_s)),
      random_(seed) {
  const BitTiming timing = bit_timing(config);
  for (Bus& bus : bus_) {
    bus.arbiter = Arbiter(timing);
    bus.tally = BusTally(timing);
  }
}

bool TickTimeline::Bus::advance(std::int64_t until_ns) noexcept {
  const std::optional<Transmission> sent = arbiter.transmit_next(until_ns);
  if (!sent) return false;
  tally.add(*sent);
  last_end_ns = sent->ended_ns;
  const TrafficStream* stream = find_stream(sent->frame.identifier);
  if (is_kind(stream, StreamKind::kSync)) has_sync_ended = true;
  if (is_kind(stream, StreamKind::kState) && waiting_states > 0) --waiting_states;
  return true;
}

void TickTimeline::take(const can::CanFrame& frame) noexcept {
  const TrafficStream* stream = find_stream(frame.identifier);
  if (is_kind(stream, StreamKind::kSync)) begin_tick();
  if (stage_ == Stage::kSync && !is_from_controller(stream)) end_sync();
  if (stage_ != Stage::kCommands && is_kind(stream, StreamKind::kCommand)) end_states();
  queue(frame, stream);
}

void TickTimeline::queue(const can::CanFrame& frame, const TrafficStream* stream) noexcept {
  const bool is_answer = stage_ == Stage::kStates && !is_from_controller(stream);
  const std::int64_t node_ns = is_answer ? latency_ns_ + draw_jitter_ns() : 0;
  for (std::uint32_t i = 0; i < count_; ++i) {
    if (!travels_on(frame.identifier, i, count_)) continue;
    Bus& bus = bus_[i];
    std::int64_t ready_ns = stage_ == Stage::kCommands ? commands_ready_ns_ : 0;
    if (is_answer) ready_ns = bus.sync_end_ns + node_ns;
    if (!bus.arbiter.queue(frame, ready_ns)) {
      bus.tally.add_bits(frame_bits(frame));
    } else if (is_answer && is_kind(stream, StreamKind::kState)) {
      ++bus.waiting_states;
    }
  }
}

void TickTimeline::begin_tick() noexcept {
  for (std::uint32_t i = 0; i < count_; ++i) {
    Bus& bus = bus_[i];
    if (has_begun_) {
      while (bus.advance(period_ns_)) {
      }
      bus.arbiter.rebase(period_ns_);
    }
    bus.waiting_states = 0;
    bus.has_sync_ended = false;
  }
  has_begun_ = true;
  stage_ = Stage::kSync;
}

void TickTimeline::end_sync() noexcept {
  for (std::uint32_t i = 0; i < count_; ++i) {
    Bus& bus = bus_[i];
    bus.last_end_ns = 0;
    while (!bus.has_sync_ended && bus.advance(kEver)) {
    }
    bus.sync_end_ns = bus.last_end_ns;
  }
  stage_ = Stage::kStates;
}

void TickTimeline::end_states() noexcept {
  if (stage_ == Stage::kSync) end_sync();
  std::int64_t heard_ns = 0;
  for (std::uint32_t i = 0; i < count_; ++i) {
    Bus& bus = bus_[i];
    while (bus.waiting_states > 0 && bus.advance(kEver)) {
    }
    heard_ns = std::max(heard_ns, bus.last_end_ns);
  }
  commands_ready_ns_ = heard_ns + compute_ns_;
  for (std::uint32_t i = 0; i < count_; ++i) {
    while (bus_[i].advance(commands_ready_ns_)) {
    }
  }
  stage_ = Stage::kCommands;
}

void TickTimeline::finish() noexcept {
  for (std::uint32_t i = 0; i < count_; ++i) {
    while (bus_[i].advance(kEver)) {
    }
  }
}

double TickTimeline::load_percent(std::int64_t elapsed_ns) const noexcept {
  double largest = 0.0;
  for (std::uint32_t i = 0; i < count_; ++i) largest = std::max(largest, bus_[i].tally.load_percent(elapsed_ns));
  return largest;
}

// splitmix64 (Steele, Lea, Flood 2014)
std::int64_t TickTimeline::draw_jitter_ns() noexcept {
  if (jitter_ns_ <= 0) return 0;
  random_ += 0x9E3779B97F4A7C15U;
  std::uint64_t mixed = random_;
  mixed = (mixed ^ (mixed >> 30U)) * 0xBF58476D1CE4E5B9U;
  mixed = (mixed ^ (mixed >> 27U)) * 0x94D049BB133111EBU;
  mixed ^= mixed >> 31U;
  return static_cast<std::int64_t>(mixed % (static_cast<std::uint64_t>(jitter_ns_) + 1));
}

}  // namespace surefoot::sim_hw
