#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "sim_hw/bus/arbiter.hpp"
#include "sim_hw/bus/traffic.hpp"
#include "sim_hw/faults/fault_random.hpp"
#include "sim_hw/plant_config.hpp"

namespace surefoot::sim_hw {

/// The time that frames take in lockstep, where a tick itself takes none: they contend for the bus, or the two of
/// them, by their identifiers, and those that are not through when the tick ends arrive in the next.
///
/// SYNC is ready when the tick begins, a node's frames `node_latency_s` and a jitter after what it heard last, the
/// controller's other frames `compute_s` after what it heard last. No heap; about 40 KB.
class ContendedBus {
 public:
  ContendedBus(const BusConfig&, double control_period_s, std::uint64_t seed) noexcept;

  /// A frame that has crossed the bus.
  struct Arrival {
    can::CanFrame frame;
    bool is_for_nodes = false;
  };

  /// Frames of the past period that arrive only now. Call until there are none, then `begin_period`.
  /// @param elapsed  control periods that have passed since it began
  [[nodiscard]] std::optional<Arrival> finish_period(std::int64_t elapsed) noexcept;

  /// @param elapsed  the same as for `finish_period`
  void begin_period(std::int64_t period, std::int64_t elapsed) noexcept;

  /// Frames that a babbling node keeps for later when the bus is busy.
  static constexpr std::size_t kBabbleBacklog = 32;

  /// A frame that is ready at a share of the period, 0 to 1, whatever the others do. False: the sender's backlog is
  /// full, and the frame lost.
  bool babble(const can::CanFrame& frame, double at, bool is_for_nodes) noexcept;

  /// A frame of the tick. False: full, and lost.
  bool queue(const can::CanFrame& frame, bool is_for_nodes) noexcept;

  /// The next frame that crosses the bus, until all those given to `queue` have, or the period is over.
  [[nodiscard]] std::optional<Arrival> advance() noexcept;

 private:
  struct Bus {
    Arbiter arbiter;
    std::size_t waiting = 0;  ///< without babble
    std::size_t babble = 0;   ///< waiting as well
    std::optional<Arrival> late;
  };

  bool queue_on(std::uint16_t tag, can::CanFrame frame, std::int64_t ready_ns) noexcept;
  [[nodiscard]] std::optional<Transmission> transmit(Bus& bus, std::int64_t until_ns) noexcept;
  /// Nothing on the second of two buses that carry the same frame.
  [[nodiscard]] std::optional<Arrival> arrival_of(const can::CanFrame& tagged, std::uint32_t bus) const noexcept;

  std::array<Bus, kMaxBuses> bus_{};
  std::uint32_t count_;
  std::int64_t period_ns_;
  std::int64_t latency_ns_;
  double jitter_ns_;
  std::int64_t compute_ns_;
  FaultRandom random_;
  std::int64_t period_ = 0;
  std::int64_t heard_ns_ = 0;             ///< end of the last frame
  std::int64_t controller_ready_ns_ = 0;  ///< when the controller has computed
};

}  // namespace surefoot::sim_hw
