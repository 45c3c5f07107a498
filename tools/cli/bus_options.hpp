#pragma once

#include <CLI/CLI.hpp>
#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "firmware/host/bus/bus_address.hpp"
#include "tools/run/exit_code.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::cli {

/// What `surefoot firmware` and `surefoot sim` are told alike.
struct BusProcessArguments {
  std::string scenario_file;
  std::vector<std::string> overrides;
  std::string bus;
  std::string clock = "lockstep";
  std::string folder;
  bool overwrites = false;
  bool is_live = false;
  bool is_json = false;
  bool ends_with_run = false;
  int fifo_priority = 0;  ///< 0: as any process
  int cpu = -1;

  [[nodiscard]] bool is_lockstep() const { return clock == "lockstep"; }
};

/// Adds the options above.
void add_bus_process_options(CLI::App& command, BusProcessArguments& arguments);

/// The scenario with its time zero set.
/// @throws scenario::ScenarioError
[[nodiscard]] scenario::Scenario load_scenario(const BusProcessArguments& arguments);

/// Does `work` and turns the errors of buses, scenarios and recordings into a message and an exit code.
[[nodiscard]] run::ExitCode with_error_messages(const std::function<run::ExitCode()>& work);

/// Set by SIGINT and SIGTERM once `hear_stop_signals` was called.
[[nodiscard]] const std::atomic<bool>& stop_requested() noexcept;
void hear_stop_signals() noexcept;

}  // namespace surefoot::cli
