#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "firmware/can/messages.hpp"
#include "sim_hw/simulated_robot.hpp"

namespace surefoot::sim_hw::testing {

/// The robot's end of a wire whose other end is the test.
class Wire final : public can::CanBus {
 public:
  Wire() {
    to_robot.reserve(256);
    from_robot.reserve(256);
  }

  std::size_t send(std::span<const can::CanFrame> frames) noexcept override {
    from_robot.insert(from_robot.end(), frames.begin(), frames.end());
    return frames.size();
  }

  std::size_t receive(std::span<can::CanFrame> frames) noexcept override {
    const std::size_t count = std::min(frames.size(), to_robot.size());
    std::copy_n(to_robot.begin(), count, frames.begin());
    to_robot.erase(to_robot.begin(), to_robot.begin() + static_cast<std::ptrdiff_t>(count));
    return count;
  }

  std::vector<can::CanFrame> to_robot;
  std::vector<can::CanFrame> from_robot;
};

/// A controller of a few lines: SYNC, read the legs, send torques.
class Puppeteer {
 public:
  explicit Puppeteer(SimulatedRobot& robot) : robot_(robot) {}

  /// Sends SYNC of the next tick and takes the answers.
  void sync() {
    ++tick;
    wire.from_robot.clear();
    wire.to_robot.push_back(can::encode_sync({.tick = tick, .counter = sync_counter_++}));
    if (!was_announced_) wire.to_robot.push_back(heartbeat_frame(can::NodeState::kOperational));
    was_announced_ = true;
    robot_.serve(wire);
    read_answers();
  }

  [[nodiscard]] can::CanFrame heartbeat_frame(can::NodeState state) {
    return can::encode_heartbeat(can::Node::kController, {.tick = tick, .counter = heartbeat_counter_++},
                                 {.state = state});
  }

  [[nodiscard]] can::CanFrame command_frame(Side side, const LegCommand& command) {
    return can::encode_leg_command(side, {.tick = tick, .counter = command_counter_[index(side)]++}, command);
  }

  void command(const PerSide<LegVector>& torque_nm, LegMode mode = LegMode::kTorque) {
    for (const Side side : kSides) wire.to_robot.push_back(command_frame(side, {mode, torque_nm[index(side)]}));
    robot_.serve(wire);
    read_answers();
  }

  void aim(const PerSide<LegVector>& angle_rad) {
    for (const Side side : kSides) {
      wire.to_robot.push_back(command_frame(side, {.mode = LegMode::kPosition, .angle_rad = angle_rad[index(side)]}));
    }
    robot_.serve(wire);
    read_answers();
  }

  void read_answers() {
    for (const can::CanFrame& frame : wire.from_robot) {
      can::FrameStamp stamp;
      can::Emergency emergency;
      for (const Side side : kSides) {
        const can::Node leg_node = can::leg_node(side);
        if (frame.identifier == can::state_identifier(leg_node)) {
          (void)can::decode_leg_state(frame, stamp, leg[index(side)], status[index(side)]);
        } else if (frame.identifier == can::state_identifier(can::foot_node(side))) {
          (void)can::decode_foot_force(frame, stamp, foot[index(side)]);
        } else if (frame.identifier == can::inertial_identifier(leg_node)) {
          (void)can::decode_leg_inertial(frame, stamp, leg_inertial[index(side)]);
        } else if (frame.identifier == can::inertial_identifier(can::foot_node(side))) {
          (void)can::decode_foot_inertial(frame, stamp, foot_inertial[index(side)]);
        } else if (frame.identifier == can::emergency_identifier(leg_node) &&
                   can::decode_emergency(frame, stamp, emergency) == can::Rejection::kNone) {
          last_emergency[index(side)] = emergency.code;
          ++emergencies[index(side)];
        }
      }
      if (frame.identifier == can::state_identifier(can::Node::kTorsoImu)) (void)can::decode_imu(frame, stamp, imu);
    }
    wire.from_robot.clear();
  }

  Wire wire;
  std::uint32_t tick = 0;
  PerSide<LegSensors> leg{};
  PerSide<can::LegStatus> status{};
  PerSide<FootSensors> foot{};
  ImuSensors imu{};
  PerSide<LegInertialSensors> leg_inertial{};
  PerSide<FootInertialSensors> foot_inertial{};
  PerSide<std::uint16_t> last_emergency{};
  PerSide<int> emergencies{};

 private:
  SimulatedRobot& robot_;
  bool was_announced_ = false;
  std::uint8_t sync_counter_ = 0;
  std::uint8_t heartbeat_counter_ = 0;
  PerSide<std::uint8_t> command_counter_{};
};

}  // namespace surefoot::sim_hw::testing
