#include "tools/cli/bus_options.hpp"

#include <fmt/format.h>

#include <atomic>
#include <csignal>

#include "firmware/host/loop/start_up.hpp"
#include "tools/run/child_process.hpp"
#include "tools/run/run_folder.hpp"
#include "tools/run/schedule.hpp"
#include "tools/run/telemetry_log_reader.hpp"

namespace surefoot::cli {
namespace {

std::atomic<bool> stop{false};

extern "C" void request_stop(int) { stop.store(true); }

}  // namespace

void add_bus_process_options(CLI::App& command, BusProcessArguments& arguments) {
  command.add_option("scenario", arguments.scenario_file, "Scenario file; without one the main job")->type_name("FILE");
  command.add_option("--set", arguments.overrides, "Override one key, e.g. reflex.method=off; repeatable")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command
      .add_option(
          "--bus", arguments.bus,
          "socketcan:vcan0, socketcan:can0,can1 (one bus a leg), or udp (python-can's udp_multicast on loopback)")
      ->type_name("ADDRESS")
      ->required();
  command
      .add_option("--clock", arguments.clock,
                  "lockstep: as fast as both go, same bits each time; wall: a fixed period in real time")
      ->check(CLI::IsMember({"lockstep", "wall"}))
      ->capture_default_str();
  CLI::Option* folder =
      command.add_option("--out", arguments.folder, "Folder to record into (default: nothing is recorded)")
          ->type_name("DIR");
  command.add_flag("--overwrite", arguments.overwrites, "Replace the run that the folder of --out holds already")
      ->needs(folder);
  command.add_flag("--live", arguments.is_live, "Publish telemetry over LCM too (udpm, ttl 0)")->needs(folder);
  command.add_flag("--json", arguments.is_json, "Print the final report as JSON");
  command.add_option("--priority", arguments.fifo_priority, "SCHED_FIFO priority 1 to 99; 0 (default): none asked for")
      ->check(CLI::Range(0, 99));
  command.add_option("--cpu", arguments.cpu, "Processor to stay on; -1 (default): any")->check(CLI::Range(-1, 1023));
}

scenario::Scenario load_scenario(const BusProcessArguments& arguments) {
  return run::scheduled(arguments.scenario_file.empty() ? scenario::load_default(arguments.overrides)
                                                        : scenario::load(arguments.scenario_file, arguments.overrides));
}

run::ExitCode with_error_messages(const std::function<run::ExitCode()>& work) {
  try {
    return work();
  } catch (const scenario::ScenarioError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return run::ExitCode::kBadInput;
  } catch (const host::BusError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return error.cause() == host::BusError::Cause::kBadAddress ? run::ExitCode::kBadInput
                                                               : run::ExitCode::kMachineLacks;
  } catch (const host::StartUpError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return run::ExitCode::kMachineLacks;
  } catch (const run::ProcessFailure& error) {
    fmt::print(stderr, "{}\n", error.what());
    return static_cast<run::ExitCode>(error.exit_code());
  } catch (const run::TelemetryLogError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return run::ExitCode::kMachineLacks;
  } catch (const run::RecordingFailure& error) {
    fmt::print(stderr, "{}\n", error.what());
    return run::ExitCode::kMachineLacks;
  }
}

const std::atomic<bool>& stop_requested() noexcept { return stop; }

void hear_stop_signals() noexcept {
  std::signal(SIGINT, request_stop);
  std::signal(SIGTERM, request_stop);
  std::signal(SIGXFSZ, SIG_IGN);  // a file at its size limit shall be a write error with a message, not a kill
}

}  // namespace surefoot::cli
