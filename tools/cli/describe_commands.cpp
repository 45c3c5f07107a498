#include <fmt/format.h>

#include "firmware/core/decision/reflex_phase.hpp"
#include "tools/cli/commands.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::cli {

void add_keys(CLI::App& app, run::ExitCode& result) {
  CLI::App* command = app.add_subcommand("keys", "Print every scenario key with unit, range, default and meaning.");
  command->callback([&result] {
    fmt::print("{}", scenario::describe_keys());
    result = run::ExitCode::kVerdictHolds;
  });
}

void add_states(CLI::App& app, run::ExitCode& result) {
  CLI::App* command = app.add_subcommand("states", "Print the transition table of the payload reflex.");
  command->callback([&result] {
    fmt::print("| from | on | to |\n| --- | --- | --- |\n");
    for (const decision::Edge& edge : decision::kReflexEdges) {
      fmt::print("| {} | {} | {} |\n", decision::name(edge.from), decision::name(edge.on), decision::name(edge.to));
    }
    result = run::ExitCode::kVerdictHolds;
  });
}

}  // namespace surefoot::cli
