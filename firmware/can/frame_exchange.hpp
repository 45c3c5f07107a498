#pragma once

#include <array>
#include <cstdint>

#include "firmware/can/can_bus.hpp"
#include "firmware/can/counter_watch.hpp"
#include "firmware/can/messages.hpp"
#include "firmware/core/leg_command.hpp"
#include "firmware/core/sensor_snapshot.hpp"

namespace surefoot::can {

/// Running totals of the controller's side of the bus.
struct FrameCounters {
  std::uint64_t sent = 0;
  std::uint64_t refused_by_bus = 0;  ///< the bus did not take them
  std::uint64_t received = 0;        ///< accepted
  std::array<std::uint64_t, 7> rejected{};  ///< by `Rejection`
  std::uint64_t lost = 0;            ///< gaps in rolling counters
};

/// The controller's end of the CAN contract: SYNC out, node frames in, torques out.
class FrameExchange {
 public:
  /// Starts tick k: sends SYNC(k), and the controller's heartbeat every 100 ticks.
  void begin_tick(CanBus& bus, std::uint32_t tick) noexcept;

  /// Takes what has arrived since; true once all five nodes have answered this tick's SYNC.
  [[nodiscard]] bool collect(CanBus& bus) noexcept;

  /// The snapshot of this tick; nodes that did not answer keep their last values, one tick older.
  /// Call once a tick, after the last `collect`.
  [[nodiscard]] const SensorSnapshot& finish_collecting() noexcept;

  /// Sends torque(k) to both leg boards.
  void send_commands(CanBus& bus, const PerSide<LegCommand>& command) noexcept;

  [[nodiscard]] const FrameCounters& counters() const noexcept { return counters_; }
  [[nodiscard]] const PerSide<LegStatus>& leg_status() const noexcept { return leg_status_; }

 private:
  void accept(const CanFrame& frame) noexcept;

  SensorSnapshot snapshot_{};
  PerSide<LegStatus> leg_status_{};
  FrameCounters counters_{};
  std::array<CounterWatch, 5> state_watch_{};  ///< by node, 1 to 5
  std::array<bool, 5> answered_{};
  std::uint32_t tick_ = 0;
  std::uint8_t sync_counter_ = 0;
  std::uint8_t heartbeat_counter_ = 0;
  PerSide<std::uint8_t> command_counter_{};
};

}  // namespace surefoot::can
