#pragma once

#include <array>
#include <cstdint>

#include "firmware/can/counter_watch.hpp"
#include "firmware/can/messages.hpp"
#include "sim_hw/faults/sensor_faults.hpp"
#include "sim_hw/nodes/command_queue.hpp"
#include "sim_hw/nodes/frame_outbox.hpp"
#include "sim_hw/nodes/heartbeat_sender.hpp"
#include "sim_hw/nodes/inertial_motion.hpp"
#include "sim_hw/nodes/noise_source.hpp"
#include "sim_hw/nodes/position_servo.hpp"
#include "sim_hw/plant_config.hpp"

namespace surefoot::sim_hw {

/// Torque at each joint for each rad/s while a board damps its leg. With the rotor inertia of the
/// joints and steps up to 1 ms it is far from oscillating.
inline constexpr double kDampingNmSPerRad = 100.0;

/// One leg's motor board: six encoders, six torque motors, a watchdog; on some robots a gyro behind the hip.
///
/// A command of tick k, torques or angles, takes effect `command_latency_s` after the tick began, counted in
/// physics steps, or at once if it comes later than that, and is held until the next; angles by `PositionServo`. Before
/// the first frame, in mode `kDamp`, and after `watchdog_s` without a valid frame the board damps its joints. Expiry
/// raises emergency 0x8130; the next valid frame ends it with 0x0000.
///
/// Two different valid frames for one tick come from two masters, and the board cannot know which is the right
/// one: it drops what it has queued, raises emergency 0x8150, ignores commands and damps until that master is
/// gone and another SYNC has come. The same frame once more is harmless. Torques and
/// angles for one tick are two different frames.
class LegBoard {
 public:
  LegBoard(Side, const SimConfig&);

  /// Answers SYNC with the joints as they are; from now on commands must carry this tick.
  void on_sync(std::uint32_t tick, const LegVector& angle_rad, const LegVector& rate_rad_s, const LegInertialMotion&,
               FrameOutbox&) noexcept;

  /// Judges a command frame: identifier, length, CRC, ranges, tick, counter, and one command a tick. Anything
  /// but `kNone` leaves the board as it was, except a second, different command for the tick.
  [[nodiscard]] can::Rejection on_command(const can::CanFrame&, FrameOutbox&) noexcept;

  /// Whether this tick's command has come (and was accepted, unless the board heard two masters).
  [[nodiscard]] bool has_command() const noexcept { return has_command_; }

  /// Command frames that never came, by the gaps in their counters.
  [[nodiscard]] std::uint32_t lost() const noexcept { return torque_watch_.lost() + position_watch_.lost(); }

  /// Motor torques for the physics step that begins now. Call once a step.
  [[nodiscard]] const LegVector& begin_step(const LegVector& angle_rad, const LegVector& rate_rad_s,
                                            FrameOutbox&) noexcept;

  /// Motor torques of the last step, within the motors' limit.
  [[nodiscard]] const LegVector& torque_nm() const noexcept { return torque_nm_; }

  /// While no master runs.
  void announce(FrameOutbox& outbox) noexcept { heartbeat_.announce(outbox); }

  /// The master is gone: no command counts until the next SYNC.
  void release_master() noexcept {
    was_synchronised_ = false;
    has_heard_two_masters_ = false;
    torque_watch_.restart();
    position_watch_.restart();
  }

  /// Power came back: everything from the beginning but the world, and the noise of its sensors.
  void restart(FrameOutbox&) noexcept;

  [[nodiscard]] SensorFaults& faults() noexcept { return faults_; }

 private:
  void send_inertial(const LegInertialMotion&, FrameOutbox&) noexcept;
  void stop_obeying(FrameOutbox&) noexcept;
  void send_emergency(std::uint16_t code, FrameOutbox&) noexcept;
  void apply(const LegVector& wanted_nm) noexcept;

  Side side_;
  SensorConfig sensor_;
  double torque_limit_nm_;
  std::uint64_t latency_steps_;
  std::uint64_t watchdog_steps_;
  NoiseSource noise_;
  SensorFaults faults_;
  HeartbeatSender heartbeat_;
  can::CounterWatch torque_watch_;
  can::CounterWatch position_watch_;
  CommandQueue queue_;
  PositionServo servo_;
  LegCommand active_{};
  can::CanFrame last_command_{};  ///< the one accepted in this tick
  LegVector torque_nm_{};
  can::LegStatus status_{.watchdog_expired = false, .torque_limited = false, .is_damping = true};
  std::uint64_t step_ = 0;
  std::uint64_t sync_step_ = 0;  ///< step at which the running tick began
  std::uint64_t silent_steps_ = 0;
  std::uint32_t tick_ = 0;
  bool was_synchronised_ = false;
  bool has_command_ = false;
  bool was_commanded_ = false;
  bool has_heard_two_masters_ = false;
  std::uint8_t state_counter_ = 0;
  std::uint8_t inertial_counter_ = 0;
  std::uint8_t emergency_counter_ = 0;
};

}  // namespace surefoot::sim_hw
