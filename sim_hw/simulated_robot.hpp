#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "firmware/can/can_bus.hpp"
#include "sim_hw/ground_truth.hpp"
#include "sim_hw/plant_config.hpp"

namespace surefoot::sim_hw {

/// Running totals of the robot's side of the bus.
struct NodeCounters {
  std::uint64_t sent = 0;
  std::uint64_t refused_by_bus = 0;         ///< the bus did not take them
  std::uint64_t received = 0;               ///< accepted
  std::array<std::uint64_t, 7> rejected{};  ///< by `can::Rejection`
  std::uint64_t lost = 0;                   ///< gaps in the rolling counters of SYNC and torque frames
};

/// The simulated robot as the firmware meets it: five nodes on a CAN bus.
/// Fresh world for each object, no global state; many may live in one process, on many threads.
class SimulatedRobot {
 public:
  /// @param initial_angle_rad  joint angles at the start; the soles stand on the floor
  /// @throws std::invalid_argument with the remedy when the configuration is impossible
  SimulatedRobot(const SimConfig& config, const PerSide<LegVector>& initial_angle_rad);
  ~SimulatedRobot();
  SimulatedRobot(const SimulatedRobot&) = delete;
  SimulatedRobot& operator=(const SimulatedRobot&) = delete;

  /// Serves the bus once: takes all waiting frames; answers SYNC with the latched state of each
  /// node; takes torques; advances the world by one control period when both torque frames of the
  /// tick have arrived. A tick whose torque frames or SYNC were lost is made up for at the next
  /// SYNC, so that the world keeps the controller's count. Does not allocate (with the contact
  /// model `kSpringDamper`).
  void serve(can::CanBus& bus) noexcept;

  /// State at the end of the last period.
  [[nodiscard]] const GroundTruth& truth() const noexcept;

  [[nodiscard]] NodeCounters counters() const noexcept;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace surefoot::sim_hw
