#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/can/can_bus.hpp"
#include "firmware/can/counter_watch.hpp"
#include "firmware/can/messages.hpp"
#include "firmware/can/node_roster.hpp"
#include "firmware/core/leg_command.hpp"
#include "firmware/core/safety/safe_state.hpp"
#include "firmware/core/sensor_snapshot.hpp"

namespace surefoot::can {

/// Running totals of the controller's side of the bus.
struct FrameCounters {
  std::uint64_t sent = 0;
  std::uint64_t refused_by_bus = 0;                        ///< the bus did not take them
  std::uint64_t received = 0;                              ///< accepted
  std::array<std::uint64_t, kRejectionCauses> rejected{};  ///< by `Rejection`
  std::uint64_t lost = 0;               ///< gaps in rolling counters: never came, or came late or damaged
  std::uint64_t from_other_master = 0;  ///< of the unknown identifiers: sent by another controller that runs now
};

/// The controller's end of the CAN contract: SYNC out, node frames in, commands out.
class FrameExchange {
 public:
  /// Before tick 0: sends the controller's heartbeat, as a rule pre-operational. To be called about ten times a
  /// second, for the nodes' readiness is counted in these.
  void announce(CanBus& bus, NodeState state) noexcept;

  /// Before tick 0: takes what has arrived. Heartbeats and emergencies count; states, answers to somebody
  /// else's SYNC, are refused as late. `finding` then names another master that was heard since `announce`.
  void listen(CanBus& bus) noexcept;

  /// All five nodes have announced our protocol version and are not stale (`NodeRoster`): tick 0 may begin.
  [[nodiscard]] bool is_everybody_ready() const noexcept { return roster_.is_everybody_ready(); }

  /// Starts tick k: sends SYNC(k), and the controller's heartbeat every 100 ticks.
  void begin_tick(CanBus& bus, std::uint32_t tick) noexcept;

  /// Takes what has arrived since, at most 256 frames a call so that a flooded bus cannot hold the
  /// tick; true once all five nodes have answered this tick's SYNC, or a simulated robot in lockstep says
  /// that no more will. Legs and feet with inertial sensors (their heartbeats say so, or such a frame of theirs has
  /// come) have answered with both their frames. Identifiers that are the controller's own to send (SYNC, commands, its
  /// heartbeat) count as unknown; `finding` tells a second master from a replay.
  [[nodiscard]] bool collect(CanBus& bus) noexcept;

  /// The snapshot of this tick; nodes that did not answer keep their last values, one tick older.
  /// Call once a tick, after the last `collect`.
  [[nodiscard]] const SensorSnapshot& finish_collecting() noexcept;

  /// Sends command(k) to both leg boards: LEG_POSITION to one in mode `kPosition`, LEG_COMMAND otherwise.
  void send_commands(CanBus& bus, const PerSide<LegCommand>& command) noexcept;

  /// Tells the bus of a latched fault: the controller's emergency, code 0xFF00 and the fault's number.
  void report(CanBus& bus, safety::Fault fault) noexcept;

  /// What speaks against going on: fault 6 in the tick (or the time since `announce`) in which another master
  /// was heard, fault 9 while a node speaks another protocol version.
  [[nodiscard]] safety::Finding finding() const noexcept;

  /// Before tick 0 a simulated robot in lockstep said that it is one. Only then its marker counts in the loop.
  [[nodiscard]] bool is_robot_in_lockstep() const noexcept { return is_robot_in_lockstep_; }

  /// @param node  one of `kSensorNodes`
  [[nodiscard]] const NodeStatus& node_status(Node node) const noexcept { return roster_.status(node); }

  [[nodiscard]] const FrameCounters& counters() const noexcept { return counters_; }

 private:
  /// One kind of answer to SYNC, by `slot` of the node.
  struct Answers {
    std::array<CounterWatch, kSensorNodes.size()> watch{};
    std::array<bool, kSensorNodes.size()> is_expected{};
    std::array<bool, kSensorNodes.size()> has_come{};  ///< in this tick

    [[nodiscard]] bool are_complete() const noexcept;
  };

  static constexpr std::size_t kBatchFrames = 32;
  static constexpr std::size_t kMaxBatches = 8;

  void send(CanBus& bus, std::span<const CanFrame> frames) noexcept;
  [[nodiscard]] CanFrame own_heartbeat(NodeState state) noexcept;
  void take_waiting(CanBus& bus) noexcept;
  void accept(const CanFrame& frame) noexcept;
  [[nodiscard]] Rejection judge(const CanFrame& frame) noexcept;
  [[nodiscard]] Rejection judge_foreigner(const CanFrame& frame) noexcept;
  [[nodiscard]] Rejection accept_state(Node node, const CanFrame& frame) noexcept;
  [[nodiscard]] Rejection accept_leg_state(Side side, const CanFrame& frame) noexcept;
  [[nodiscard]] Rejection accept_foot_force(Side side, const CanFrame& frame) noexcept;
  [[nodiscard]] Rejection accept_imu(const CanFrame& frame) noexcept;
  [[nodiscard]] Rejection accept_inertial(Node node, const CanFrame& frame) noexcept;
  [[nodiscard]] Rejection accept_leg_inertial(Side side, const CanFrame& frame) noexcept;
  [[nodiscard]] Rejection accept_foot_inertial(Side side, const CanFrame& frame) noexcept;
  void expect_inertial(Node node) noexcept;
  [[nodiscard]] Rejection accept_heartbeat(Node node, const CanFrame& frame) noexcept;
  [[nodiscard]] Rejection accept_emergency(Node node, const CanFrame& frame) noexcept;
  [[nodiscard]] Rejection accept_lockstep_served(const CanFrame& frame) noexcept;
  [[nodiscard]] Rejection judge_inertial(Node node, FrameStamp stamp) noexcept;
  [[nodiscard]] Rejection judge_answer(Node node, FrameStamp stamp, Answers& answers) noexcept;
  [[nodiscard]] Rejection judge_counter(CounterWatch& watch, FrameStamp stamp) noexcept;

  SensorSnapshot snapshot_{};
  FrameCounters counters_{};
  NodeRoster roster_{};
  Answers state_{.watch = {}, .is_expected = {true, true, true, true, true}, .has_come = {}};
  Answers inertial_{};
  std::array<CounterWatch, kSensorNodes.size()> heartbeat_watch_{};  ///< by `slot` of the node; so is the next
  std::array<CounterWatch, kSensorNodes.size()> emergency_watch_{};
  CounterWatch served_watch_{};
  bool is_robot_in_lockstep_ = false;
  bool is_served_ = false;  ///< the simulated robot will not answer this tick any further
  bool is_running_ = false;
  bool was_other_master_heard_ = false;  ///< since `begin_tick` or `announce`
  std::array<CanFrame, kBatchFrames> inbox_{};
  std::uint32_t tick_ = 0;
  std::uint8_t sync_counter_ = 0;
  std::uint8_t heartbeat_counter_ = 0;
  std::uint8_t emergency_counter_ = 0;
  PerSide<std::uint8_t> command_counter_{};   ///< of LEG_COMMAND
  PerSide<std::uint8_t> position_counter_{};  ///< of LEG_POSITION
};

}  // namespace surefoot::can
