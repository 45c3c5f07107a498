#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "firmware/can/can_bus.hpp"
#include "sim_hw/faults/answer_watch.hpp"
#include "sim_hw/faults/contended_bus.hpp"
#include "sim_hw/faults/fault_config.hpp"
#include "sim_hw/faults/fault_random.hpp"
#include "sim_hw/faults/fault_schedule.hpp"
#include "sim_hw/faults/frame_queue.hpp"

namespace surefoot::sim_hw {

/// What the faults have done to frames so far.
struct FaultCounters {
  std::uint64_t dropped = 0;
  std::uint64_t duplicated = 0;  ///< additional copies
  std::uint64_t delayed = 0;
  std::uint64_t corrupted = 0;
  std::uint64_t corrupted_unnoticed = 0;  ///< of those, intact to every check that a receiver makes
  std::uint64_t swapped = 0;
  std::uint64_t silenced = 0;  ///< of or for a node off the bus, or on a link that was down
  std::uint64_t babbled = 0;
  std::uint64_t overflowed = 0;  ///< no room in the line's own queues, or on the bus, and lost
};

/// The stretch of bus between the robot's nodes and everybody else, where frames go wrong, in both directions.
///
/// Faults work on a frame in the scenario's order. A frame that several delay is late by the sum. Where the
/// frames of a tick contend for the bus, what a babbling node sends keeps those of lower priority from arriving
/// in their tick; otherwise it only fills the receivers' queues. No heap after construction; about 400 KB.
class BusLine final : public can::CanBus {
 public:
  /// @param schedule  outlives the line
  /// @param answers   told of every answer to its tick's SYNC that leaves in this tick and intact; outlives the line
  BusLine(const FaultSchedule& schedule, std::uint64_t seed, AnswerWatch& answers);

  /// Lockstep: from now on frames contend for the bus.
  void contend(const BusConfig& bus, double control_period_s, std::uint64_t seed) {
    contention_.emplace(bus, control_period_s, seed);
  }

  /// The bus behind it, for the calls that follow.
  void connect(can::CanBus& bus) noexcept { bus_ = &bus; }

  /// A control period begins: delayed frames that are due go on, babbling nodes babble.
  /// @param active  the faults that are on in it
  void begin_period(std::int64_t period, std::uint32_t active) noexcept;

  /// A frame from the bus begins its way to the nodes.
  void enter(const can::CanFrame& frame) noexcept;

  /// Nodes to bus. Returns how many were taken: those lost to a fault count as taken.
  std::size_t send(std::span<const can::CanFrame> frames) noexcept override;

  /// Bus to nodes: what has entered and came through.
  std::size_t receive(std::span<can::CanFrame> frames) noexcept override;

  /// Whether a node hears what is sent to all.
  [[nodiscard]] bool hears(can::Node node) const noexcept { return !off_bus_.has(node); }

  [[nodiscard]] const FaultCounters& counters() const noexcept { return counters_; }

 private:
  enum class Direction : std::uint8_t { kToNodes, kToController };

  /// A frame on its way, or one of its copies.
  struct Passing {
    can::CanFrame frame;
    std::uint32_t delay_ticks = 0;
  };
  /// What has become of one frame.
  struct Batch {
    std::array<Passing, 81> passing;  ///< 1 + 8 copies, twice
    std::size_t count = 0;
  };
  struct Delayed {
    can::CanFrame frame;
    std::int64_t due_period = 0;
    Direction direction = Direction::kToNodes;
  };
  struct Count {
    std::int64_t period = -1;
    std::uint32_t count = 0;
  };
  static constexpr std::size_t kIdentifiers = 0x800;
  static constexpr std::size_t kDelayedFrames = 2048;

  void pass(const can::CanFrame& frame, Direction direction) noexcept;
  void befall(const FaultConfig& fault, std::uint64_t draw) noexcept;
  void multiply(std::size_t copies) noexcept;
  void deliver(const can::CanFrame& frame, Direction direction) noexcept;
  void pump() noexcept;
  void arrive(const can::CanFrame& frame, Direction direction) noexcept;
  void hold_back(const Passing& passing, Direction direction) noexcept;
  void release_due() noexcept;
  void babble(std::size_t place) noexcept;
  [[nodiscard]] bool is_cut(const can::CanFrame& frame, Direction direction) const noexcept;
  [[nodiscard]] std::uint32_t ordinal(std::uint16_t identifier, Direction direction) noexcept;

  const FaultSchedule& schedule_;
  AnswerWatch& answers_;
  std::vector<FaultRandom> random_;  ///< by fault
  can::CanBus* bus_ = nullptr;
  std::int64_t period_ = 0;
  std::uint32_t active_ = 0;
  NodeSet off_bus_;
  bool is_link_down_ = false;
  std::optional<ContendedBus> contention_;
  Batch batch_;
  FrameQueue inbound_;
  std::vector<Delayed> delayed_;
  std::vector<Count> seen_;  ///< by direction and identifier
  std::array<std::uint8_t, kMaxFaults> babble_counter_{};
  std::size_t refused_ = 0;
  FaultCounters counters_;
};

}  // namespace surefoot::sim_hw
