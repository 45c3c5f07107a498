#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "tools/cli/commands.hpp"
#include "tools/run/exit_code.hpp"

namespace {

using surefoot::run::ExitCode;

ExitCode report_usage(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  const std::vector<std::string> unknown = app.remaining();
  const std::string command = chosen.empty() ? "surefoot" : "surefoot " + chosen.front()->get_name();
  const std::string statement =
      chosen.empty() && !unknown.empty()
          ? fmt::format("{} is no {}", unknown.front(), unknown.front().starts_with('-') ? "option" : "subcommand")
          : std::string(error.what());
  fmt::print(stderr, "{}: {}\n  remedy: see {} --help\n", command, statement, command);
  return ExitCode::kUsage;
}

/// What was asked for and did not reach standard output is missing, as on any other full disk.
ExitCode flush_output(ExitCode result) {
  std::cout.flush();
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout.good()) return result;
  fmt::print(stderr, "standard output: cannot be written\n  remedy: free disk space, or send the output elsewhere\n");
  return ExitCode::kMachineLacks;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Surefoot: real-time biped balance firmware and the robot it runs on, simulated down to the CAN bus.",
               "surefoot"};
  app.require_subcommand(1);
  app.footer(
      "Pictures of a run: tools/surefoot plot DIR. All arguments: surefoot SUBCOMMAND --help.\n"
      "Exit codes: 0 the verdict holds, 2 the robot fell or a limit broke, 3 a latched fault, 64 usage,\n"
      "65 bad input, 69 something the machine lacks (disk, permission, multicast route), 70 a bug, 130 interrupted.");
  ExitCode result = ExitCode::kBug;
  surefoot::cli::add_run(app, result);
  surefoot::cli::add_table(app, result);
  surefoot::cli::add_triggers(app, result);
  surefoot::cli::add_map(app, result);
  surefoot::cli::add_floor_table(app, result);
  surefoot::cli::add_plan(app, result);
  surefoot::cli::add_nominal(app, result);
  surefoot::cli::add_faults(app, result);
  surefoot::cli::add_firmware(app, result);
  surefoot::cli::add_sim(app, result);
  surefoot::cli::add_sweep(app, result);
  surefoot::cli::add_sweep_rows(app, result);
  surefoot::cli::add_replay(app, result);
  surefoot::cli::add_keys(app, result);
  surefoot::cli::add_states(app, result);
  surefoot::cli::add_stages(app, result);
  surefoot::cli::add_bus(app, result);
  surefoot::cli::add_doctor(app, result);
  surefoot::cli::add_bench(app, result);
  surefoot::cli::add_calibrate(app, result);
  surefoot::cli::add_model(app, result);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const bool is_help = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success);
    if (is_help) app.exit(error);
    result = is_help ? ExitCode::kVerdictHolds : report_usage(app, error);
  } catch (const std::exception& error) {
    if (std::ferror(stdout) == 0) {
      fmt::print(stderr, "surefoot: a bug: {}\n  remedy: report it with the scenario and the command line\n",
                 error.what());
    }
    result = ExitCode::kBug;
  }
  return static_cast<int>(flush_output(result));
}
