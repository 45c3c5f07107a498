#include "tools/run/lockstep_loop.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <thread>

#include "firmware/host/allocation_guard.hpp"
#include "tools/run/standing_pose.hpp"
#include "tools/run/telemetry_messages.hpp"

namespace surefoot::run {
namespace {

using WallClock = LockstepLoop::WallClock;

constexpr std::uint32_t kBusStatisticsTicks = 100;
constexpr std::uint32_t kTimingStatisticsTicks = 1000;

double seconds_since(WallClock::time_point start) {
  return std::chrono::duration<double>(WallClock::now() - start).count();
}

std::int64_t elapsed_ns(WallClock::time_point start, WallClock::time_point end) {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(end - start).count();
}

}  // namespace

LockstepLoop::LockstepLoop(const scenario::Scenario& scenario, host::RunRecorder* recorder, bool is_live)
    : schedule_(schedule_of(scenario)),
      recorder_(recorder),
      is_live_(is_live),
      period_s_(scenario.firmware.period_s),
      time_zero_s_(scenario.sim.time_zero_s),
      telemetry_every_(scenario.telemetry.every_ticks),
      stabilizer_(scenario.firmware),
      watch_(scenario, recorder),
      bus_(&watch_),
      firmware_(scenario.firmware),
      robot_(std::make_unique<sim_hw::SimulatedRobot>(scenario.sim, standing_pose(scenario.firmware))),
      judge_(scenario) {}

LockstepLoop::LockstepLoop(const LockstepLoop& past, const scenario::Scenario& scenario)
    : schedule_(schedule_of(scenario)),
      recorder_(nullptr),
      is_live_(false),
      period_s_(past.period_s_),
      time_zero_s_(past.time_zero_s_),
      telemetry_every_(past.telemetry_every_),
      stabilizer_(past.stabilizer_),
      watch_(past.watch_),
      bus_(past.bus_, &watch_),
      firmware_(past.firmware_),
      robot_(past.robot_->branch(scenario.sim)),
      events_(past.events_),
      judge_(past.judge_),
      tick_times_(past.tick_times_),
      tick_(past.tick_),
      allocations_(past.allocations_),
      wall_s_(past.wall_s_),
      phase_(past.phase_) {
  judge_.go_on_with(scenario);
}

void LockstepLoop::run_to(std::int64_t end, const RunOptions& options) {
  const WallClock::time_point start = WallClock::now();
  for (; tick_ < end && !judge_.is_over(); ++tick_) {
    if (recorder_ != nullptr && !prepare_recorder()) break;
    if (options.stop != nullptr && options.stop->load(std::memory_order_relaxed)) {
      was_interrupted_ = true;
      break;
    }
    host::allocation_guard::arm();
    cycle();
    allocations_ += host::allocation_guard::disarm().allocations;
    if (options.pace > 0.0) keep_pace(start, options.pace);
    if (options.on_progress && tick_ % 64 == 0) report_progress(start, options);
  }
  wall_s_ += seconds_since(start);
}

Verdict LockstepLoop::finish() {
  Verdict verdict = judge_.verdict(was_interrupted_);
  verdict.allocations_in_loop = allocations_;
  verdict.allocations_were_counted = host::allocation_guard::is_available();
  verdict.tick_us_mean = tick_times_.mean_us();
  verdict.tick_us_p50 = tick_times_.p50_us();
  verdict.tick_us_p999 = tick_times_.p999_us();
  verdict.tick_us_max = tick_times_.max_us();
  verdict.tick_bins = tick_times_.bins();
  verdict.real_time_factor = static_cast<double>(tick_) * period_s_ / wall_s_;
  verdict.frames_sent = watch_.frames();
  verdict.frames_lost = frames_lost();
  constexpr auto kLate = static_cast<std::size_t>(can::Rejection::kLate);
  verdict.frames_late = firmware_.counters().rejected[kLate] + robot_->counters().rejected[kLate];
  verdict.bus = watch_.finish(tick_);
  verdict.bus_load_percent = watch_.load_percent(tick_);
  return verdict;
}

/// Every frame that was sent and did not count, whatever the reason, on either side.
std::uint64_t LockstepLoop::frames_lost() const noexcept {
  const can::FrameCounters& firmware = firmware_.counters();
  const sim_hw::NodeCounters robot = robot_->counters();
  std::uint64_t lost = firmware.lost + firmware.refused_by_bus + robot.lost + robot.refused_by_bus;
  for (const std::uint64_t count : firmware.rejected) lost += count;
  for (const std::uint64_t count : robot.rejected) lost += count;
  return lost;
}

void LockstepLoop::cycle() noexcept {
  const WallClock::time_point begin = WallClock::now();
  firmware_.begin_tick(bus_.controller_end());
  const WallClock::time_point sync_sent = WallClock::now();
  robot_->serve(bus_.robot_end());
  const WallClock::time_point answered = WallClock::now();
  static_cast<void>(firmware_.collect(bus_.controller_end()));
  const TickOutput& output = firmware_.finish_tick(bus_.controller_end());
  tick_times_.add(elapsed_ns(begin, sync_sent) + elapsed_ns(answered, WallClock::now()));
  robot_->serve(bus_.robot_end());
  const std::span<const RunEvent> events = events_.observe(output, robot_->truth());
  judge_.observe(output, robot_->truth(), events);
  phase_ = output.decision.phase;
  if (recorder_ != nullptr) record(output, events);
}

bool LockstepLoop::prepare_recorder() {
  if (recorder_->error() != nullptr) return false;
  recorder_->wait_for_room();
  recorder_->set_elapsed(std::llround(static_cast<double>(tick_) * period_s_ * 1e6));
  return true;
}

void LockstepLoop::keep_pace(WallClock::time_point start, double pace) const {
  const double due_s = static_cast<double>(tick_ + 1) * period_s_ / pace;
  std::this_thread::sleep_until(start +
                                std::chrono::duration_cast<WallClock::duration>(std::chrono::duration<double>(due_s)));
}

void LockstepLoop::report_progress(WallClock::time_point start, const RunOptions& options) {
  const double wall_s = seconds_since(start);
  if (wall_s - last_report_s_ < 0.25) return;
  last_report_s_ = wall_s;
  const double done_s = static_cast<double>(tick_ + 1) * period_s_;
  const double factor = done_s / wall_s;
  Progress progress;
  progress.time_s = done_s - time_zero_s_;
  progress.end_s = static_cast<double>(schedule_.ticks) * period_s_ - time_zero_s_;
  progress.pitch_deg = robot_->truth().pitch_rad * 180.0 / std::numbers::pi;
  progress.real_time_factor = factor;
  progress.remaining_wall_s = (static_cast<double>(schedule_.ticks) * period_s_ - done_s) / factor;
  progress.phase = decision::name(phase_);
  options.on_progress(progress);
}

void LockstepLoop::record(const TickOutput& output, std::span<const RunEvent> events) noexcept {
  const std::int64_t utime_us = std::llround((output.tick * period_s_ - time_zero_s_) * 1e6);
  for (const RunEvent& event : events) {
    recorder_->push(host::Channel::kEvent, utime_us,
                    event_message(utime_us, output.tick, event.code, event.name, event.value));
  }
  if (output.tick % telemetry_every_ == 0) {
    recorder_->push(host::Channel::kControllerState, utime_us, state_message(utime_us, output, firmware_.snapshot()));
    stabilizer_.push(*recorder_, utime_us, output);
    recorder_->push(host::Channel::kSimulatorTruth, utime_us, truth_message(utime_us, output.tick, robot_->truth()));
  }
  if (output.tick % kBusStatisticsTicks == kBusStatisticsTicks - 1 || judge_.is_over()) {
    recorder_->push(host::Channel::kBusStatistics, utime_us,
                    bus_message(utime_us, output.tick, firmware_.counters(), watch_.load_percent(output.tick + 1)));
  }
  if (is_live_ && output.tick % kTimingStatisticsTicks == kTimingStatisticsTicks - 1) {
    recorder_->push(host::Channel::kTimingStatistics, utime_us, timing_message(utime_us, output.tick, tick_times_));
  }
}

}  // namespace surefoot::run
