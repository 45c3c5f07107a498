#pragma once

#include <array>
#include <cstdint>

#include "sim_hw/bus/arbiter.hpp"
#include "sim_hw/bus/bus_tally.hpp"
#include "sim_hw/bus/traffic.hpp"

namespace surefoot::sim_hw {

/// Puts the frames of a lockstep run, where a tick takes no time, at the instants at which they would cross a
/// real bus, and keeps the totals.
///
/// SYNC and the controller's heartbeat are ready when the tick begins; a node's frames (and strangers') when SYNC has
/// ended, after its latency and a seeded jitter; the commands when the last node has been heard on every bus and the
/// controller has computed; what comes after that, with the commands. What a tick does not finish goes on in
/// the next. No heap.
class TickTimeline {
 public:
  TickTimeline(const BusConfig&, double control_period_s, std::uint64_t seed) noexcept;

  /// Takes the run's frames in their order; a SYNC begins a tick.
  void take(const can::CanFrame&) noexcept;

  /// Lets every frame that waits end. Call once, after the last.
  void finish() noexcept;

  [[nodiscard]] std::uint32_t buses() const noexcept { return count_; }
  [[nodiscard]] const BusTally& tally(std::uint32_t bus) const noexcept { return bus_[bus].tally; }
  /// Load of the bus with the most; so far, frames that still wait are not in it.
  [[nodiscard]] double load_percent(std::int64_t elapsed_ns) const noexcept;

 private:
  struct Bus {
    Arbiter arbiter;
    BusTally tally;
    std::int64_t last_end_ns = 0;  ///< end of the last frame of this tick
    std::int64_t sync_end_ns = 0;
    std::uint32_t waiting_states = 0;  ///< state frames of this tick that have not gone yet
    bool has_sync_ended = false;

    /// Sends one frame that starts before `until_ns`; false when there is none.
    bool advance(std::int64_t until_ns) noexcept;
  };

  void begin_tick() noexcept;
  void end_sync() noexcept;
  void end_states() noexcept;
  void queue(const can::CanFrame&, const TrafficStream*) noexcept;
  [[nodiscard]] std::int64_t draw_jitter_ns() noexcept;

  enum class Stage : std::uint8_t { kSync, kStates, kCommands };

  std::array<Bus, kMaxBuses> bus_{};
  std::uint32_t count_;
  std::int64_t period_ns_;
  std::int64_t latency_ns_;
  std::int64_t jitter_ns_;
  std::int64_t compute_ns_;
  std::uint64_t random_;
  std::int64_t commands_ready_ns_ = 0;
  Stage stage_ = Stage::kSync;
  bool has_begun_ = false;
};

}  // namespace surefoot::sim_hw
