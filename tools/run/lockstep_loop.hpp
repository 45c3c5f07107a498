#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <span>

#include "firmware/host/firmware_node.hpp"
#include "firmware/host/memory_bus.hpp"
#include "firmware/host/run_recorder.hpp"
#include "firmware/host/tick_histogram.hpp"
#include "sim_hw/simulated_robot.hpp"
#include "tools/run/bus_watch.hpp"
#include "tools/run/event_watch.hpp"
#include "tools/run/judge.hpp"
#include "tools/run/lockstep_run.hpp"
#include "tools/run/schedule.hpp"
#include "tools/run/stabilizer_message.hpp"

namespace surefoot::run {

/// One run in lockstep on a memory bus, from power-up to verdict: owns every part of it.
class LockstepLoop {
 public:
  using WallClock = std::chrono::steady_clock;

  /// @param scenario  with its time zero set (`scheduled`)
  /// @param recorder  may be null; outlives the loop
  LockstepLoop(const scenario::Scenario& scenario, host::RunRecorder* recorder, bool is_live);

  /// Goes on where an unrecorded loop stands, towards another scenario of the same past (`shared_past.hpp`). What it
  /// comes to is, to the last bit, what a loop of that scenario from power-up on comes to.
  LockstepLoop(const LockstepLoop& past, const scenario::Scenario& scenario);

  LockstepLoop(const LockstepLoop&) = delete;
  LockstepLoop& operator=(const LockstepLoop&) = delete;
  ~LockstepLoop() = default;

  /// Runs until tick `end` has come, the judge has seen enough, or options tell it to stop.
  void run_to(std::int64_t end, const RunOptions& options);

  /// Ends the run. Call once.
  [[nodiscard]] Verdict finish();

  /// The tick that comes next.
  [[nodiscard]] std::int64_t tick() const noexcept { return tick_; }

 private:
  void cycle() noexcept;
  [[nodiscard]] bool prepare_recorder();
  void record(const TickOutput& output, std::span<const RunEvent> events) noexcept;
  void keep_pace(WallClock::time_point start, double pace) const;
  void report_progress(WallClock::time_point start, const RunOptions& options);
  [[nodiscard]] std::uint64_t frames_lost() const noexcept;

  Schedule schedule_;
  host::RunRecorder* recorder_;
  bool is_live_;
  double period_s_;
  double time_zero_s_;
  std::uint32_t telemetry_every_;
  StabilizerTelemetry stabilizer_;
  BusWatch watch_;
  host::MemoryBus bus_;
  host::FirmwareNode firmware_;
  std::unique_ptr<sim_hw::SimulatedRobot> robot_;
  EventWatch events_{};
  Judge judge_;
  host::TickHistogram tick_times_{};
  std::int64_t tick_ = 0;
  std::uint64_t allocations_ = 0;
  double wall_s_ = 0.0;
  double last_report_s_ = 0.0;
  bool was_interrupted_ = false;
  decision::ReflexPhase phase_ = decision::ReflexPhase::kStanding;
};

}  // namespace surefoot::run
