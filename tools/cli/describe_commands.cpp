#include <fmt/format.h>

#include "firmware/core/decision/reflex_phase.hpp"
#include "firmware/core/decision/walk_stage.hpp"
#include "firmware/core/stabilizer/activation.hpp"
#include "tools/cli/commands.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::cli {
namespace {

void print_schedule() {
  fmt::print("\n| controller |");
  for (std::size_t phase = 0; phase < stabilizer::kSchedulePhases; ++phase) {
    fmt::print(" {} |", stabilizer::name(static_cast<stabilizer::SchedulePhase>(phase)));
  }
  fmt::print("\n| --- |");
  for (std::size_t phase = 0; phase < stabilizer::kSchedulePhases; ++phase) fmt::print(" --- |");
  fmt::print("\n");
  for (const stabilizer::ActivationRow& row : stabilizer::kActivation) {
    fmt::print("| {} |", stabilizer::name(row.controller));
    for (const bool acts : row.acts_in) fmt::print(" {} |", acts ? "x" : " ");
    fmt::print("\n");
  }
}

}  // namespace

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

void add_stages(CLI::App& app, run::ExitCode& result) {
  CLI::App* command = app.add_subcommand(
      "stages", "Print the transition table of the floor walk, and which controllers act in which of its phases.");
  command->callback([&result] {
    fmt::print("| from | on | to |\n| --- | --- | --- |\n");
    for (const decision::WalkEdge& edge : decision::kWalkEdges) {
      fmt::print("| {} | {} | {} |\n", decision::name(edge.from), decision::name(edge.on), decision::name(edge.to));
    }
    print_schedule();
    result = run::ExitCode::kVerdictHolds;
  });
}

}  // namespace surefoot::cli
