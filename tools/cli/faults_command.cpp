#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "tools/cli/bus_options.hpp"
#include "tools/cli/commands.hpp"
#include "tools/faults/fault_table.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::cli {
namespace {

struct FaultsArguments {
  std::string scenario_file;
  std::vector<std::string> overrides;
  std::string only;
  bool is_json = false;
};

run::ExitCode print_table(const FaultsArguments& arguments) {
  const scenario::Scenario scenario = arguments.scenario_file.empty()
                                          ? scenario::load_default(arguments.overrides)
                                          : scenario::load(arguments.scenario_file, arguments.overrides);
  std::vector<faults::CatalogueEntry> entries = faults::catalogue();
  std::erase_if(entries, [&](const faults::CatalogueEntry& entry) {
    return entry.what.find(arguments.only) == std::string::npos;
  });
  if (entries.empty()) {
    fmt::print(stderr,
               "surefoot faults: --only {}: no fault of the catalogue has this in its name\n"
               "  remedy: leave --only out to see all names\n",
               arguments.only);
    return run::ExitCode::kUsage;
  }
  const bool is_interactive = isatty(STDERR_FILENO) == 1;
  const std::vector<faults::FaultRow> rows = faults::try_all(scenario, entries, [&](std::size_t done, std::size_t all) {
    if (is_interactive) fmt::print(stderr, "\r{} of {} trials\033[K{}", done, all, done == all ? "\r\033[K" : "");
  });
  fmt::print("{}", arguments.is_json ? faults::to_json(rows) : faults::to_markdown(rows));
  const bool is_within_gate = std::ranges::all_of(rows, [](const faults::FaultRow& row) {
    return std::ranges::all_of(row.result, [](const auto& result) { return result.command.is_within_gate; });
  });
  return is_within_gate ? run::ExitCode::kVerdictHolds : run::ExitCode::kBug;
}

}  // namespace

void add_faults(CLI::App& app, run::ExitCode& result) {
  auto arguments = std::make_shared<FaultsArguments>();
  CLI::App* command = app.add_subcommand(
      "faults", "Let every fault strike while the robot stands, walks and reacts; print what came of it.");
  command->add_option("scenario", arguments->scenario_file, "Scenario file; without one the main job")
      ->type_name("FILE");
  command->add_option("--set", arguments->overrides, "Override one key, e.g. plant=nominal; repeatable")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command->add_option("--only", arguments->only, "Only faults with this text in their name")->type_name("TEXT");
  command->add_flag("--json", arguments->is_json, "Print an array of trials instead of a table in Markdown");
  command->footer(
      "Each cell: what the firmware did (rode through, or the latched fault, its safe state, and after how many\n"
      "ticks), and whether the robot went down within 4 s after the fault. Faults: firmware/FAULTS.md.\n"
      "Exit codes: 0 every command kept the output gate's limits, 64 usage, 65 bad scenario, 70 one did not (a bug).\n"
      "Examples:\n"
      "  surefoot faults --set plant=nominal\n"
      "  surefoot faults --only 'link down' --json\n"
      "A fault of your own in a run: surefoot run --set fault.0.kind=drop --set fault.0.target=foot_left");
  command->callback([arguments, &result] { result = with_error_messages([&] { return print_table(*arguments); }); });
}

}  // namespace surefoot::cli
