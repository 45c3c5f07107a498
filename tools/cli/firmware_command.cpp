#include <fmt/format.h>

#include <charconv>
#include <memory>
#include <string>
#include <system_error>

#include "firmware/host/realtime/wake_up_probe.hpp"
#include "tools/cli/bus_options.hpp"
#include "tools/cli/commands.hpp"
#include "tools/run/firmware_process.hpp"
#include "tools/run/run_folder.hpp"

namespace surefoot::cli {
namespace {

struct FirmwareArguments : BusProcessArguments {
  bool starts_again = false;
  bool probes = false;
  double patience_s = 30.0;
  int max_missed_ticks = host::OverrunPolicy{}.degrade_after_missed_ticks;
};

void say(const std::string& message) { fmt::print(stderr, "firmware: {}\n", message); }

/// What is wrong with a patience, or nothing; NaN passes CLI11's own range.
std::string refuse_patience(const std::string& text) {
  double patience_s = 0.0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), patience_s);
  const bool is_whole = error == std::errc{} && rest == text.data() + text.size();
  if (is_whole && patience_s >= 0.1 && patience_s <= 86400.0) return "";
  return fmt::format("is {}; expected 0.1 to 86400", text);
}

/// Wake-ups of this machine in the time before the loop, with the loop's own rights.
void probe(const host::RealtimeRequest& rights, std::int64_t period_ns) {
  constexpr std::int64_t kProbeTime_ns = 10'000'000'000;
  host::WakeUpProbe wanted;
  wanted.period_ns = period_ns;
  wanted.ticks = kProbeTime_ns / period_ns;
  wanted.cpus = {rights.cpu};
  wanted.rights = rights;
  say(fmt::format("measuring wake-ups for {} s", kProbeTime_ns / 1'000'000'000));
  for (const host::WakeUpMeasurement& measured : host::measure(wanted, stop_requested())) {
    fmt::print("{}{}", host::duration_table_head(), host::to_text("probe", host::summarise(measured.wake_up)));
  }
}

run::ExitCode run(const FirmwareArguments& arguments) {
  const scenario::Scenario scenario = load_scenario(arguments);
  if (!arguments.folder.empty() && !arguments.overwrites) run::refuse_earlier_run(arguments.folder);
  const auto bus = host::open_bus(arguments.bus, host::BusRole::kController);
  hear_stop_signals();

  run::FirmwareProcessOptions options;
  options.clock = arguments.is_lockstep() ? host::LoopClock::kLockstep : host::LoopClock::kWall;
  options.folder = arguments.folder;
  options.is_live = arguments.is_live;
  options.ends_with_scenario = arguments.ends_with_run;
  options.starts_again = arguments.starts_again;
  options.patience_s = arguments.patience_s;
  options.is_realtime = !arguments.is_lockstep() || arguments.fifo_priority > 0;
  options.rights.fifo_priority = arguments.fifo_priority;
  options.rights.cpu = arguments.cpu;
  options.overruns.degrade_after_missed_ticks = arguments.max_missed_ticks;
  options.stop = &stop_requested();
  options.on_message = say;
  if (arguments.probes) probe(options.rights, std::llround(scenario.firmware.period_s * 1e9));

  const run::FirmwareProcessReport report = run::run_firmware(scenario, *bus, options);
  fmt::print("{}", arguments.is_json ? run::to_json(report) : run::to_text(report, options.clock));
  return report.loop.fault == safety::Fault::kNone ? run::ExitCode::kVerdictHolds : run::ExitCode::kFault;
}

}  // namespace

void add_firmware(CLI::App& app, run::ExitCode& result) {
  auto arguments = std::make_shared<FirmwareArguments>();
  CLI::App* command = app.add_subcommand("firmware", "The balance firmware as a process on a CAN bus.");
  add_bus_process_options(*command, *arguments);
  command->add_flag("--once", arguments->ends_with_run, "End with the scenario's last tick, or with a fault");
  command
      ->add_flag("--start-again", arguments->starts_again,
                 "After a fault: once the robot announces that it has started anew, power up anew")
      ->excludes("--once");
  command->add_option("--patience", arguments->patience_s, "Seconds to wait for the robot's nodes (default 30)")
      ->type_name("SECONDS")
      ->check(refuse_patience);
  command
      ->add_option("--max-missed", arguments->max_missed_ticks,
                   "Wall clock: missed ticks among the last 1000 that latch fault 7; 0: never")
      ->type_name("TICKS")
      ->check(CLI::Range(0, host::OverrunPolicy::kMostMissedTicks))
      ->capture_default_str();
  command->add_flag("--probe", arguments->probes,
                    "First measure this machine's wake-ups for 10 s, as cyclictest does, with the loop's own rights");
  command->footer(
      "It starts only on a bus without another master, and only when all five nodes speak its protocol version.\n"
      "On the wall clock it asks for --priority, --cpu and locked memory, names once what it did not get, and goes "
      "on.\n"
      "Exit codes: 0 ended as asked, 3 a latched fault (firmware/FAULTS.md), 64 usage, 65 bad scenario or address,\n"
      "69 the machine or the bus lacks something (interface, robot, permission).\n"
      "Examples:\n"
      "  surefoot firmware --bus socketcan:vcan0                       # lockstep with `surefoot sim` beside it\n"
      "  surefoot firmware --bus socketcan:can0 --clock wall --priority 80 --cpu 1 --out runs/bench\n"
      "  surefoot firmware --bus socketcan:vcan0 --clock wall --probe --json");
  command->callback([arguments, &result] { result = with_error_messages([&] { return run(*arguments); }); });
}

}  // namespace surefoot::cli
