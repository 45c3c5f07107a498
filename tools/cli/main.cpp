#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "tools/cli/commands.hpp"
#include "tools/run/exit_code.hpp"

int main(int argc, char** argv) {
  using surefoot::run::ExitCode;
  CLI::App app{"Surefoot: real-time biped balance firmware and the robot it runs on, simulated down to the CAN bus.",
               "surefoot"};
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 the verdict holds, 2 the robot fell or a limit broke, 3 a latched fault, 64 usage,\n"
      "65 bad input, 69 something the machine lacks (disk, permission), 70 a bug, 130 interrupted.");
  ExitCode result = ExitCode::kBug;
  surefoot::cli::add_run(app, result);
  surefoot::cli::add_replay(app, result);
  surefoot::cli::add_keys(app, result);
  surefoot::cli::add_states(app, result);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int code = app.exit(error);
    return code == 0 ? 0 : static_cast<int>(ExitCode::kUsage);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "surefoot: a bug: %s\n  remedy: report it with the scenario and the command line\n",
                 error.what());
    return static_cast<int>(ExitCode::kBug);
  }
  return static_cast<int>(result);
}
