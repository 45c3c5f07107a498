#include "sim_hw/nodes/imu_node.hpp"

#include <utility>

#include "firmware/can/messages.hpp"

namespace surefoot::sim_hw {

ImuNode::ImuNode(const SensorConfig& sensor, std::uint64_t seed, SensorFaults faults) noexcept
    : sensor_(sensor),
      noise_(seed, static_cast<std::uint64_t>(can::Node::kTorsoImu)),
      faults_(std::move(faults)),
      heartbeat_(can::Node::kTorsoImu) {}

void ImuNode::on_sync(std::uint32_t tick, const TorsoMotion& motion, FrameOutbox& outbox) noexcept {
  ImuSensors measured;
  for (int axis = 0; axis < 3; ++axis) {
    measured.angular_rate_body_rad_s[axis] =
        motion.angular_rate_body_rad_s[axis] + noise_.sample(sensor_.gyro_noise_rad_s);
    measured.specific_force_body_m_s2[axis] =
        motion.specific_force_body_m_s2[axis] + noise_.sample(sensor_.accelerometer_noise_m_s2);
  }
  faults_.apply(FaultSignal::kGyro, {measured.angular_rate_body_rad_s.data(), 3});
  faults_.apply(FaultSignal::kAccelerometer, {measured.specific_force_body_m_s2.data(), 3});
  outbox.add(can::encode_imu({.tick = tick, .counter = counter_++}, measured));
  heartbeat_.on_sync(tick, outbox);
}

}  // namespace surefoot::sim_hw
