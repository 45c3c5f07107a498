#include "sim_hw/simulated_robot.hpp"

#include <algorithm>
#include <cmath>

#include "firmware/can/counter_watch.hpp"
#include "firmware/can/messages.hpp"
#include "sim_hw/config_check.hpp"
#include "sim_hw/nodes/foot_node.hpp"
#include "sim_hw/nodes/imu_node.hpp"
#include "sim_hw/nodes/leg_board.hpp"
#include "sim_hw/truth_recorder.hpp"
#include "sim_hw/world/world.hpp"

namespace surefoot::sim_hw {
namespace {

constexpr std::size_t kBatchFrames = 16;
constexpr std::uint32_t kMaxLostTicks = 1000;  // beyond it the controller started anew

const SimConfig& checked(const SimConfig& config) {
  check(config);
  return config;
}

}  // namespace

struct SimulatedRobot::Parts {
  Parts(const SimConfig& wanted, const PerSide<LegVector>& initial_angle_rad)
      : config(checked(wanted)),
        steps_per_period(static_cast<int>(std::lround(config.control_period_s / config.physics_step_s))),
        world(config, initial_angle_rad),
        recorder(world, -config.time_zero_s),
        leg{LegBoard(Side::kRight, config), LegBoard(Side::kLeft, config)},
        foot{FootNode(Side::kRight, config.sensor, config.seed), FootNode(Side::kLeft, config.sensor, config.seed)},
        imu(config.sensor, config.seed) {
    std::stable_sort(config.payloads.begin(), config.payloads.end(),
                     [](const PayloadConfig& a, const PayloadConfig& b) { return a.at_s < b.at_s; });
  }

  void take(const can::CanFrame& frame) noexcept {
    can::Rejection verdict = can::Rejection::kUnknownIdentifier;
    if (frame.identifier == can::kSyncIdentifier) {
      verdict = take_sync(frame);
    } else if (frame.identifier == can::heartbeat_identifier(can::Node::kController)) {
      verdict = can::Rejection::kNone;  // nodes run without; listening costs nothing
    } else {
      for (const Side side : kSides) {
        if (frame.identifier == can::command_identifier(can::leg_node(side))) verdict = take_command(side, frame);
      }
    }
    if (verdict == can::Rejection::kNone) {
      ++counters.received;
    } else {
      ++counters.rejected[static_cast<std::size_t>(verdict)];
    }
  }

  can::Rejection take_sync(const can::CanFrame& frame) noexcept {
    can::FrameStamp stamp;
    if (const auto rejection = can::decode_sync(frame, stamp); rejection != can::Rejection::kNone) return rejection;
    if (was_synchronised && stamp.tick == tick) return can::Rejection::kRepeated;
    if (is_past(stamp.tick)) return can::Rejection::kLate;
    if (const auto rejection = sync_watch.step(stamp.counter); rejection != can::Rejection::kNone) return rejection;
    catch_up(stamp.tick);
    tick = stamp.tick;
    was_synchronised = true;
    is_period_open = true;

    const RobotModel& robot = world.robot();
    const PerSide<LegVector> angle_rad = robot.angles_rad();
    const PerSide<LegVector> rate_rad_s = robot.rates_rad_s();
    for (const Side side : kSides) {
      leg[index(side)].on_sync(tick, angle_rad[index(side)], rate_rad_s[index(side)], outbox);
      foot[index(side)].on_sync(tick, recorder.truth().corner_force_n[index(side)], outbox);
    }
    imu.on_sync(tick, recorder.torso(), outbox);
    return can::Rejection::kNone;
  }

  /// An old SYNC played back. Tick 0, and a tick from further back, is a controller that started anew.
  [[nodiscard]] bool is_past(std::uint32_t next_tick) const noexcept {
    return was_synchronised && next_tick != 0 && tick - next_tick <= kMaxLostTicks;
  }

  can::Rejection take_command(Side side, const can::CanFrame& frame) noexcept {
    const can::Rejection verdict = leg[index(side)].on_command(frame, outbox);
    if (is_period_open && leg[0].has_command() && leg[1].has_command()) advance_period();
    return verdict;
  }

  /// Periods that the controller has counted and the world has not.
  void catch_up(std::uint32_t next_tick) noexcept {
    if (!was_synchronised) return;
    const std::uint32_t elapsed = next_tick - tick;
    if (elapsed == 0 || elapsed > kMaxLostTicks) return;
    for (std::uint32_t lost = is_period_open ? elapsed : elapsed - 1; lost > 0; --lost) advance_period();
  }

  void advance_period() noexcept {
    is_period_open = false;
    PerSide<LegVector> torque_nm{};
    for (int i = 0; i < steps_per_period; ++i) {
      hang_due_payloads();
      const PerSide<LegVector> rate_rad_s = world.robot().rates_rad_s();
      for (const Side side : kSides) {
        torque_nm[index(side)] = leg[index(side)].begin_step(rate_rad_s[index(side)], outbox);
      }
      world.advance(torque_nm, config.physics_step_s);
      recorder.add_step(world.loads());
      ++step;
    }
    recorder.close_period(world, torque_nm, time_s(), steps_per_period, config.control_period_s);
  }

  /// Scenario time at the begin of the next step; counted, so that no error adds up.
  [[nodiscard]] double time_s() const noexcept {
    return static_cast<double>(step) * config.physics_step_s - config.time_zero_s;
  }

  void hang_due_payloads() noexcept {
    const double half_step_s = 0.5 * config.physics_step_s;
    while (next_payload < config.payloads.size() && config.payloads[next_payload].at_s < time_s() + half_step_s) {
      world.hang(config.payloads[next_payload]);
      ++next_payload;
    }
  }

  SimConfig config;
  int steps_per_period;
  World world;
  TruthRecorder recorder;
  PerSide<LegBoard> leg;
  PerSide<FootNode> foot;
  ImuNode imu;
  can::CounterWatch sync_watch;
  FrameOutbox outbox;
  NodeCounters counters;
  std::size_t next_payload = 0;
  std::uint64_t step = 0;
  std::uint32_t tick = 0;
  bool was_synchronised = false;
  bool is_period_open = false;  ///< SYNC came, the period of its tick has not been simulated yet
};

SimulatedRobot::SimulatedRobot(const SimConfig& config, const PerSide<LegVector>& initial_angle_rad)
    : parts_(std::make_unique<Parts>(config, initial_angle_rad)) {}

SimulatedRobot::~SimulatedRobot() = default;

void SimulatedRobot::serve(can::CanBus& bus) noexcept {
  std::array<can::CanFrame, kBatchFrames> batch;
  while (const std::size_t count = bus.receive(batch)) {
    for (std::size_t i = 0; i < count; ++i) {
      parts_->take(batch[i]);
      parts_->outbox.flush(bus);
    }
  }
}

const GroundTruth& SimulatedRobot::truth() const noexcept { return parts_->recorder.truth(); }

NodeCounters SimulatedRobot::counters() const noexcept {
  NodeCounters counters = parts_->counters;
  counters.sent = parts_->outbox.sent();
  counters.refused_by_bus = parts_->outbox.dropped();
  counters.lost = parts_->sync_watch.lost() + parts_->leg[0].lost() + parts_->leg[1].lost();
  return counters;
}

}  // namespace surefoot::sim_hw
