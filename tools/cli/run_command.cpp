#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <ctime>
#include <memory>
#include <string>
#include <vector>

#include "tools/cli/commands.hpp"
#include "tools/run/lockstep_run.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::cli {
namespace {

std::atomic<bool> stop_requested{false};

extern "C" void request_stop(int) { stop_requested.store(true); }

struct RunArguments {
  std::string scenario_file;
  std::vector<std::string> overrides;
  std::string folder;
  bool is_json = false;
  bool is_live = false;
  bool is_unrecorded = false;
  double pace = 0.0;
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

void show_progress(const run::Progress& progress) {
  fmt::print(stderr, "\r{:8.2f} of {:.2f} s  {:<9}  pitch {:+6.2f} deg  {:5.1f} x real time  ETA {:.0f} s\033[K",
             progress.time_s, progress.end_s, progress.phase, progress.pitch_deg, progress.real_time_factor,
             progress.remaining_wall_s);
  std::fflush(stderr);
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

  std::signal(SIGINT, request_stop);
  std::signal(SIGTERM, request_stop);
  std::signal(SIGXFSZ, SIG_IGN);  // a file at its size limit shall be a write error with a message, not a kill

  run::RunOptions options;
  if (!arguments.is_unrecorded) {
    options.folder = arguments.folder.empty() ? default_folder(arguments) : std::filesystem::path(arguments.folder);
  }
  options.is_live = arguments.is_live;
  options.pace = arguments.pace;
  options.stop = &stop_requested;
  const bool is_interactive = isatty(STDERR_FILENO) == 1;
  if (is_interactive) options.on_progress = show_progress;
  try {
    const run::Verdict verdict = run::run_lockstep(std::move(scenario), options);
    if (is_interactive) fmt::print(stderr, "\r\033[K");
    if (arguments.is_json) {
      fmt::print("{}", run::to_json(verdict));
    } else {
      fmt::print("{}", run::to_text(verdict));
      if (!options.folder.empty()) {
        fmt::print("  recorded     {0}\n  next         tools/surefoot plot {0}\n", options.folder.string());
      }
    }
    return run::exit_code(verdict.outcome);
  } catch (const run::RecordingFailure& error) {
    fmt::print(stderr, "{}{}\n", is_interactive ? "\r\033[K" : "", error.what());
    return run::ExitCode::kMachineLacks;
  }
}

}  // namespace

void add_run(CLI::App& app, run::ExitCode& result) {
  auto arguments = std::make_shared<RunArguments>();
  CLI::App* command = app.add_subcommand("run", "Walk the simulated robot through a scenario and judge the run.");
  command->add_option("scenario", arguments->scenario_file,
                      "Scenario file; without one the main job: 5 kg hung on the chest at 1.2 s");
  command->add_option("--set", arguments->overrides, "Override one key, e.g. payload.0.mass_kg=10; repeatable")
      ->allow_extra_args(false);
  command->add_option("--out", arguments->folder, "Run folder (default: runs/<scenario>-<date>)");
  command->add_flag("--json", arguments->is_json, "Print verdict.json instead of text");
  command->add_flag("--live", arguments->is_live, "Publish telemetry over LCM too (udpm, ttl 0)");
  command->add_flag("--no-record", arguments->is_unrecorded, "Write no run folder");
  command
      ->add_option("--pace", arguments->pace,
                   "Simulated seconds per wall second, 1 to watch live; 0 as fast as it goes")
      ->check(CLI::Range(0.0, 1000.0));
  command->footer(
      "Examples:\n"
      "  surefoot run\n"
      "  surefoot run tools/scenarios/no_payload.toml --json\n"
      "  surefoot run --set reflex.method=off                 # exit 2: the robot falls\n"
      "  surefoot run --set payload.0.mass_kg=10 --set reflex.method=modified --out runs/ten\n"
      "  surefoot run --live --pace 1                         # and `lcm-spy` or `lcm-logger` beside it\n"
      "All keys with units, ranges and defaults: surefoot keys");
  command->callback([arguments, &result] { result = run_scenario(*arguments); });
}

}  // namespace surefoot::cli
