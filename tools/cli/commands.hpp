#pragma once

#include <CLI/CLI.hpp>

#include "tools/run/exit_code.hpp"

namespace surefoot::cli {

/// Each adds one subcommand that, when it is called, does its work and sets `result`.
void add_run(CLI::App& app, run::ExitCode& result);
void add_table(CLI::App& app, run::ExitCode& result);
void add_triggers(CLI::App& app, run::ExitCode& result);
void add_map(CLI::App& app, run::ExitCode& result);
void add_floor_table(CLI::App& app, run::ExitCode& result);
void add_plan(CLI::App& app, run::ExitCode& result);
void add_nominal(CLI::App& app, run::ExitCode& result);
void add_faults(CLI::App& app, run::ExitCode& result);
void add_firmware(CLI::App& app, run::ExitCode& result);
void add_sim(CLI::App& app, run::ExitCode& result);
void add_sweep(CLI::App& app, run::ExitCode& result);
void add_sweep_rows(CLI::App& app, run::ExitCode& result);
void add_replay(CLI::App& app, run::ExitCode& result);
void add_keys(CLI::App& app, run::ExitCode& result);
void add_states(CLI::App& app, run::ExitCode& result);
void add_stages(CLI::App& app, run::ExitCode& result);
void add_bus(CLI::App& app, run::ExitCode& result);
void add_doctor(CLI::App& app, run::ExitCode& result);
void add_bench(CLI::App& app, run::ExitCode& result);
void add_calibrate(CLI::App& app, run::ExitCode& result);
void add_model(CLI::App& app, run::ExitCode& result);

}  // namespace surefoot::cli
