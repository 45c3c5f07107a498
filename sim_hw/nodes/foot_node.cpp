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
      heartbeat_(can::foot_node(side)) {}

void FootNode::on_sync(std::uint32_t tick, const std::array<double, geometry::kCornersPerFoot>& corner_force_n,
                       FrameOutbox& outbox) noexcept {
  FootSensors measured;
  for (std::size_t i = 0; i < geometry::kCornersPerFoot; ++i) {
    measured.corner_force_n[i] =
        quantise(corner_force_n[i] + noise_.sample(sensor_.force_noise_n), sensor_.force_resolution_n);
  }
  faults_.apply(FaultSignal::kForce, measured.corner_force_n);
  outbox.add(can::encode_foot_force(side_, {.tick = tick, .counter = counter_++}, measured));
  heartbeat_.on_sync(tick, outbox);
}

}  // namespace surefoot::sim_hw
