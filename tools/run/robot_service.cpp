#include "tools/run/robot_service.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "firmware/can/messages.hpp"
#include "firmware/host/realtime/monotonic_clock.hpp"
#include "firmware/host/realtime/silence_watch.hpp"
#include "firmware/host/recorded_bus.hpp"
#include "firmware/host/run_recorder.hpp"
#include "tools/run/bus_report_json.hpp"
#include "tools/run/event_watch.hpp"
#include "tools/run/open_recorder.hpp"
#include "tools/run/run_folder.hpp"
#include "tools/run/standing_pose.hpp"
#include "tools/run/telemetry_messages.hpp"

namespace surefoot::run {
namespace {

using host::MonotonicClock;

constexpr std::int64_t kSecond_ns = 1'000'000'000;
constexpr std::int64_t kAnnouncePeriod_ns = 100'000'000;
/// A firmware that starts again as soon as it hears the boards boot may still send for some ticks.
constexpr std::int64_t kPowerUp_ns = 200'000'000;

/// Records under the tick that SYNC names, so that equal lockstep runs give equal logs.
class SyncStampedTap final : public host::BusTap {
 public:
  SyncStampedTap(host::RunRecorder* recorder, double period_s) noexcept : recorder_(recorder), period_s_(period_s) {}

  void on_frame(const can::CanFrame& frame) noexcept override {
    if (recorder_ == nullptr) return;
    can::FrameStamp stamp;
    if (frame.identifier == can::kSyncIdentifier && can::decode_sync(frame, stamp) == can::Rejection::kNone) {
      recorder_->set_elapsed(std::llround(stamp.tick * period_s_ * 1e6));
    }
    recorder_->on_frame(frame);
  }

 private:
  host::RunRecorder* recorder_;
  double period_s_;
};

/// One robot from being put on its feet to being picked up again.
class Appearance {
 public:
  Appearance(const scenario::Scenario& scenario, host::HostBus& bus, const RobotServiceOptions& options,
             host::RunRecorder* recorder)
      : options_(options),
        recorder_(recorder),
        period_s_(scenario.firmware.period_s),
        time_zero_s_(scenario.sim.time_zero_s),
        telemetry_every_(scenario.telemetry.every_ticks),
        half_step_s_(0.5 * scenario.sim.physics_step_s),
        silence_ns_(std::llround(options.silence_s * 1e9)),
        lie_ns_(std::llround(options.lie_s * 1e9)),
        tap_(recorder, period_s_),
        bus_(bus, &tap_),
        robot_(scenario.sim, standing_pose(scenario.firmware), options.clock) {}

  /// Until the master is gone, or `stop`.
  void run() {
    say("the robot stands, waiting for a master");
    const std::int64_t up_ns = MonotonicClock::now_ns() + kPowerUp_ns;
    robot_.announce(bus_);  // boot-up, also when a master is sending already
    while (!is_stopped() && !is_over_) {
      if (recorder_ != nullptr && is_lockstep()) recorder_->wait_for_room();
      static_cast<void>(bus_.wait_readable(next_deadline_ns(MonotonicClock::now_ns())));
      const std::int64_t now_ns = MonotonicClock::now_ns();
      robot_.expect_power_up(!is_lockstep() && now_ns < up_ns);
      step(now_ns);
    }
  }

  [[nodiscard]] bool had_master() const noexcept { return had_master_; }
  [[nodiscard]] bool has_fallen() const noexcept { return robot_.truth().has_fallen; }
  [[nodiscard]] const sim_hw::SimulatedRobot& robot() const noexcept { return robot_; }
  [[nodiscard]] double driven_wall_s() const noexcept {
    return had_master_ ? 1e-9 * static_cast<double>(last_heard_ns_ - first_sync_ns_) : 0.0;
  }

 private:
  [[nodiscard]] bool is_lockstep() const noexcept { return options_.clock == sim_hw::WorldClock::kLockstep; }
  [[nodiscard]] bool is_stopped() const noexcept {
    return options_.stop != nullptr && options_.stop->load(std::memory_order_relaxed);
  }

  [[nodiscard]] std::int64_t next_deadline_ns(std::int64_t now_ns) const noexcept {
    if (!is_lockstep() && had_master_) return now_ns + std::llround(period_s_ * 1e9);
    return std::min(now_ns + kAnnouncePeriod_ns,
                    announce_due_ns_ > now_ns ? announce_due_ns_ : now_ns + kAnnouncePeriod_ns);
  }

  void step(std::int64_t now_ns) {
    if (!is_lockstep() && had_master_) {
      // Half a step ahead: a SYNC that is a little early or late still meets the same step, and the joints are
      // sampled as evenly as hardware would.
      robot_.advance_to(1e-9 * static_cast<double>(now_ns - first_sync_ns_) + half_step_s_, bus_);
    }
    robot_.serve(bus_);
    note_sync(now_ns);
    if (is_lockstep() && had_master_) tell_when_answers_are_missing();
    if (robot_.has_master() && !had_master_) meet_master(now_ns);
    record();
    if (!had_master_) announce_if_due(now_ns);  // not while it lies: the next master waits until it stands again
    if (had_master_) watch_master(now_ns);
  }

  /// Only SYNC tells of a master that goes on: one that powers up anew sends heartbeats while it waits for us.
  void note_sync(std::int64_t now_ns) noexcept {
    if (robot_.wire_tick() == heard_tick_) return;
    heard_tick_ = robot_.wire_tick();
    last_heard_ns_ = now_ns;
    silence_.restart(now_ns);
  }

  void meet_master(std::int64_t now_ns) {
    had_master_ = true;
    first_sync_ns_ = now_ns;
    last_heard_ns_ = now_ns;
    silence_.restart(now_ns);
    say(fmt::format("a master drives the robot from its tick {} on", robot_.first_tick()));
  }

  void announce_if_due(std::int64_t now_ns) {
    if (now_ns < announce_due_ns_) return;
    announce_due_ns_ = now_ns + kAnnouncePeriod_ns;
    robot_.announce(bus_);
  }

  /// The master would wait for states that a fault keeps from it.
  void tell_when_answers_are_missing() noexcept {
    if (robot_.has_answered_fully() || marked_tick_ == robot_.wire_tick()) return;
    marked_tick_ = robot_.wire_tick();
    robot_.tell_served(bus_);
  }

  void watch_master(std::int64_t now_ns) {
    if (robot_.truth().has_fallen && !has_told_fall_) {
      has_told_fall_ = true;
      say(fmt::format("the robot fell at {:.3f} s", robot_.truth().time_s));
      if (options_.ends_with_master) is_over_ = true;
    }
    if (is_lockstep()) {
      // At once, before this robot announces itself: the next master shall not begin with a robot that lies.
      if (silence_.look(now_ns) <= silence_ns_) return;
      is_over_ = true;
      return tell_silence("the world stands still");
    }
    if (robot_.has_master()) {
      if (lost_master_ns_ != 0) say(fmt::format("the master is back at its tick {}", robot_.tick()));
      lost_master_ns_ = 0;
      return;
    }
    if (lost_master_ns_ == 0) {
      lost_master_ns_ = now_ns;
      return tell_silence("the leg boards damp, the robot sinks");
    }
    is_over_ = is_over_ || now_ns - lost_master_ns_ > lie_ns_;
  }

  void tell_silence(const char* consequence) const {
    say(fmt::format("the master has fallen silent after its tick {}; {}", robot_.tick(), consequence));
  }

  void record() {
    const bool is_new_period = robot_.periods() != recorded_periods_;
    recorded_periods_ = robot_.periods();
    const std::span<const RunEvent> events = events_.observe_world(robot_.truth());
    if (recorder_ == nullptr || !had_master_) return;
    for (const RunEvent& event : events) {
      // Faults begin and end with a SYNC, which may have come in one go with the torques of the period before.
      const bool is_of_wire =
          is_lockstep() && (event.code == event_t::FAULT_INJECTED || event.code == event_t::FAULT_ENDED);
      const std::uint32_t tick = is_of_wire ? robot_.wire_tick() : robot_.truth_tick();
      const std::int64_t utime_us = utime_us_of(tick);
      recorder_->push(host::Channel::kEvent, utime_us,
                      event_message(utime_us, tick, event.code, event.name, event.value));
    }
    if (is_new_period && robot_.truth_tick() % telemetry_every_ == 0) {
      const std::int64_t utime_us = utime_us_of(robot_.truth_tick());
      recorder_->push(host::Channel::kSimulatorTruth, utime_us,
                      truth_message(utime_us, robot_.truth_tick(), robot_.truth()));
    }
  }

  [[nodiscard]] std::int64_t utime_us_of(std::uint32_t tick) const noexcept {
    return std::llround((tick * period_s_ - time_zero_s_) * 1e6);
  }

  void say(const std::string& message) const {
    if (options_.on_message) options_.on_message(message);
  }

  const RobotServiceOptions& options_;
  host::RunRecorder* recorder_;
  double period_s_;
  double time_zero_s_;
  std::uint32_t telemetry_every_;
  double half_step_s_;
  std::int64_t silence_ns_;
  std::int64_t lie_ns_;
  SyncStampedTap tap_;
  host::RecordedBus bus_;
  sim_hw::SimulatedRobot robot_;
  EventWatch events_{};
  host::SilenceWatch silence_{2 * kAnnouncePeriod_ns};
  std::int64_t recorded_periods_ = 0;
  std::int64_t announce_due_ns_ = 0;
  std::int64_t first_sync_ns_ = 0;
  std::int64_t last_heard_ns_ = 0;
  std::int64_t lost_master_ns_ = 0;
  std::uint32_t marked_tick_ = 0xFFFF'FFFFU;
  std::uint32_t heard_tick_ = 0;
  bool had_master_ = false;
  bool has_told_fall_ = false;
  bool is_over_ = false;
};

}  // namespace

std::string to_json(const RobotServiceReport& report) {
  std::uint64_t rejected = 0;
  for (const std::uint64_t count : report.counters.rejected) rejected += count;
  const nlohmann::ordered_json json{
      {"masters", report.masters},
      {"falls", report.falls},
      {"periods", report.periods},
      {"real_time_factor", report.real_time_factor},
      {"telemetry_dropped", report.telemetry_dropped},
      {"frames_sent", report.counters.sent},
      {"frames_received", report.counters.received},
      {"frames_rejected", rejected},
      {"frames_rejected_late", report.counters.rejected[static_cast<std::size_t>(can::Rejection::kLate)]},
      {"frames_refused_by_bus", report.counters.refused_by_bus},
      {"frames_lost", report.counters.lost},
      {"bus", json_of(report.bus)},
  };
  return json.dump(2) + "\n";
}

RobotServiceReport serve_robot(const scenario::Scenario& scenario, host::HostBus& bus,
                               const RobotServiceOptions& options) {
  RobotServiceReport report;
  const auto is_stopped = [&] { return options.stop != nullptr && options.stop->load(std::memory_order_relaxed); };
  do {
    // What was recorded under one master stays when the next one comes.
    const std::filesystem::path folder = options.folder.empty() || report.masters == 0
                                             ? options.folder
                                             : options.folder / fmt::format("master_{}", report.masters + 1);
    const std::unique_ptr<host::RunRecorder> recorder = open_recorder(scenario, folder, options.is_live);
    Appearance appearance(scenario, bus, options, recorder.get());
    appearance.run();
    if (appearance.had_master()) {
      ++report.masters;
      report.periods = static_cast<std::uint64_t>(appearance.robot().periods());
      report.counters = appearance.robot().counters();
      const double simulated_s = static_cast<double>(report.periods) * scenario.firmware.period_s;
      report.real_time_factor = simulated_s / std::max(appearance.driven_wall_s(), 1e-9);
    }
    if (appearance.has_fallen()) ++report.falls;
    if (recorder) {
      const host::RecordingSummary recorded = recorder->finish();
      report.telemetry_dropped += recorded.frames_dropped + recorded.messages_dropped;
      if (recorded.error) {
        throw RecordingFailure(
            fmt::format("{}\n  what was recorded until then is kept\n  remedy: free disk space, or "
                        "name another folder with --out",
                        recorded.error->message));
      }
    }
  } while (!is_stopped() && !(options.ends_with_master && report.masters > 0));
  report.bus = bus.report();
  if (!options.folder.empty()) write_whole_file(options.folder / "robot.json", to_json(report));
  return report;
}

}  // namespace surefoot::run
