#include "firmware/can/frame_exchange.hpp"

#include <algorithm>

#include "firmware/can/other_master.hpp"

namespace surefoot::can {
namespace {

constexpr std::uint32_t kHeartbeatPeriodTicks = 100;
constexpr std::uint16_t kEmergencyFault = 0xFF00;  // CiA 301: device specific
constexpr std::uint8_t kGenericError = 0x01;       // error register, bit 0

// CiA 301: the upper four bits of an identifier say what it is, the lower seven who sends it. The
// decoders look at the whole of it again.
constexpr std::uint16_t kFunctionMask = 0x780;
constexpr std::uint16_t kNodeMask = 0x07F;

void age(Freshness& freshness, bool answered) noexcept {
  if (answered) {
    freshness.age_ticks = 0;
  } else if (freshness.age_ticks < Freshness::kNeverHeard - 1) {
    ++freshness.age_ticks;
  }
}

}  // namespace

void FrameExchange::announce(CanBus& bus, NodeState state) noexcept {
  was_other_master_heard_ = false;
  const CanFrame heartbeat = own_heartbeat(state);
  send(bus, {&heartbeat, 1});
}

void FrameExchange::listen(CanBus& bus) noexcept { take_waiting(bus); }

void FrameExchange::begin_tick(CanBus& bus, std::uint32_t tick) noexcept {
  const bool has_missed_ticks = is_running_ && tick != tick_ + 1;
  tick_ = tick;
  snapshot_.tick = tick;
  state_.has_come.fill(false);
  inertial_.has_come.fill(false);
  is_served_ = false;
  is_running_ = true;
  was_other_master_heard_ = false;
  std::array<CanFrame, 2> frames{encode_sync({.tick = tick, .counter = sync_counter_++})};
  std::size_t count = 1;
  // After a gap too: boards that gave this master up for lost would refuse its torques until the next one.
  if (tick % kHeartbeatPeriodTicks == 0 || has_missed_ticks) frames[count++] = own_heartbeat(NodeState::kOperational);
  send(bus, std::span(frames).first(count));
}

bool FrameExchange::collect(CanBus& bus) noexcept {
  take_waiting(bus);
  return is_served_ || (state_.are_complete() && inertial_.are_complete());
}

const SensorSnapshot& FrameExchange::finish_collecting() noexcept {
  for (const Side side : kSides) {
    const std::size_t leg = slot(leg_node(side));
    const std::size_t foot = slot(foot_node(side));
    age(snapshot_.leg[index(side)].freshness, state_.has_come[leg]);
    age(snapshot_.foot[index(side)].freshness, state_.has_come[foot]);
    age(snapshot_.leg_inertial[index(side)].freshness, inertial_.has_come[leg]);
    age(snapshot_.foot_inertial[index(side)].freshness, inertial_.has_come[foot]);
  }
  age(snapshot_.torso.freshness, state_.has_come[slot(Node::kTorsoImu)]);
  return snapshot_;
}

void FrameExchange::send_commands(CanBus& bus, const PerSide<LegCommand>& command) noexcept {
  std::array<CanFrame, kSides.size()> frames;
  for (const Side side : kSides) {
    const std::size_t i = index(side);
    auto& counter = command[i].mode == LegMode::kPosition ? position_counter_ : command_counter_;
    frames[i] = encode_leg_command(side, {.tick = tick_, .counter = counter[i]++}, command[i]);
  }
  send(bus, frames);
}

void FrameExchange::report(CanBus& bus, safety::Fault fault) noexcept {
  const auto code = static_cast<std::uint16_t>(kEmergencyFault + static_cast<std::uint16_t>(fault));
  const CanFrame emergency = encode_emergency(Node::kController, {.tick = tick_, .counter = emergency_counter_++},
                                              {.code = code, .error_register = kGenericError});
  send(bus, {&emergency, 1});
}

safety::Finding FrameExchange::finding() const noexcept {
  const safety::Finding second_master =
      was_other_master_heard_ ? finding_of(safety::Fault::kSecondMaster) : safety::Finding{};
  return followed_by(second_master, roster_.finding());
}

CanFrame FrameExchange::own_heartbeat(NodeState state) noexcept {
  roster_.on_own_heartbeat();
  return encode_heartbeat(Node::kController, {.tick = tick_, .counter = heartbeat_counter_++}, {.state = state});
}

void FrameExchange::send(CanBus& bus, std::span<const CanFrame> frames) noexcept {
  const std::size_t taken = bus.send(frames);
  counters_.sent += taken;
  counters_.refused_by_bus += frames.size() - taken;
}

void FrameExchange::take_waiting(CanBus& bus) noexcept {
  for (std::size_t batch = 0; batch < kMaxBatches; ++batch) {
    const std::size_t count = bus.receive(inbox_);
    for (std::size_t i = 0; i < count; ++i) accept(inbox_[i]);
    if (count < inbox_.size()) break;
  }
}

void FrameExchange::accept(const CanFrame& frame) noexcept {
  const Rejection rejection = judge(frame);
  if (rejection == Rejection::kNone) {
    ++counters_.received;
  } else {
    ++counters_.rejected[static_cast<std::size_t>(rejection)];
  }
}

Rejection FrameExchange::judge(const CanFrame& frame) noexcept {
  if (frame.identifier == kLockstepServedIdentifier) return accept_lockstep_served(frame);
  const auto node = static_cast<Node>(frame.identifier & kNodeMask);
  const bool is_sensor_node = node >= Node::kLegRight && node <= Node::kTorsoImu;
  if (is_sensor_node) {
    switch (frame.identifier & kFunctionMask) {
      case state_identifier(Node{0}):
        return accept_state(node, frame);
      case inertial_identifier(Node{0}):
        return accept_inertial(node, frame);
      case heartbeat_identifier(Node{0}):
        return accept_heartbeat(node, frame);
      case emergency_identifier(Node{0}):
        return accept_emergency(node, frame);
      default:
        break;
    }
  }
  return judge_foreigner(frame);
}

Rejection FrameExchange::judge_foreigner(const CanFrame& frame) noexcept {
  if (is_running_ ? is_of_another_master(frame, tick_) : is_of_a_master(frame)) {
    was_other_master_heard_ = true;
    ++counters_.from_other_master;
  }
  return Rejection::kUnknownIdentifier;
}

Rejection FrameExchange::accept_lockstep_served(const CanFrame& frame) noexcept {
  FrameStamp stamp;
  if (const Rejection rejection = decode_lockstep_served(frame, stamp); rejection != Rejection::kNone) return rejection;
  if (!is_running_) {
    is_robot_in_lockstep_ = true;
    return Rejection::kNone;
  }
  if (!is_robot_in_lockstep_) return Rejection::kUnknownIdentifier;
  // An announcement that crossed our first SYNC on the way.
  if (stamp.tick == kAnnouncedBeforeAnyTick) return Rejection::kNone;
  if (stamp.tick != tick_) return Rejection::kLate;
  const Rejection rejection = judge_counter(served_watch_, stamp);
  if (rejection == Rejection::kNone) is_served_ = true;
  return rejection;
}

Rejection FrameExchange::accept_state(Node node, const CanFrame& frame) noexcept {
  switch (node) {
    case Node::kLegRight:
      return accept_leg_state(Side::kRight, frame);
    case Node::kLegLeft:
      return accept_leg_state(Side::kLeft, frame);
    case Node::kFootRight:
      return accept_foot_force(Side::kRight, frame);
    case Node::kFootLeft:
      return accept_foot_force(Side::kLeft, frame);
    case Node::kTorsoImu:
      return accept_imu(frame);
    default:
      return Rejection::kUnknownIdentifier;
  }
}

Rejection FrameExchange::accept_leg_state(Side side, const CanFrame& frame) noexcept {
  FrameStamp stamp;
  LegSensors heard = snapshot_.leg[index(side)];
  LegStatus status;
  Rejection rejection = decode_leg_state(frame, stamp, heard, status);
  if (rejection == Rejection::kNone) rejection = judge_answer(leg_node(side), stamp, state_);
  if (rejection != Rejection::kNone) return rejection;
  heard.is_damping = status.is_damping;
  snapshot_.leg[index(side)] = heard;
  return Rejection::kNone;
}

Rejection FrameExchange::accept_foot_force(Side side, const CanFrame& frame) noexcept {
  FrameStamp stamp;
  FootSensors heard = snapshot_.foot[index(side)];
  Rejection rejection = decode_foot_force(frame, stamp, heard);
  if (rejection == Rejection::kNone) rejection = judge_answer(foot_node(side), stamp, state_);
  if (rejection == Rejection::kNone) snapshot_.foot[index(side)] = heard;
  return rejection;
}

Rejection FrameExchange::accept_imu(const CanFrame& frame) noexcept {
  FrameStamp stamp;
  ImuSensors heard = snapshot_.torso;
  Rejection rejection = decode_imu(frame, stamp, heard);
  if (rejection == Rejection::kNone) rejection = judge_answer(Node::kTorsoImu, stamp, state_);
  if (rejection == Rejection::kNone) snapshot_.torso = heard;
  return rejection;
}

Rejection FrameExchange::accept_inertial(Node node, const CanFrame& frame) noexcept {
  switch (node) {
    case Node::kLegRight:
      return accept_leg_inertial(Side::kRight, frame);
    case Node::kLegLeft:
      return accept_leg_inertial(Side::kLeft, frame);
    case Node::kFootRight:
      return accept_foot_inertial(Side::kRight, frame);
    case Node::kFootLeft:
      return accept_foot_inertial(Side::kLeft, frame);
    default:
      return Rejection::kUnknownIdentifier;
  }
}

Rejection FrameExchange::accept_leg_inertial(Side side, const CanFrame& frame) noexcept {
  FrameStamp stamp;
  LegInertialSensors heard = snapshot_.leg_inertial[index(side)];
  Rejection rejection = decode_leg_inertial(frame, stamp, heard);
  if (rejection == Rejection::kNone) rejection = judge_inertial(leg_node(side), stamp);
  if (rejection == Rejection::kNone) snapshot_.leg_inertial[index(side)] = heard;
  return rejection;
}

Rejection FrameExchange::accept_foot_inertial(Side side, const CanFrame& frame) noexcept {
  FrameStamp stamp;
  FootInertialSensors heard = snapshot_.foot_inertial[index(side)];
  Rejection rejection = decode_foot_inertial(frame, stamp, heard);
  if (rejection == Rejection::kNone) rejection = judge_inertial(foot_node(side), stamp);
  if (rejection == Rejection::kNone) snapshot_.foot_inertial[index(side)] = heard;
  return rejection;
}

Rejection FrameExchange::accept_heartbeat(Node node, const CanFrame& frame) noexcept {
  FrameStamp stamp;
  Heartbeat heartbeat;
  Rejection rejection = decode_heartbeat(frame, stamp, heartbeat);
  if (rejection != Rejection::kNone) return rejection;
  const bool starts_anew = heartbeat.state == NodeState::kBootUp && roster_.status(node).state != NodeState::kBootUp;
  if (starts_anew) heartbeat_watch_[slot(node)].restart();
  rejection = judge_counter(heartbeat_watch_[slot(node)], stamp);
  if (rejection != Rejection::kNone) return rejection;
  if (roster_.on_heartbeat(node, heartbeat, tick_)) {
    state_.watch[slot(node)].restart();
    inertial_.watch[slot(node)].restart();
    emergency_watch_[slot(node)].restart();
    inertial_.is_expected[slot(node)] = false;
  }
  if (heartbeat.has_inertial_sensors && node != Node::kTorsoImu) expect_inertial(node);
  return roster_.status(node).is_foreign() ? Rejection::kForeignVersion : Rejection::kNone;
}

/// The silence of sensors that never speak begins with their announcement.
void FrameExchange::expect_inertial(Node node) noexcept {
  inertial_.is_expected[slot(node)] = true;
  for (const Side side : kSides) {
    Freshness* freshness = nullptr;
    if (node == leg_node(side)) freshness = &snapshot_.leg_inertial[index(side)].freshness;
    if (node == foot_node(side)) freshness = &snapshot_.foot_inertial[index(side)].freshness;
    if (freshness != nullptr && !freshness->was_heard()) freshness->age_ticks = 0;
  }
}

Rejection FrameExchange::accept_emergency(Node node, const CanFrame& frame) noexcept {
  FrameStamp stamp;
  Emergency emergency;
  Rejection rejection = decode_emergency(frame, stamp, emergency);
  if (rejection == Rejection::kNone) rejection = judge_counter(emergency_watch_[slot(node)], stamp);
  if (rejection == Rejection::kNone) roster_.on_emergency(node, emergency);
  return rejection;
}

Rejection FrameExchange::judge_inertial(Node node, FrameStamp stamp) noexcept {
  const Rejection rejection = judge_answer(node, stamp, inertial_);
  if (rejection == Rejection::kNone) inertial_.is_expected[slot(node)] = true;
  return rejection;
}

Rejection FrameExchange::judge_answer(Node node, FrameStamp stamp, Answers& answers) noexcept {
  if (roster_.status(node).is_foreign()) return Rejection::kForeignVersion;
  if (!is_running_ || stamp.tick != (tick_ & 0xFFFFU)) return Rejection::kLate;
  bool& has_come = answers.has_come[slot(node)];
  if (has_come) return Rejection::kRepeated;  // the first answer counts; a second is somebody else's
  const Rejection rejection = judge_counter(answers.watch[slot(node)], stamp);
  if (rejection == Rejection::kNone) has_come = true;
  return rejection;
}

bool FrameExchange::Answers::are_complete() const noexcept {
  for (std::size_t node = 0; node < has_come.size(); ++node) {
    if (is_expected[node] && !has_come[node]) return false;
  }
  return true;
}

Rejection FrameExchange::judge_counter(CounterWatch& watch, FrameStamp stamp) noexcept {
  const std::uint32_t lost_before = watch.lost();
  const Rejection rejection = watch.step(stamp.counter);
  counters_.lost += watch.lost() - lost_before;
  return rejection;
}

}  // namespace surefoot::can
