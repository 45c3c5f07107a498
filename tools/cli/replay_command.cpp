#include <fmt/format.h>

#include <memory>
#include <string>

#include "tools/cli/commands.hpp"
#include "tools/run/candump_log.hpp"
#include "tools/run/replay.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::cli {
namespace {

run::ExitCode replay_folder(const std::string& folder) {
  try {
    const run::ReplayResult result = run::replay(folder);
    fmt::print("  replayed     {} ticks, {} frames of the controller, {} differ{}\n", result.ticks,
               result.controller_frames, result.differing_frames,
               result.first_difference.empty() ? "" : fmt::format("; the first: {}", result.first_difference));
    if (result.ends_in_mid_tick)
      fmt::print("  note         the log ends in the middle of a tick, which was left out\n");
    if (result.ticks == 0) {
      fmt::print(stderr, "{}/bus.log: holds no whole tick\n  remedy: record the run again\n", folder);
      return run::ExitCode::kBadInput;
    }
    return result.differing_frames == 0 ? run::ExitCode::kVerdictHolds : run::ExitCode::kFellOrLimit;
  } catch (const scenario::ScenarioError& error) {
    fmt::print(stderr, "{}\n", error.what());
  } catch (const run::CandumpLogError& error) {
    fmt::print(stderr, "{}\n", error.what());
  }
  return run::ExitCode::kBadInput;
}

}  // namespace

void add_replay(CLI::App& app, run::ExitCode& result) {
  auto folder = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand(
      "replay", "Feed the recorded node frames to the firmware and require identical frames from it.");
  command->add_option("run", *folder, "Run folder with scenario.toml and bus.log")->required();
  command->footer(
      "Exit codes: 0 identical, 2 frames differ, 65 unreadable run folder.\n"
      "Example:\n  surefoot replay runs/demo");
  command->callback([folder, &result] { result = replay_folder(*folder); });
}

}  // namespace surefoot::cli
