#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "tools/cli/batch_session.hpp"
#include "tools/cli/commands.hpp"
#include "tools/map/survival_map.hpp"
#include "tools/table/experiment.hpp"

namespace surefoot::cli {
namespace {

struct MapArguments : BatchArguments {
  std::string file;
  std::string kind;
  std::vector<std::string> methods;
  bool prints_spec = false;
};

const map::Preset* preset_of(const std::string& kind) {
  for (const map::Preset& preset : map::presets()) {
    if (kind == preset.kind) return &preset;
  }
  return nullptr;
}

map::MapSpec spec_of(const MapArguments& arguments) {
  map::MapSpec spec = arguments.file.empty() ? map::parse_spec(arguments.kind, preset_of(arguments.kind)->text)
                                             : map::load_spec(arguments.file);
  if (!arguments.methods.empty()) spec.methods = arguments.methods;
  return spec;
}

run::ExitCode print_map(const MapArguments& arguments) {
  if (arguments.file.empty() == arguments.kind.empty()) throw UsageError("give either a specification or --kind");
  if (arguments.prints_spec) {
    if (arguments.kind.empty()) throw UsageError("--print goes with --kind");
    fmt::print("{}", preset_of(arguments.kind)->text);
    return run::ExitCode::kVerdictHolds;
  }
  const map::MapSpec spec = spec_of(arguments);
  const batch::Batch base =
      table::batch_of({spec.methods.front(), arguments.plant, arguments.scenario_file, arguments.overrides});
  const std::string plant = table::load_common(base).plant;
  BatchSession session("map", arguments);
  const map::SurvivalMap result = map::map_of(spec, plant, session.run(map::map_batch(spec, base)));
  deliver({[&] { return map::map_text(result); }, [&] { return map::map_csv(result); },
           [&] { return map::to_json(result); }},
          arguments);
  session.forget();
  return run::ExitCode::kVerdictHolds;
}

}  // namespace

void add_map(CLI::App& app, run::ExitCode& result) {
  auto arguments = std::make_shared<MapArguments>();
  CLI::App* command =
      app.add_subcommand("map", "What the robot survives, method against method: two axes of disturbances, as counts.");
  command->add_option("spec", arguments->file, "Specification (TOML): axes and methods")->type_name("FILE");
  std::vector<std::string> kinds;
  std::string list;
  for (const map::Preset& preset : map::presets()) {
    kinds.emplace_back(preset.kind);
    list += fmt::format("  {:<11} {}\n", preset.kind, preset.what);
  }
  command->add_option("--kind", arguments->kind, "A specification that comes with the program, see below")
      ->check(CLI::IsMember(kinds));
  command->add_option("--methods", arguments->methods, "Methods to compare, comma-separated, instead of its own")
      ->delimiter(',');
  command->add_flag("--print", arguments->prints_spec, "Print the specification of --kind, to write one's own from");
  add_batch_options(*command, *arguments);
  command->footer("Kinds:\n" + list +
                  "An interrupted map goes on where it stopped when the same command is given again.\n"
                  "Exit codes: 0 done, 64 usage, 65 bad specification or scenario, 69 the machine lacks something,\n"
                  "130 interrupted.\n"
                  "Examples:\n"
                  "  surefoot map --kind mass-time --png map.png\n"
                  "  surefoot map --kind push --plant nominal --methods off,original\n"
                  "  surefoot map --kind slope --print > mine.toml && surefoot map mine.toml --csv");
  command->callback(
      [arguments, &result] { result = with_batch_messages("map", [&] { return print_map(*arguments); }); });
}

}  // namespace surefoot::cli
