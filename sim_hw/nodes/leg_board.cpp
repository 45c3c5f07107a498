#include "sim_hw/nodes/leg_board.hpp"

#include <algorithm>
#include <cmath>

#include "sim_hw/nodes/quantise.hpp"

namespace surefoot::sim_hw {
namespace {

constexpr std::uint16_t kEmergencyWatchdog = 0x8130;
constexpr std::uint16_t kEmergencyTwoMasters = 0x8150;  // CiA 301, collision of an identifier
constexpr std::uint16_t kEmergencyReset = 0x0000;
constexpr std::uint8_t kCommunicationError = 0x10;  // CiA 301, error register bit 4

std::uint64_t steps(double duration_s, double step_s) noexcept {
  return static_cast<std::uint64_t>(std::llround(duration_s / step_s));
}

}  // namespace

LegBoard::LegBoard(Side side, const SimConfig& config)
    : side_(side),
      sensor_(config.sensor),
      torque_limit_nm_(config.drive.torque_limit_nm),
      latency_steps_(steps(config.command_latency_s, config.physics_step_s)),
      watchdog_steps_(steps(config.watchdog_s, config.physics_step_s)),
      noise_(config.seed, static_cast<std::uint64_t>(can::leg_node(side))),
      faults_(config.faults, side == Side::kRight ? FaultTarget::kLegRight : FaultTarget::kLegLeft, config.seed,
              config.control_period_s),
      heartbeat_(can::leg_node(side), config.sensor.has_inertial_legs),
      servo_(config) {}

void LegBoard::on_sync(std::uint32_t tick, const LegVector& angle_rad, const LegVector& rate_rad_s,
                       const LegInertialMotion& motion, FrameOutbox& outbox) noexcept {
  tick_ = tick;
  was_synchronised_ = true;
  has_command_ = false;
  sync_step_ = step_;

  LegSensors measured;
  for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
    measured.angle_rad[joint] =
        quantise(angle_rad[joint] + noise_.sample(sensor_.encoder_noise_rad), sensor_.encoder_resolution_rad);
    measured.rate_rad_s[joint] = rate_rad_s[joint] + noise_.sample(sensor_.joint_rate_noise_rad_s);
  }
  measured.torque_nm = torque_nm_;
  faults_.apply(FaultSignal::kAngle, measured.angle_rad);
  faults_.apply(FaultSignal::kRate, measured.rate_rad_s);
  faults_.apply(FaultSignal::kTorque, measured.torque_nm);
  outbox.add(can::encode_leg_state(side_, {.tick = tick, .counter = state_counter_++}, measured, status_));
  if (sensor_.has_inertial_legs) send_inertial(motion, outbox);
  heartbeat_.on_sync(tick, outbox);
}

void LegBoard::send_inertial(const LegInertialMotion& motion, FrameOutbox& outbox) noexcept {
  LegInertialSensors measured;
  measured.hip_roll_rate_rad_s =
      clipped(motion.hip_roll_rate_rad_s + noise_.sample(sensor_.hip_gyro_noise_rad_s), sensor_.hip_gyro_range_rad_s);
  faults_.apply(FaultSignal::kHipGyro, {&measured.hip_roll_rate_rad_s, 1});
  outbox.add(can::encode_leg_inertial(side_, {.tick = tick_, .counter = inertial_counter_++}, measured));
}

can::Rejection LegBoard::on_command(const can::CanFrame& frame, FrameOutbox& outbox) noexcept {
  const can::Node node = can::leg_node(side_);
  const bool is_position = frame.identifier == can::position_identifier(node);
  if (!is_position && frame.identifier != can::command_identifier(node)) return can::Rejection::kUnknownIdentifier;
  can::FrameStamp stamp;
  LegCommand command;
  if (const auto rejection = can::decode_leg_command(frame, stamp, command); rejection != can::Rejection::kNone) {
    return rejection;
  }
  if (!was_synchronised_ || (stamp.tick & 0xFFFFU) != (tick_ & 0xFFFFU)) return can::Rejection::kLate;
  if (has_heard_two_masters_) {
    has_command_ = true;
    silent_steps_ = 0;
    return can::Rejection::kUnknownIdentifier;
  }
  if (has_command_) {
    if (!std::ranges::equal(frame.bytes(), last_command_.bytes())) stop_obeying(outbox);
    return can::Rejection::kRepeated;
  }
  can::CounterWatch& watch = is_position ? position_watch_ : torque_watch_;
  if (const auto rejection = watch.step(stamp.counter); rejection != can::Rejection::kNone) return rejection;

  has_command_ = true;
  was_commanded_ = true;
  silent_steps_ = 0;
  last_command_ = frame;
  queue_.push(sync_step_ + latency_steps_, command);
  if (status_.watchdog_expired) {
    status_.watchdog_expired = false;
    send_emergency(kEmergencyReset, outbox);
  }
  return can::Rejection::kNone;
}

const LegVector& LegBoard::begin_step(const LegVector& angle_rad, const LegVector& rate_rad_s,
                                      FrameOutbox& outbox) noexcept {
  if (was_commanded_ && !status_.watchdog_expired && silent_steps_ >= watchdog_steps_) {
    status_.watchdog_expired = true;
    queue_.clear();
    active_ = {};  // damp
    send_emergency(kEmergencyWatchdog, outbox);
  }
  const bool is_new = queue_.take_due(step_, active_);
  ++silent_steps_;
  ++step_;

  status_.is_damping = active_.mode == LegMode::kDamp;
  if (active_.mode == LegMode::kPosition) {
    if (is_new) servo_.aim(active_.angle_rad, angle_rad);
    apply(servo_.step(angle_rad, rate_rad_s));
    return torque_nm_;
  }
  servo_.stop();
  if (status_.is_damping) {
    LegVector damping;
    for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) damping[joint] = -kDampingNmSPerRad * rate_rad_s[joint];
    apply(damping);
  } else {
    apply(active_.torque_nm);
  }
  return torque_nm_;
}

void LegBoard::stop_obeying(FrameOutbox& outbox) noexcept {
  has_heard_two_masters_ = true;
  queue_.clear();
  active_ = {};  // damp
  send_emergency(kEmergencyTwoMasters, outbox);
}

void LegBoard::restart(FrameOutbox& outbox) noexcept {
  torque_watch_ = {};
  position_watch_ = {};
  queue_.clear();
  servo_.stop();
  active_ = {};
  torque_nm_ = {};
  status_ = {.watchdog_expired = false, .torque_limited = false, .is_damping = true};
  step_ = sync_step_ = 0;
  silent_steps_ = 0;
  tick_ = 0;
  was_synchronised_ = has_command_ = was_commanded_ = has_heard_two_masters_ = false;
  state_counter_ = inertial_counter_ = emergency_counter_ = 0;
  heartbeat_.restart(outbox);
}

void LegBoard::apply(const LegVector& wanted_nm) noexcept {
  status_.torque_limited = false;
  for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
    torque_nm_[joint] = std::clamp(wanted_nm[joint], -torque_limit_nm_, torque_limit_nm_);
    if (torque_nm_[joint] != wanted_nm[joint]) status_.torque_limited = true;
  }
}

void LegBoard::send_emergency(std::uint16_t code, FrameOutbox& outbox) noexcept {
  const can::FrameStamp stamp{.tick = tick_, .counter = emergency_counter_++};
  const std::uint8_t error_register = code == kEmergencyReset ? std::uint8_t{0} : kCommunicationError;
  outbox.add(can::encode_emergency(can::leg_node(side_), stamp, {.code = code, .error_register = error_register}));
}

}  // namespace surefoot::sim_hw
