#pragma once

#include <cstdint>

#include "firmware/core/geometry/robot_geometry.hpp"
#include "sim_hw/faults/sensor_faults.hpp"
#include "sim_hw/nodes/frame_outbox.hpp"
#include "sim_hw/nodes/heartbeat_sender.hpp"
#include "sim_hw/nodes/noise_source.hpp"
#include "sim_hw/plant_config.hpp"

namespace surefoot::sim_hw {

/// What the torso IMU feels, body frame, at the body frame's origin.
struct TorsoMotion {
  geometry::Vector3 angular_rate_body_rad_s = geometry::Vector3::Zero();
  geometry::Vector3 specific_force_body_m_s2 = geometry::Vector3::Zero();  ///< mean over the last period
};

/// Gyroscope and accelerometer in the trunk.
class ImuNode {
 public:
  ImuNode(const SensorConfig&, std::uint64_t seed, SensorFaults faults = {}) noexcept;

  /// Answers SYNC.
  void on_sync(std::uint32_t tick, const TorsoMotion&, FrameOutbox&) noexcept;

  /// While no master runs.
  void announce(FrameOutbox& outbox) noexcept { heartbeat_.announce(outbox); }

  /// Power came back.
  void restart(FrameOutbox& outbox) noexcept {
    counter_ = 0;
    heartbeat_.restart(outbox);
  }

  [[nodiscard]] SensorFaults& faults() noexcept { return faults_; }

 private:
  SensorConfig sensor_;
  NoiseSource noise_;
  SensorFaults faults_;
  HeartbeatSender heartbeat_;
  std::uint8_t counter_ = 0;
};

}  // namespace surefoot::sim_hw
