#include "tools/run/firmware_process.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "firmware/host/allocation_guard.hpp"
#include "firmware/host/realtime/monotonic_clock.hpp"
#include "firmware/host/recorded_bus.hpp"
#include "tools/run/bus_report_json.hpp"
#include "tools/run/fault_teller.hpp"
#include "tools/run/histogram_json.hpp"
#include "tools/run/firmware_recorder.hpp"
#include "tools/run/open_recorder.hpp"
#include "tools/run/run_folder.hpp"
#include "tools/run/schedule.hpp"

namespace surefoot::run {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const host::DurationSummary& durations) {
  return {
      {"count", durations.count}, {"mean", durations.mean_us}, {"p50", durations.p50_us}, {"p999", durations.p999_us}, {"max", durations.max_us},
      {"histogram", histogram_json(durations.bins)}};
}

/// Lets the teller hear what the recorder hears.
class Observer final : public host::TickObserver {
 public:
  Observer(FirmwareRecorder& recorder, FaultTeller& teller) noexcept : recorder_(recorder), teller_(teller) {}

  void before_tick(std::int64_t elapsed_us) noexcept override { recorder_.before_tick(elapsed_us); }
  void after_tick(const host::FirmwareNode& node, const TickOutput& output) noexcept override {
    recorder_.after_tick(node, output);
    teller_.on_tick(output.fault);
  }
  void between_ticks(const host::LoopReport* report) noexcept override { recorder_.between_ticks(report); }

 private:
  FirmwareRecorder& recorder_;
  FaultTeller& teller_;
};

class Process {
 public:
  Process(const scenario::Scenario& scenario, host::HostBus& bus, const FirmwareProcessOptions& options)
      : scenario_(scenario), bus_(bus), options_(options) {}

  FirmwareProcessReport run() {
    // Before the thread turns real-time: the threads of recorder and teller shall not inherit that.
    const std::unique_ptr<host::RunRecorder> recorder = open_recorder(scenario_, options_.folder, options_.is_live);
    FaultTeller teller(options_.on_message);
    std::optional<host::RealtimeRights> rights;
    if (options_.is_realtime) {
      rights.emplace(options_.rights);
      if (!rights->missing().empty()) say(host::to_text(rights->missing()));
    }
    do {
      if (!power_up(recorder.get(), teller)) break;
    } while (options_.starts_again && !is_stopped());
    report_.bus = bus_.report();
    if (recorder) {
      const host::RecordingSummary recorded = recorder->finish();
      report_.telemetry_dropped = recorded.frames_dropped + recorded.messages_dropped;
      if (recorded.error) {
        throw RecordingFailure(
            fmt::format("{}\n  what was recorded until then is kept\n  remedy: free disk space, or "
                        "name another folder with --out",
                        recorded.error->message));
      }
      write_whole_file(options_.folder / "firmware.json", to_json(report_));
    }
    return report_;
  }

 private:
  /// One power-up: from waiting for the robot to the loop's end.
  /// @return false when nobody came before `stop`
  bool power_up(host::RunRecorder* recorder, FaultTeller& teller) {
    host::RecordedBus bus(bus_, recorder);
    host::FirmwareNode node(scenario_.firmware);
    host::StartUpConfig start_up;
    start_up.clock = options_.clock;
    // Once it has run, it waits for its robot as long as it takes.
    const bool is_first = report_.starts == 0;
    start_up.patience_ns =
        is_first ? std::llround(options_.patience_s * 1e9) : std::numeric_limits<std::int64_t>::max();
    say("waiting for the robot");
    if (!host::await_robot(node, bus, start_up, stop(),
                           [this](const std::string& missing) { say(fmt::format("still waiting for {}", missing)); })) {
      return false;
    }
    say("all five nodes are there: tick 0");
    ++report_.starts;

    FirmwareRecorder loop_recorder(scenario_, recorder, options_.clock == host::LoopClock::kLockstep);
    Observer observer(loop_recorder, teller);
    const std::int64_t start_ns = host::MonotonicClock::now_ns();
    report_.loop = host::run_firmware_loop(node, bus, loop_config(), observer, stop());
    const double wall_s = 1e-9 * static_cast<double>(host::MonotonicClock::now_ns() - start_ns);
    report_.frames = node.counters();
    report_.frames.refused_by_bus += report_.loop.refused_by_bus;
    report_.allocations_in_loop += loop_recorder.allocations();
    report_.allocations_were_counted = host::allocation_guard::is_available();
    report_.real_time_factor = static_cast<double>(report_.loop.ticks) * scenario_.firmware.period_s / wall_s;
    teller.tell();
    return true;
  }

  [[nodiscard]] host::FirmwareLoopConfig loop_config() const {
    host::FirmwareLoopConfig config;
    config.clock = options_.clock;
    config.period_ns = std::llround(scenario_.firmware.period_s * 1e9);
    config.overruns = options_.overruns;
    config.ends_at_fault = options_.ends_with_scenario;
    config.ends_when_robot_returns = options_.starts_again;
    if (options_.ends_with_scenario) config.ticks = schedule_of(scenario_).ticks;
    return config;
  }

  [[nodiscard]] const std::atomic<bool>& stop() const noexcept {
    return options_.stop != nullptr ? *options_.stop : never_;
  }
  [[nodiscard]] bool is_stopped() const noexcept { return stop().load(std::memory_order_relaxed); }

  void say(const std::string& message) const {
    if (options_.on_message) options_.on_message(message);
  }

  const scenario::Scenario& scenario_;
  host::HostBus& bus_;
  const FirmwareProcessOptions& options_;
  FirmwareProcessReport report_{};
  std::atomic<bool> never_{false};
};

}  // namespace

std::string to_json(const FirmwareProcessReport& report) {
  const host::LoopReport& loop = report.loop.report;
  Json rejected = Json::array();
  for (const std::uint64_t count : report.frames.rejected) rejected.push_back(count);
  const Json json{
      {"fault", static_cast<int>(report.loop.fault)},
      {"fault_name", safety::name(report.loop.fault)},
      {"starts", report.starts},
      {"ticks", report.loop.ticks},
      {"ticks_run", loop.ticks},
      {"silent_ticks", report.loop.silent_ticks},
      {"overruns", loop.overruns},
      {"missed_ticks", loop.missed_ticks},
      {"wake_up_us", json_of(loop.wake_up)},
      {"tick_us", json_of(loop.compute)},
      {"answer_us", json_of(loop.frame)},
      {"minor_page_faults", loop.usage.minor_page_faults},
      {"major_page_faults", loop.usage.major_page_faults},
      {"voluntary_switches", loop.usage.voluntary_switches},
      {"involuntary_switches", loop.usage.involuntary_switches},
      {"allocations_in_loop", report.allocations_were_counted ? Json(report.allocations_in_loop) : Json(nullptr)},
      {"real_time_factor", report.real_time_factor},
      {"telemetry_dropped", report.telemetry_dropped},
      {"frames",
       {{"sent", report.frames.sent},
        {"received", report.frames.received},
        {"lost", report.frames.lost},
        {"refused_by_bus", report.frames.refused_by_bus},
        {"rejected", rejected}}},
      {"bus", json_of(report.bus)},
  };
  return json.dump(2) + "\n";
}

std::string to_text(const FirmwareProcessReport& report, host::LoopClock clock) {
  const host::FirmwareLoopResult& loop = report.loop;
  std::string text =
      fmt::format("  ticks        {}, {:.2f} x real time{}\n", loop.ticks, report.real_time_factor,
                  loop.fault == safety::Fault::kNone
                      ? std::string()
                      : fmt::format("; fault {} ({})", static_cast<int>(loop.fault), safety::name(loop.fault)));
  text += fmt::format("  frames       {} sent, {} received, {} lost, {} refused; {} ticks without an answer in time\n",
                      report.frames.sent, report.frames.received, report.frames.lost, report.frames.refused_by_bus,
                      loop.silent_ticks);
  text += fmt::format("  memory       {} allocations in the loop, {} telemetry messages or frames dropped\n",
                      report.allocations_were_counted ? fmt::format("{}", report.allocations_in_loop) : "uncounted",
                      report.telemetry_dropped);
  if (clock == host::LoopClock::kWall) text += to_text(loop.report);
  return text;
}

FirmwareProcessReport run_firmware(const scenario::Scenario& scenario, host::HostBus& bus,
                                   const FirmwareProcessOptions& options) {
  return Process(scenario, bus, options).run();
}

}  // namespace surefoot::run
