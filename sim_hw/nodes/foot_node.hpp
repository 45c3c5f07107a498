#pragma once

#include <array>
#include <cstdint>

#include "firmware/core/geometry/robot_geometry.hpp"
#include "sim_hw/faults/sensor_faults.hpp"
#include "sim_hw/nodes/frame_outbox.hpp"
#include "sim_hw/nodes/heartbeat_sender.hpp"
#include "sim_hw/nodes/inertial_motion.hpp"
#include "sim_hw/nodes/noise_source.hpp"
#include "sim_hw/plant_config.hpp"

namespace surefoot::sim_hw {

/// Four load cells under the corners of one sole; each reports its mean over the last period. On some robots an
/// inclinometer and an accelerometer beside them.
class FootNode {
 public:
  FootNode(Side, const SensorConfig&, std::uint64_t seed, SensorFaults faults = {}) noexcept;

  /// Answers SYNC.
  void on_sync(std::uint32_t tick, const std::array<double, geometry::kCornersPerFoot>& corner_force_n,
               const LegInertialMotion&, FrameOutbox&) noexcept;

  /// While no master runs.
  void announce(FrameOutbox& outbox) noexcept { heartbeat_.announce(outbox); }

  /// Power came back.
  void restart(FrameOutbox& outbox) noexcept {
    counter_ = inertial_counter_ = 0;
    heartbeat_.restart(outbox);
  }

  [[nodiscard]] SensorFaults& faults() noexcept { return faults_; }

 private:
  void send_inertial(std::uint32_t tick, const LegInertialMotion&, FrameOutbox&) noexcept;

  Side side_;
  SensorConfig sensor_;
  NoiseSource noise_;
  SensorFaults faults_;
  HeartbeatSender heartbeat_;
  std::uint8_t counter_ = 0;
  std::uint8_t inertial_counter_ = 0;
};

}  // namespace surefoot::sim_hw
