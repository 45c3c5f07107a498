#pragma once

#include <atomic>
#include <cstdint>

#include "firmware/host/bus/host_bus.hpp"
#include "firmware/host/firmware_node.hpp"
#include "firmware/host/realtime/loop_report.hpp"

namespace surefoot::host {

/// What moves the ticks on.
enum class LoopClock : std::uint8_t {
  kLockstep,  ///< the robot's answers: the next tick comes when all nodes have answered the last
  kWall,      ///< the absolute grid of CLOCK_MONOTONIC
};

struct FirmwareLoopConfig {
  LoopClock clock = LoopClock::kLockstep;
  std::int64_t period_ns = 1'000'000;
  std::int64_t ticks = 0;                 ///< length of the run; 0: until stopped
  bool ends_at_fault = false;             ///< otherwise the loop goes on in its safe state
  bool ends_when_robot_returns = false;   ///< after a fault: end once a node announces that it has started anew
  std::int64_t most_missed_at_once = 20;  ///< wall: beyond it the boards have damped, and the robot is not where it was
  double receive_window = 0.6;  ///< wall: share of the period for which answers are awaited after SYNC, 0 to 1
  std::int64_t silence_ns = 1'000'000'000;     ///< lockstep: a robot that answers nothing for so long is silent
  std::int64_t silent_period_ns = 10'000'000;  ///< lockstep: time between ticks while it is
  OverrunPolicy overruns{};
};

/// Hears of every tick, in the loop's thread: must not allocate, block or throw.
class TickObserver {
 public:
  virtual ~TickObserver() = default;

  /// Before SYNC goes out.
  /// @param elapsed_us  time since tick 0: of the tick's instant in lockstep, of now on the wall clock
  virtual void before_tick(std::int64_t elapsed_us) noexcept = 0;
  virtual void after_tick(const FirmwareNode& node, const TickOutput& output) noexcept = 0;
  /// Between two ticks, at least once for each of them.
  /// @param report  null, but for about once a second
  virtual void between_ticks(const LoopReport* report) noexcept = 0;
};

/// How the loop ended.
struct FirmwareLoopResult {
  LoopReport report;
  std::int64_t ticks = 0;            ///< ran or missed
  std::uint64_t refused_by_bus = 0;  ///< lockstep: frames; on the wall clock the node counts them
  std::uint64_t silent_ticks = 0;    ///< lockstep: not answered within the time
  safety::Fault fault = safety::Fault::kNone;
};

/// Runs the firmware on a bus from tick 0 on, until its end, a fault (if asked for) or `stop`.
///
/// Lockstep: torques(k) and SYNC(k+1) leave together, one exchange a tick. Wall: on each instant of the
/// grid SYNC goes out, answers are awaited for the receive window, the tick runs on what is there. A tick
/// whose instant was missed is not sent; the controller's time goes on, the boards hold their torques, and
/// too many of them ask for fault 7: a safe stop, or damping after a gap that the boards did not hold through.
[[nodiscard]] FirmwareLoopResult run_firmware_loop(FirmwareNode&, HostBus&, const FirmwareLoopConfig&, TickObserver&,
                                                   const std::atomic<bool>& stop) noexcept;

}  // namespace surefoot::host
