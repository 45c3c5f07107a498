#include "sim_hw/nodes/foot_node.hpp"

#include <utility>

#include "firmware/can/messages.hpp"
#include "sim_hw/nodes/quantise.hpp"

namespace surefoot::sim_hw {

FootNode::FootNode(Side side, const SensorConfig& sensor, std::uint64_t seed, SensorFaults faults) noexcept
    : side_(side),
      sensor_(sensor),
      noise_(seed, static_cast<std::uint64_t>(can::foot_node(side))),
      faults_(std::move(faults)),
      heartbeat_(can::foot_node(side), sensor.has_inertial_legs) {}

void FootNode::on_sync(std::uint32_t tick, const std::array<double, geometry::kCornersPerFoot>& corner_force_n,
                       const LegInertialMotion& motion, FrameOutbox& outbox) noexcept {
  FootSensors measured;
  for (std::size_t i = 0; i < geometry::kCornersPerFoot; ++i) {
    measured.corner_force_n[i] =
        quantise(corner_force_n[i] + noise_.sample(sensor_.force_noise_n), sensor_.force_resolution_n);
  }
  faults_.apply(FaultSignal::kForce, measured.corner_force_n);
  outbox.add(can::encode_foot_force(side_, {.tick = tick, .counter = counter_++}, measured));
  if (sensor_.has_inertial_legs) send_inertial(tick, motion, outbox);
  heartbeat_.on_sync(tick, outbox);
}

void FootNode::send_inertial(std::uint32_t tick, const LegInertialMotion& motion, FrameOutbox& outbox) noexcept {
  std::array<double, 2> tilt_rad{motion.sole_roll_rad, motion.sole_pitch_rad};
  std::array<double, 2> force_m_s2{motion.specific_force_foot_m_s2.x(), motion.specific_force_foot_m_s2.y()};
  for (double& tilt : tilt_rad) {
    tilt = clipped(tilt + noise_.sample(sensor_.inclinometer_noise_rad), sensor_.inclinometer_range_rad);
  }
  for (double& force : force_m_s2) {
    force =
        clipped(force + noise_.sample(sensor_.foot_accelerometer_noise_m_s2), sensor_.foot_accelerometer_range_m_s2);
  }
  faults_.apply(FaultSignal::kInclinometer, tilt_rad);
  faults_.apply(FaultSignal::kFootAccelerometer, force_m_s2);
  FootInertialSensors measured;
  measured.roll_rad = tilt_rad[0];
  measured.pitch_rad = tilt_rad[1];
  measured.specific_force_x_foot_m_s2 = force_m_s2[0];
  measured.specific_force_y_foot_m_s2 = force_m_s2[1];
  outbox.add(can::encode_foot_inertial(side_, {.tick = tick, .counter = inertial_counter_++}, measured));
}

}  // namespace surefoot::sim_hw
