#include <fmt/format.h>
#include <unistd.h>

#include <charconv>
#include <ctime>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "tools/cli/bus_options.hpp"
#include "tools/cli/commands.hpp"
#include "tools/run/lockstep_run.hpp"
#include "tools/run/run_folder.hpp"
#include "tools/run/two_process_run.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::cli {
namespace {

constexpr double kSlowestPace = 0.01;  // a stop is heard between two ticks
constexpr double kFastestPace = 1000.0;

struct RunArguments {
  std::string scenario_file;
  std::vector<std::string> overrides;
  std::string folder;
  bool is_json = false;
  bool is_live = false;
  bool is_unrecorded = false;
  bool overwrites = false;
  double pace = 0.0;
  std::string bus;
  std::string clock = "lockstep";
  int fifo_priority = 0;
};

std::filesystem::path default_folder(const RunArguments& arguments) {
  const std::string stem =
      arguments.scenario_file.empty() ? "main" : std::filesystem::path(arguments.scenario_file).stem().string();
  const std::time_t now = std::time(nullptr);
  std::tm calendar{};
  localtime_r(&now, &calendar);
  char stamp[32];
  std::strftime(stamp, sizeof stamp, "%Y%m%d-%H%M%S", &calendar);
  return std::filesystem::path("runs") / fmt::format("{}-{}", stem, stamp);
}

std::filesystem::path folder_of(const RunArguments& arguments) {
  if (arguments.folder.empty()) return run::claim_run_folder(default_folder(arguments));
  if (!arguments.overwrites) run::refuse_earlier_run(arguments.folder);
  return arguments.folder;
}

void show_progress(const run::Progress& progress) {
  fmt::print(stderr, "\r{:8.2f} of {:.2f} s  {:<9}  pitch {:+6.2f} deg  {:5.1f} x real time  ETA {:.0f} s\033[K",
             progress.time_s, progress.end_s, progress.phase, progress.pitch_deg, progress.real_time_factor,
             progress.remaining_wall_s);
  std::fflush(stderr);
}

void print(const run::Verdict& verdict, const RunArguments& arguments, const std::filesystem::path& folder) {
  if (arguments.is_json) {
    fmt::print("{}", run::to_json(verdict));
    return;
  }
  fmt::print("{}", run::to_text(verdict));
  if (!folder.empty()) fmt::print("  recorded     {0}\n  next         tools/surefoot plot {0}\n", folder.string());
}

/// Firmware and robot as two processes on a bus of the operating system.
run::ExitCode run_on_bus(const RunArguments& arguments, scenario::Scenario scenario) {
  // Opened and closed again: what is wrong with it shall be said once, before there is a run folder.
  static_cast<void>(host::open_bus(arguments.bus, host::BusRole::kEverything));
  run::TwoProcessOptions options;
  options.program = std::filesystem::read_symlink("/proc/self/exe");
  options.folder = folder_of(arguments);
  options.bus = arguments.bus;
  options.is_wall_clock = arguments.clock == "wall";
  options.fifo_priority = arguments.fifo_priority;
  options.stop = &stop_requested();
  if (isatty(STDERR_FILENO) == 1) {
    options.on_progress = [](double elapsed_s) { fmt::print(stderr, "\r{:8.1f} s on the bus\033[K", elapsed_s); };
  }
  const run::Verdict verdict = run::run_two_processes(std::move(scenario), options);
  print(verdict, arguments, options.folder);
  return run::exit_code(verdict.outcome);
}

run::ExitCode run_scenario(const RunArguments& arguments) {
  scenario::Scenario scenario;
  try {
    scenario = arguments.scenario_file.empty() ? scenario::load_default(arguments.overrides)
                                               : scenario::load(arguments.scenario_file, arguments.overrides);
  } catch (const scenario::ScenarioError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return run::ExitCode::kBadInput;
  }

  hear_stop_signals();
  if (!arguments.bus.empty()) return with_error_messages([&] { return run_on_bus(arguments, std::move(scenario)); });

  run::RunOptions options;
  options.is_live = arguments.is_live;
  options.pace = arguments.pace;
  options.stop = &stop_requested();
  const bool is_interactive = isatty(STDERR_FILENO) == 1;
  if (is_interactive) options.on_progress = show_progress;
  try {
    if (!arguments.is_unrecorded) options.folder = folder_of(arguments);
    const run::Verdict verdict = run::run_lockstep(std::move(scenario), options);
    if (is_interactive) fmt::print(stderr, "\r\033[K");
    print(verdict, arguments, options.folder);
    return run::exit_code(verdict.outcome);
  } catch (const run::RecordingFailure& error) {
    fmt::print(stderr, "{}{}\n", is_interactive ? "\r\033[K" : "", error.what());
    return run::ExitCode::kMachineLacks;
  }
}

/// What is wrong with a name, or nothing. An unset variable in a script gives an empty one.
std::string refuse_empty(const std::string& text) { return text.empty() ? "is empty; expected a name" : ""; }

/// What is wrong with a pace, or nothing.
std::string refuse_pace(const std::string& text) {
  double pace = -1.0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), pace);
  const bool is_whole = error == std::errc{} && rest == text.data() + text.size();
  if (is_whole && (pace == 0.0 || (pace >= kSlowestPace && pace <= kFastestPace))) return "";
  return fmt::format("is {}; expected 0, or {} to {}", text, kSlowestPace, kFastestPace);
}

}  // namespace

void add_run(CLI::App& app, run::ExitCode& result) {
  auto arguments = std::make_shared<RunArguments>();
  CLI::App* command = app.add_subcommand("run", "Walk the simulated robot through a scenario and judge the run.");
  command
      ->add_option("scenario", arguments->scenario_file,
                   "Scenario file; without one the main job: 5 kg hung on the chest at 1.2 s")
      ->type_name("FILE")
      ->check(refuse_empty);
  command->add_option("--set", arguments->overrides, "Override one key, e.g. payload.0.mass_kg=10; repeatable")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  CLI::Option* folder =
      command->add_option("--out", arguments->folder, "Run folder (default: a new one, runs/<scenario>-<date>)")
          ->type_name("DIR")
          ->check(refuse_empty);
  command->add_flag("--overwrite", arguments->overwrites, "Replace the run that the folder of --out holds already")
      ->needs(folder);
  command->add_flag("--json", arguments->is_json, "Print verdict.json instead of text");
  CLI::Option* live = command->add_flag("--live", arguments->is_live,
                                        "Publish telemetry over LCM too (udpm, ttl 0); needs a multicast route");
  command->add_flag("--no-record", arguments->is_unrecorded, "Write no run folder")->excludes(folder)->excludes(live);
  command
      ->add_option("--pace", arguments->pace,
                   "Simulated seconds per wall second, 0.01 to 1000; 1 to watch live, 0 (default) as fast as it goes")
      ->type_name("SPEED")
      ->check(refuse_pace);
  CLI::Option* bus =
      command
          ->add_option("--bus", arguments->bus,
                       "Run firmware and robot as two processes that meet on this bus only: socketcan:vcan0,\n"
                       "socketcan:vcan0,vcan1 (one bus a leg), udp. Without it: one process, bus in memory")
          ->type_name("ADDRESS")
          ->check(refuse_empty);
  bus->excludes("--live")->excludes("--pace")->excludes("--no-record");
  command->add_option("--clock", arguments->clock, "With --bus: lockstep (default) or wall")
      ->check(CLI::IsMember({"lockstep", "wall"}))
      ->needs(bus);
  command
      ->add_option("--priority", arguments->fifo_priority, "With --bus: SCHED_FIFO priority of the firmware, 1 to 99")
      ->check(CLI::Range(1, 99))
      ->needs(bus);
  command->footer(
      "Ctrl-C ends a run early; what was recorded until then is kept and can be plotted and replayed.\n"
      "Exit codes: 0 the verdict holds, 2 the robot fell or a limit broke, 3 a latched fault, 64 usage,\n"
      "65 bad scenario, 69 the machine lacks something (disk, permission, multicast route), 130 interrupted.\n"
      "Examples:\n"
      "  surefoot run\n"
      "  surefoot run tools/scenarios/no_payload.toml --json\n"
      "  surefoot run --set reflex.method=off                 # exit code 2: the robot falls\n"
      "  surefoot run --set payload.0.mass_kg=10 --out runs/ten\n"
      "  tools/with-vcan tools/surefoot run --bus socketcan:vcan0    # two processes over SocketCAN\n"
      "  surefoot run --live --pace 1                         # and `lcm-logger` beside it\n"
      "All keys with units, ranges and defaults: surefoot keys");
  command->callback([arguments, &result] { result = run_scenario(*arguments); });
}

}  // namespace surefoot::cli
