#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/can/can_bus.hpp"
#include "firmware/can/counter_watch.hpp"
#include "firmware/can/messages.hpp"
#include "firmware/core/leg_command.hpp"
#include "firmware/core/sensor_snapshot.hpp"

namespace surefoot::can {

/// Running totals of the controller's side of the bus.
struct FrameCounters {
  std::uint64_t sent = 0;
  std::uint64_t refused_by_bus = 0;         ///< the bus did not take them
  std::uint64_t received = 0;               ///< accepted
  std::array<std::uint64_t, 7> rejected{};  ///< by `Rejection`
  std::uint64_t lost = 0;                   ///< gaps in rolling counters: never came, or came late or damaged
};

/// The controller's end of the CAN contract: SYNC out, node frames in, torques out.
class FrameExchange {
 public:
  /// Starts tick k: sends SYNC(k), and the controller's heartbeat every 100 ticks.
  void begin_tick(CanBus& bus, std::uint32_t tick) noexcept;

  /// Takes what has arrived since, at most 256 frames a call so that a flooded bus cannot hold the
  /// tick; true once all five nodes have answered this tick's SYNC. Identifiers that are the
  /// controller's own to send (SYNC, commands) count as unknown: somebody else is driving.
  [[nodiscard]] bool collect(CanBus& bus) noexcept;

  /// The snapshot of this tick; nodes that did not answer keep their last values, one tick older.
  /// Call once a tick, after the last `collect`.
  [[nodiscard]] const SensorSnapshot& finish_collecting() noexcept;

  /// Sends torque(k) to both leg boards.
  void send_commands(CanBus& bus, const PerSide<LegCommand>& command) noexcept;

  [[nodiscard]] const FrameCounters& counters() const noexcept { return counters_; }

 private:
  static constexpr std::size_t kBatchFrames = 32;
  static constexpr std::size_t kMaxBatches = 8;
  static constexpr std::size_t kSensorNodes = 5;

  void send(CanBus& bus, std::span<const CanFrame> frames) noexcept;
  void accept(const CanFrame& frame) noexcept;
  [[nodiscard]] Rejection accept_state(Node node, const CanFrame& frame) noexcept;
  [[nodiscard]] Rejection accept_leg_state(Side side, const CanFrame& frame) noexcept;
  [[nodiscard]] Rejection accept_foot_force(Side side, const CanFrame& frame) noexcept;
  [[nodiscard]] Rejection accept_imu(const CanFrame& frame) noexcept;
  [[nodiscard]] Rejection accept_heartbeat(Node node, const CanFrame& frame) noexcept;
  [[nodiscard]] Rejection accept_emergency(Node node, const CanFrame& frame) noexcept;
  [[nodiscard]] Rejection judge_state(Node node, FrameStamp stamp) noexcept;
  [[nodiscard]] Rejection judge_counter(CounterWatch& watch, FrameStamp stamp) noexcept;

  SensorSnapshot snapshot_{};
  FrameCounters counters_{};
  std::array<CounterWatch, kSensorNodes> state_watch_{};  ///< by node, 1 to 5; so are the next three
  std::array<CounterWatch, kSensorNodes> heartbeat_watch_{};
  std::array<CounterWatch, kSensorNodes> emergency_watch_{};
  std::array<bool, kSensorNodes> answered_{};
  std::array<CanFrame, kBatchFrames> inbox_{};
  std::uint32_t tick_ = 0;
  std::uint8_t sync_counter_ = 0;
  std::uint8_t heartbeat_counter_ = 0;
  PerSide<std::uint8_t> command_counter_{};
};

}  // namespace surefoot::can
