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
    return result.differing_frames == 0 ? run::ExitCode::kVerdictHolds : run::ExitCode::kFellOrLimit;
  } catch (const run::RunFolderError& error) {
    fmt::print(stderr, "{}\n", error.what());
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
  command->add_option("folder", *folder, "Run folder that surefoot run wrote, with scenario.toml and bus.log")
      ->required()
      ->type_name("DIR");
  command->footer(
      "A run that was killed replays up to its last whole tick.\n"
      "Exit codes: 0 identical, 2 frames differ, 64 usage, 65 no run in that folder, or not a whole tick of it.\n"
      "Example:\n  surefoot replay runs/demo");
  command->callback([folder, &result] { result = replay_folder(*folder); });
}

}  // namespace surefoot::cli
