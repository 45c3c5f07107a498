#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "firmware/can/can_bus.hpp"
#include "firmware/can/messages.hpp"
#include "sim_hw/faults/bus_line.hpp"
#include "sim_hw/ground_truth.hpp"
#include "sim_hw/plant_config.hpp"

namespace surefoot::sim_hw {

/// Running totals of the robot's side of the bus.
struct NodeCounters {
  std::uint64_t sent = 0;
  std::uint64_t refused_by_bus = 0;                             ///< the bus did not take them
  std::uint64_t received = 0;                                   ///< accepted
  std::array<std::uint64_t, can::kRejectionCauses> rejected{};  ///< by `can::Rejection`
  std::uint64_t lost = 0;  ///< gaps in the rolling counters of SYNC and command frames
  FaultCounters faults;    ///< what the scenario's faults did to frames
};

/// What moves the simulated world on.
enum class WorldClock : std::uint8_t {
  kLockstep,     ///< the master: one control period for each of its ticks, at any speed
  kFreeRunning,  ///< `advance_to`: the world goes on beside the master, whether that sends or not
};

/// The simulated robot as the firmware meets it: five nodes on a CAN bus.
/// Fresh world for each object, no global state; many may live in one process, on many threads.
///
/// The scenario's faults happen between the nodes and the bus given to the calls below, and in the nodes'
/// sensors; in free running from the first master on.
class SimulatedRobot {
 public:
  /// @param initial_angle_rad  joint angles at the start; the soles stand on the floor
  /// @throws std::invalid_argument with the remedy when the configuration is impossible
  SimulatedRobot(const SimConfig& config, const PerSide<LegVector>& initial_angle_rad,
                 WorldClock clock = WorldClock::kLockstep);
  ~SimulatedRobot();
  SimulatedRobot(const SimulatedRobot&) = delete;
  SimulatedRobot& operator=(const SimulatedRobot&) = delete;

  /// Whether a robot of this configuration can be branched: no faults, contact model `kSpringDamper`.
  [[nodiscard]] static bool can_branch(const SimConfig&) noexcept;

  /// Another robot whose past is this one's and whose payloads and pushes are those of `config`; it goes on as one
  /// that had `config` from the start would, to the last bit. To be called between two periods.
  ///
  /// @param config  that of this robot but for payloads and pushes; in neither has one begun by now
  [[nodiscard]] std::unique_ptr<SimulatedRobot> branch(const SimConfig& config) const;

  /// Serves the bus once: takes the waiting frames, at most until a period has been simulated; answers SYNC with the
  /// latched state of each node; takes commands. Does not allocate (with the contact model `kSpringDamper`).
  ///
  /// In lockstep it advances the world by one control period when both command frames of the tick have
  /// arrived. A tick whose command frames or SYNC were lost is made up for at the next SYNC, so that the
  /// world keeps the controller's count.
  void serve(can::CanBus& bus) noexcept;

  /// Free running: simulates until `world_time_s` after the start, in whole physics steps. The scenario's
  /// clock starts with the master's first tick; a master silent for the boards' watchdog time is released.
  void advance_to(double world_time_s, can::CanBus& bus) noexcept;

  /// While no master runs: every node sends a heartbeat, and a robot in lockstep says that it is one. To be
  /// called ten times a second, by a real clock.
  void announce(can::CanBus& bus) noexcept;

  /// Lockstep: the master has fallen silent. The next one may begin at any tick; until then nothing moves.
  void release_master() noexcept;

  /// While true, only a master that powers up is met, at its tick 0. One in the middle of its run is left alone: what
  /// it still sends to a robot that is being switched on was meant for an earlier one.
  void expect_power_up(bool is_expected) noexcept;

  /// Whether somebody drives this robot.
  [[nodiscard]] bool has_master() const noexcept;

  /// Whether all answers of the five nodes to the last SYNC went out to the bus, in its tick and unspoilt. False
  /// as well while a fault keeps SYNC from the robot.
  [[nodiscard]] bool has_answered_fully() const noexcept;

  /// Lockstep: tells the master that no more answers to its last SYNC will come. Past the faults of the scenario,
  /// for this frame is none of the robot's.
  void tell_served(can::CanBus& bus) noexcept;

  /// Tick of the last SYNC that came to the robot's end of the bus, also when a fault kept it from the nodes.
  [[nodiscard]] std::uint32_t wire_tick() const noexcept;

  /// Tick of the last SYNC that the nodes heard.
  [[nodiscard]] std::uint32_t tick() const noexcept;

  /// Tick at which the nodes met their master.
  [[nodiscard]] std::uint32_t first_tick() const noexcept;

  /// Control periods simulated since the start; `truth` is of the end of the last one.
  [[nodiscard]] std::int64_t periods() const noexcept;

  /// The master's tick in which that period began; lockstep and free running alike.
  [[nodiscard]] std::uint32_t truth_tick() const noexcept;

  /// State at the end of the last period.
  [[nodiscard]] const GroundTruth& truth() const noexcept;

  [[nodiscard]] NodeCounters counters() const noexcept;

 private:
  struct Parts;
  explicit SimulatedRobot(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace surefoot::sim_hw
