#include "tools/run/lockstep_run.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <memory>
#include <numbers>
#include <span>
#include <thread>
#include <utility>

#include "firmware/host/allocation_guard.hpp"
#include "firmware/host/firmware_node.hpp"
#include "firmware/host/memory_bus.hpp"
#include "firmware/host/run_recorder.hpp"
#include "firmware/host/tick_histogram.hpp"
#include "sim_hw/simulated_robot.hpp"
#include "tools/run/bus_watch.hpp"
#include "tools/run/event_watch.hpp"
#include "tools/run/judge.hpp"
#include "tools/run/open_recorder.hpp"
#include "tools/run/run_folder.hpp"
#include "tools/run/schedule.hpp"
#include "tools/run/standing_pose.hpp"
#include "tools/run/telemetry_messages.hpp"

namespace surefoot::run {
namespace {

using WallClock = std::chrono::steady_clock;

constexpr std::uint32_t kBusStatisticsTicks = 100;
constexpr std::uint32_t kTimingStatisticsTicks = 1000;

double seconds_since(WallClock::time_point start) {
  return std::chrono::duration<double>(WallClock::now() - start).count();
}

std::int64_t elapsed_ns(WallClock::time_point start, WallClock::time_point end) {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(end - start).count();
}

/// One run from power-up to verdict: owns every part of it.
class LockstepRun {
 public:
  LockstepRun(const scenario::Scenario& scenario, const RunOptions& options, host::RunRecorder* recorder,
              Schedule schedule)
      : options_(options),
        schedule_(schedule),
        recorder_(recorder),
        period_s_(scenario.firmware.period_s),
        time_zero_s_(scenario.sim.time_zero_s),
        telemetry_every_(scenario.telemetry.every_ticks),
        watch_(scenario.sim, recorder),
        bus_(&watch_),
        firmware_(scenario.firmware),
        robot_(scenario.sim, standing_pose(scenario.firmware)),
        judge_(scenario) {}

  Verdict run() {
    const WallClock::time_point start = WallClock::now();
    std::uint64_t allocations = 0;
    bool was_interrupted = false;
    for (; tick_ < schedule_.ticks && !judge_.is_over(); ++tick_) {
      if (recorder_ != nullptr && !prepare_recorder()) break;
      if (options_.stop != nullptr && options_.stop->load(std::memory_order_relaxed)) {
        was_interrupted = true;
        break;
      }
      host::allocation_guard::arm();
      cycle();
      allocations += host::allocation_guard::disarm().allocations;
      if (options_.pace > 0.0) keep_pace(start);
      if (options_.on_progress && tick_ % 64 == 0) report_progress(start);
    }
    const double wall_s = seconds_since(start);

    Verdict verdict = judge_.verdict(was_interrupted);
    verdict.allocations_in_loop = allocations;
    verdict.allocations_were_counted = host::allocation_guard::is_available();
    verdict.tick_us_p50 = tick_times_.p50_us();
    verdict.tick_us_p999 = tick_times_.p999_us();
    verdict.tick_us_max = tick_times_.max_us();
    verdict.real_time_factor = static_cast<double>(tick_) * period_s_ / wall_s;
    verdict.frames_sent = watch_.frames();
    verdict.frames_lost = frames_lost();
    constexpr auto kLate = static_cast<std::size_t>(can::Rejection::kLate);
    verdict.frames_late = firmware_.counters().rejected[kLate] + robot_.counters().rejected[kLate];
    verdict.bus = watch_.finish(tick_);
    verdict.bus_load_percent = watch_.load_percent(tick_);
    return verdict;
  }

 private:
  /// Every frame that was sent and did not count, whatever the reason, on either side.
  [[nodiscard]] std::uint64_t frames_lost() const noexcept {
    const can::FrameCounters& firmware = firmware_.counters();
    const sim_hw::NodeCounters robot = robot_.counters();
    std::uint64_t lost = firmware.lost + firmware.refused_by_bus + robot.lost + robot.refused_by_bus;
    for (const std::uint64_t count : firmware.rejected) lost += count;
    for (const std::uint64_t count : robot.rejected) lost += count;
    return lost;
  }

  void cycle() noexcept {
    const WallClock::time_point begin = WallClock::now();
    firmware_.begin_tick(bus_.controller_end());
    const WallClock::time_point sync_sent = WallClock::now();
    robot_.serve(bus_.robot_end());
    const WallClock::time_point answered = WallClock::now();
    static_cast<void>(firmware_.collect(bus_.controller_end()));
    const TickOutput& output = firmware_.finish_tick(bus_.controller_end());
    tick_times_.add(elapsed_ns(begin, sync_sent) + elapsed_ns(answered, WallClock::now()));
    robot_.serve(bus_.robot_end());
    const std::span<const RunEvent> events = events_.observe(output, robot_.truth());
    judge_.observe(output, robot_.truth(), events);
    phase_ = output.decision.phase;
    if (recorder_ != nullptr) record(output, events);
  }

  [[nodiscard]] bool prepare_recorder() {
    if (recorder_->error() != nullptr) return false;
    recorder_->wait_for_room();
    recorder_->set_elapsed(std::llround(static_cast<double>(tick_) * period_s_ * 1e6));
    return true;
  }

  void record(const TickOutput& output, std::span<const RunEvent> events) noexcept;

  void keep_pace(WallClock::time_point start) const {
    const double due_s = static_cast<double>(tick_ + 1) * period_s_ / options_.pace;
    std::this_thread::sleep_until(
        start + std::chrono::duration_cast<WallClock::duration>(std::chrono::duration<double>(due_s)));
  }

  void report_progress(WallClock::time_point start) {
    const double wall_s = seconds_since(start);
    if (wall_s - last_report_s_ < 0.25) return;
    last_report_s_ = wall_s;
    const double done_s = static_cast<double>(tick_ + 1) * period_s_;
    const double factor = done_s / wall_s;
    Progress progress;
    progress.time_s = done_s - time_zero_s_;
    progress.end_s = static_cast<double>(schedule_.ticks) * period_s_ - time_zero_s_;
    progress.pitch_deg = robot_.truth().pitch_rad * 180.0 / std::numbers::pi;
    progress.real_time_factor = factor;
    progress.remaining_wall_s = (static_cast<double>(schedule_.ticks) * period_s_ - done_s) / factor;
    progress.phase = decision::name(phase_);
    options_.on_progress(progress);
  }

  const RunOptions& options_;
  Schedule schedule_;
  host::RunRecorder* recorder_;
  double period_s_;
  double time_zero_s_;
  std::uint32_t telemetry_every_;
  BusWatch watch_;
  host::MemoryBus bus_;
  host::FirmwareNode firmware_;
  sim_hw::SimulatedRobot robot_;
  EventWatch events_{};
  Judge judge_;
  host::TickHistogram tick_times_{};
  std::int64_t tick_ = 0;
  double last_report_s_ = 0.0;
  decision::ReflexPhase phase_ = decision::ReflexPhase::kStanding;
};

void LockstepRun::record(const TickOutput& output, std::span<const RunEvent> events) noexcept {
  const std::int64_t utime_us = std::llround((output.tick * period_s_ - time_zero_s_) * 1e6);
  for (const RunEvent& event : events) {
    recorder_->push(host::Channel::kEvent, utime_us,
                    event_message(utime_us, output.tick, event.code, event.name, event.value));
  }
  if (output.tick % telemetry_every_ == 0) {
    recorder_->push(host::Channel::kControllerState, utime_us, state_message(utime_us, output, firmware_.snapshot()));
    recorder_->push(host::Channel::kSimulatorTruth, utime_us, truth_message(utime_us, output.tick, robot_.truth()));
  }
  if (output.tick % kBusStatisticsTicks == kBusStatisticsTicks - 1 || judge_.is_over()) {
    recorder_->push(host::Channel::kBusStatistics, utime_us,
                    bus_message(utime_us, output.tick, firmware_.counters(), watch_.load_percent(output.tick + 1)));
  }
  if (options_.is_live && output.tick % kTimingStatisticsTicks == kTimingStatisticsTicks - 1) {
    recorder_->push(host::Channel::kTimingStatistics, utime_us, timing_message(utime_us, output.tick, tick_times_));
  }
}

}  // namespace

Verdict run_lockstep(scenario::Scenario scenario, const RunOptions& options) {
  const Schedule schedule = schedule_of(scenario);
  scenario = scheduled(std::move(scenario));
  const std::unique_ptr<host::RunRecorder> recorder = open_recorder(scenario, options.folder, options.is_live);
  LockstepRun run(scenario, options, recorder.get(), schedule);
  Verdict verdict = run.run();
  if (!recorder) return verdict;

  const host::RecordingSummary recorded = recorder->finish();
  verdict.bus_log_sha256 = recorded.bus_log_sha256;
  verdict.frames_lost += recorded.frames_dropped;
  if (recorded.error) {
    throw RecordingFailure(
        fmt::format("{}\n  the run ended at {:.3f} s; what was recorded until then is kept\n  remedy: "
                    "free disk space, or name another folder with --out",
                    recorded.error->message, verdict.ended_at_s));
  }
  write_whole_file(options.folder / "verdict.json", to_json(verdict));
  return verdict;
}

}  // namespace surefoot::run
