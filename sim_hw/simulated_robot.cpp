#include "sim_hw/simulated_robot.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "firmware/can/messages.hpp"
#include "sim_hw/config_check.hpp"
#include "sim_hw/faults/fault_schedule.hpp"
#include "sim_hw/master_watch.hpp"
#include "sim_hw/nodes/robot_nodes.hpp"
#include "sim_hw/truth_recorder.hpp"
#include "sim_hw/wire_clock.hpp"
#include "sim_hw/world/disturbances.hpp"
#include "sim_hw/world/world.hpp"

namespace surefoot::sim_hw {
namespace {

constexpr std::int64_t kFreeRunningSlackTicks = 5;  // a SYNC that was late, and one that is early

const SimConfig& checked(const SimConfig& config) {
  check(config);
  return config;
}

}  // namespace

/// The way of frames through the scenario's faults; only a robot without one is copied.
struct OwnLine : std::unique_ptr<BusLine> {
  using std::unique_ptr<BusLine>::operator=;
  OwnLine() = default;
  OwnLine(const OwnLine&) noexcept : unique_ptr() {}
  OwnLine& operator=(const OwnLine&) = delete;
};

struct SimulatedRobot::Parts {
  Parts(const SimConfig& wanted, const PerSide<LegVector>& initial_angle_rad, WorldClock wanted_clock)
      : config(checked(wanted)),
        clock(wanted_clock),
        steps_per_period(static_cast<int>(std::lround(config.control_period_s / config.physics_step_s))),
        watchdog_steps(std::llround(config.watchdog_s / config.physics_step_s)),
        world(config, initial_angle_rad),
        disturbances(config),
        recorder(world, -config.time_zero_s, config.sensor.has_inertial_legs),
        nodes(config),
        answers(config.sensor.has_inertial_legs),
        schedule(config.faults, config.control_period_s) {
    if (!schedule.is_empty()) line = make_line();
  }

  [[nodiscard]] std::unique_ptr<BusLine> make_line() {
    auto made = std::make_unique<BusLine>(schedule, config.seed, answers);
    const bool is_crowded =
        std::ranges::any_of(config.faults, [](const FaultConfig& fault) { return fault.kind == FaultKind::kBabble; });
    if (is_crowded && clock == WorldClock::kLockstep) made->contend(config.bus, config.control_period_s, config.seed);
    return made;
  }

  /// A frame from the bus, with all that follows from it.
  void serve(const can::CanFrame& frame, can::CanBus& bus) noexcept {
    if (!line) {
      take(frame);
      flush(bus);
      return;
    }
    line->connect(bus);
    if (clock == WorldClock::kLockstep && wire.on_frame(frame)) {
      answers.begin_tick(wire.tick());
      const std::int64_t period = wire.periods_until(wire.tick());
      begin_period(period, static_cast<double>(period) * config.control_period_s - config.time_zero_s);
    }
    line->enter(frame);
    can::CanFrame heard;
    while (line->receive({&heard, 1}) == 1) {
      take(heard);
      flush(bus);
    }
  }

  void flush(can::CanBus& bus) noexcept {
    if (line) {
      line->connect(bus);
      outbox.flush(*line);
    } else {
      answers.note(outbox.flush(bus));
    }
  }

  /// Free running: the faults' clock is the world's.
  void begin_free_period(can::CanBus& bus) noexcept {
    if (!line || !was_driven || steps_in_period != 0) return;
    line->connect(bus);
    begin_period(step / steps_per_period, time_s());
  }

  void begin_period(std::int64_t period, double begin_s) noexcept {
    const std::uint32_t active = schedule.active(begin_s);
    recorder.mark_faults(active);
    line->begin_period(period, active);
    nodes.begin_fault_tick(begin_s, period);
  }

  /// Nodes lose and regain their power with the world's time.
  void update_power() noexcept {
    if (!line || !was_driven) return;
    const NodeSet before = std::exchange(unpowered, schedule.unpowered(schedule.active(time_s())));
    nodes.for_each([&](can::Node name, auto& node) {
      if (before.has(name) && !unpowered.has(name)) node.restart(outbox);
    });
  }

  [[nodiscard]] can::CanFrame served_marker(std::uint32_t tick) noexcept {
    return can::encode_lockstep_served({.tick = tick, .counter = marker_counter++});
  }

  [[nodiscard]] bool hears(can::Node node) const noexcept { return !line || line->hears(node); }

  void take(const can::CanFrame& frame) noexcept {
    can::Rejection verdict = can::Rejection::kUnknownIdentifier;
    if (frame.identifier == can::kSyncIdentifier) {
      verdict = take_sync(frame);
    } else if (frame.identifier == can::heartbeat_identifier(can::Node::kController)) {
      verdict = master.on_heartbeat(frame);
    } else if (frame.identifier == can::emergency_identifier(can::Node::kController)) {
      can::FrameStamp stamp;
      can::Emergency emergency;
      verdict = can::decode_emergency(frame, stamp, emergency);  // for people with candump; no node acts on it
    } else {
      for (const Side side : kSides) {
        const can::Node node = can::leg_node(side);
        const bool is_addressee =
            frame.identifier == can::command_identifier(node) || frame.identifier == can::position_identifier(node);
        if (is_addressee) verdict = take_command(side, frame);
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
    const bool is_first = !master.is_present();
    if (is_first && expects_power_up && stamp.tick != 0) return can::Rejection::kLate;
    const bool is_back = is_first && has_come_back(stamp.tick);
    const std::uint32_t last_tick = master.tick();
    if (const auto rejection = master.on_sync(stamp, max_gap_ticks()); rejection != can::Rejection::kNone) {
      return rejection;
    }
    if (is_first) {
      if (!is_back) clock_origin_step = step - wire.periods_until(stamp.tick) * steps_per_period;
      tick_of_period = stamp.tick;
      first_tick = stamp.tick;
    } else if (clock == WorldClock::kLockstep) {
      catch_up(stamp.tick - last_tick);
    }
    is_period_open = true;
    was_driven = true;
    silent_steps = 0;
    if (!line || clock == WorldClock::kFreeRunning) answers.begin_tick(stamp.tick);
    if (clock == WorldClock::kLockstep) update_power();  // free running: at the begin of a period, as the line does

    const SensedState sensed{.angle_rad = world.motor_angles_rad(),
                             .rate_rad_s = world.motor_rates_rad_s(),
                             .corner_force_n = recorder.truth().corner_force_n,
                             .torso = recorder.torso(),
                             .leg_inertial = recorder.leg_inertial()};
    nodes.on_sync(
        stamp.tick, sensed, [this](can::Node node) { return hears(node); }, outbox);
    return can::Rejection::kNone;
  }

  can::Rejection take_command(Side side, const can::CanFrame& frame) noexcept {
    if (!master.may_command()) return can::Rejection::kUnknownIdentifier;
    const can::Rejection verdict = nodes.leg[index(side)].on_command(frame, outbox);
    const bool is_complete = is_period_open && std::ranges::all_of(kSides, [&](Side one) {
                               return nodes.leg[index(one)].has_command() || !hears(can::leg_node(one));
                             });
    if (clock == WorldClock::kLockstep && is_complete) advance_period();
    return verdict;
  }

  /// Free running: a master that was released for its silence goes on where it would be now.
  [[nodiscard]] bool has_come_back(std::uint32_t tick) const noexcept {
    if (clock != WorldClock::kFreeRunning || !was_driven) return false;
    const std::int64_t gap = static_cast<std::int64_t>(tick) - master.tick();
    return gap > 0 && gap <= silent_steps / steps_per_period + kFreeRunningSlackTicks;
  }

  /// How far the master may be ahead of its last SYNC. A world of its own clock knows how long ago that was.
  [[nodiscard]] std::uint32_t max_gap_ticks() const noexcept {
    if (clock == WorldClock::kLockstep) return MasterWatch::kMaxLostTicks;
    return static_cast<std::uint32_t>(silent_steps / steps_per_period + kFreeRunningSlackTicks);
  }

  void release_master() noexcept {
    master.release();
    is_period_open = false;
    wire.stop();
    for (LegBoard& board : nodes.leg) board.release_master();
  }

  /// Periods that the controller has counted and the world has not.
  void catch_up(std::uint32_t elapsed_ticks) noexcept {
    for (std::uint32_t lost = is_period_open ? elapsed_ticks : elapsed_ticks - 1; lost > 0; --lost) advance_period();
  }

  void advance_period() noexcept {
    is_period_open = false;
    do {
      advance_step();
    } while (steps_in_period != 0);
  }

  void advance_step() noexcept {
    if (steps_in_period == 0) update_power();
    if (master.is_present()) disturbances.begin_due(time_s(), world);
    disturbances.push(world);
    const PerSide<LegVector> angle_rad = world.motor_angles_rad();
    const PerSide<LegVector> rate_rad_s = world.motor_rates_rad_s();
    PerSide<LegVector> torque_nm{};
    for (const Side side : kSides) {
      if (unpowered.has(can::leg_node(side))) continue;
      const std::size_t i = index(side);
      torque_nm[i] = nodes.leg[i].begin_step(angle_rad[i], rate_rad_s[i], outbox);
    }
    world.advance(torque_nm, config.physics_step_s);
    recorder.add_step(world.loads());
    ++step;
    ++silent_steps;
    if (++steps_in_period == steps_per_period) {
      steps_in_period = 0;
      ++periods;
      truth_tick = tick_of_period++;
      recorder.mark_pushes(disturbances.pushes_begun(), disturbances.pushes_ended());
      recorder.close_period(world, torque_nm, time_s(), steps_per_period, config.control_period_s);
    }
    if (clock == WorldClock::kFreeRunning && master.is_present() && silent_steps > watchdog_steps) release_master();
  }

  /// Scenario time at the begin of the next step; counted, so that no error adds up.
  [[nodiscard]] double time_s() const noexcept {
    return static_cast<double>(step - clock_origin_step) * config.physics_step_s - config.time_zero_s;
  }

  SimConfig config;
  WorldClock clock;
  int steps_per_period;
  std::int64_t watchdog_steps;
  World world;
  Disturbances disturbances;
  TruthRecorder recorder;
  RobotNodes nodes;
  MasterWatch master;
  FrameOutbox outbox;
  AnswerWatch answers;
  FaultSchedule schedule;
  OwnLine line;  ///< none without faults
  NodeSet unpowered;
  NodeCounters counters;
  std::int64_t step = 0;               ///< since the start
  std::int64_t clock_origin_step = 0;  ///< step of the master's first SYNC
  std::int64_t silent_steps = 0;       ///< since the last SYNC
  int steps_in_period = 0;
  std::uint8_t marker_counter = 0;
  std::int64_t periods = 0;          ///< closed since the start
  std::uint32_t first_tick = 0;      ///< of the master that came last
  std::uint32_t tick_of_period = 0;  ///< master's tick of the period that runs or comes next
  std::uint32_t truth_tick = 0;      ///< of the last closed one
  WireClock wire;                    ///< without faults it stands still
  bool expects_power_up = false;
  bool was_driven = false;
  bool is_period_open = false;  ///< SYNC came, the period of its tick has not been simulated yet
};

SimulatedRobot::SimulatedRobot(const SimConfig& config, const PerSide<LegVector>& initial_angle_rad, WorldClock clock)
    : parts_(std::make_unique<Parts>(config, initial_angle_rad, clock)) {}

SimulatedRobot::SimulatedRobot(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}

SimulatedRobot::~SimulatedRobot() = default;

bool SimulatedRobot::can_branch(const SimConfig& config) noexcept {
  return config.faults.empty() && config.contact.model == ContactModel::kSpringDamper;
}

std::unique_ptr<SimulatedRobot> SimulatedRobot::branch(const SimConfig& config) const {
  auto parts = std::make_unique<Parts>(*parts_);
  parts->config = config;
  parts->disturbances = Disturbances(config);
  parts->world.reserve_boxes(config.payloads.size());
  return std::unique_ptr<SimulatedRobot>(new SimulatedRobot(std::move(parts)));
}

void SimulatedRobot::serve(can::CanBus& bus) noexcept {
  const std::int64_t periods_before = parts_->periods;
  can::CanFrame frame;
  // One by one: a master that goes on without its answers ends a period in the middle of what waits on the bus, and no
  // period may go unseen.
  while (parts_->periods == periods_before && bus.receive({&frame, 1}) == 1) parts_->serve(frame, bus);
}

void SimulatedRobot::advance_to(double world_time_s, can::CanBus& bus) noexcept {
  const auto target = static_cast<std::int64_t>(world_time_s / parts_->config.physics_step_s);
  while (parts_->step < target) {
    parts_->begin_free_period(bus);
    parts_->advance_step();
    parts_->flush(bus);
  }
}

void SimulatedRobot::announce(can::CanBus& bus) noexcept {
  // First, so that whoever has heard all nodes knows what drives this robot's time.
  if (parts_->clock == WorldClock::kLockstep) parts_->outbox.add(parts_->served_marker(can::kAnnouncedBeforeAnyTick));
  parts_->nodes.for_each([this](can::Node name, auto& node) {
    if (!parts_->unpowered.has(name)) node.announce(parts_->outbox);
  });
  parts_->flush(bus);
}

void SimulatedRobot::tell_served(can::CanBus& bus) noexcept {
  const can::CanFrame marker = parts_->served_marker(wire_tick());
  static_cast<void>(bus.send({&marker, 1}));
}

void SimulatedRobot::release_master() noexcept { parts_->release_master(); }

bool SimulatedRobot::has_master() const noexcept { return parts_->master.is_present(); }

bool SimulatedRobot::has_answered_fully() const noexcept { return parts_->answers.is_complete(); }

std::uint32_t SimulatedRobot::wire_tick() const noexcept {
  return parts_->wire.has_begun() ? parts_->wire.tick() : parts_->master.tick();
}

std::uint32_t SimulatedRobot::tick() const noexcept { return parts_->master.tick(); }

std::uint32_t SimulatedRobot::first_tick() const noexcept { return parts_->first_tick; }

void SimulatedRobot::expect_power_up(bool is_expected) noexcept { parts_->expects_power_up = is_expected; }

std::int64_t SimulatedRobot::periods() const noexcept { return parts_->periods; }

std::uint32_t SimulatedRobot::truth_tick() const noexcept { return parts_->truth_tick; }

const GroundTruth& SimulatedRobot::truth() const noexcept { return parts_->recorder.truth(); }

NodeCounters SimulatedRobot::counters() const noexcept {
  NodeCounters counters = parts_->counters;
  counters.sent = parts_->outbox.sent();
  counters.refused_by_bus = parts_->outbox.dropped();
  if (parts_->line) counters.faults = parts_->line->counters();
  counters.lost = parts_->master.lost() + parts_->nodes.leg[0].lost() + parts_->nodes.leg[1].lost();
  return counters;
}

}  // namespace surefoot::sim_hw
