#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>

#include "tools/cli/batch_session.hpp"
#include "tools/cli/commands.hpp"
#include "tools/table/band.hpp"
#include "tools/table/random_table.hpp"
#include "tools/table/table.hpp"
#include "tools/table/table_text.hpp"

namespace surefoot::cli {
namespace {

struct TableArguments : BatchArguments {
  std::string method;
  std::string masses;
  std::string times;
  std::string compare;
  bool lists_falls = false;
  bool is_band = false;
  std::string frictions;
  std::string toes;
  std::size_t random_count = 0;
  std::uint64_t seed = 1;
  std::size_t required = 0;
};

table::Experiment experiment_of(const TableArguments& arguments) {
  return {arguments.method, arguments.plant, arguments.scenario_file, arguments.overrides};
}

table::Grid grid_of(const TableArguments& arguments, const table::Grid& defaults) {
  return {arguments.times.empty() ? defaults.times_s : table::parse_list(arguments.times),
          arguments.masses.empty() ? defaults.masses_kg : table::parse_list(arguments.masses)};
}

/// The plant by the name that the scenario gives it.
scenario::Scenario complete(table::Experiment& experiment) {
  scenario::Scenario scenario = table::load_common(table::batch_of(experiment));
  experiment.plant = scenario.plant;
  return scenario;
}

std::string title_of(const table::Experiment& experiment) {
  return fmt::format("reflex {}, plant {}\n", experiment.method, experiment.plant);
}

run::ExitCode judge(std::size_t survive, const TableArguments& arguments) {
  if (survive >= arguments.required) return run::ExitCode::kVerdictHolds;
  fmt::print(stderr, "surefoot table: {} survive, --require {} is not met\n", survive, arguments.required);
  return run::ExitCode::kFellOrLimit;
}

run::ExitCode print_grid(const TableArguments& arguments) {
  table::Experiment experiment = experiment_of(arguments);
  const double half_cycle_s = 0.5 * complete(experiment).firmware.walk.cycle_s();
  const std::optional<table::Reference> reference =
      arguments.compare.empty() ? table::thesis_table(experiment.method) : table::load_reference(arguments.compare);
  const table::Grid grid = grid_of(arguments, table::thesis_grid());
  const std::vector<table::Load> loads = table::loads_of(grid);
  BatchSession session("table", arguments);
  const table::Table result{experiment.method, experiment.plant, grid,
                            table::cells_of(loads, session.run(table::batch_of(experiment, loads)))};
  const auto text = [&] {
    return title_of(experiment) + table::matrix_text(result, reference) +
           table::summary_text(result, reference, half_cycle_s) +
           (arguments.lists_falls ? table::falls_text(loads, result.cells) : "");
  };
  deliver({text, [&] { return table::to_csv(loads, result.cells, reference); },
           [&] { return table::to_json(result, reference, half_cycle_s); }},
          arguments);
  session.forget();
  return judge(table::survivors(result.cells), arguments);
}

run::ExitCode print_random(const TableArguments& arguments) {
  table::Experiment experiment = experiment_of(arguments);
  static_cast<void>(complete(experiment));
  const table::Bounds masses_kg = table::parse_bounds(arguments.masses.empty() ? "1:20" : arguments.masses);
  const table::Bounds times_s = table::parse_bounds(arguments.times.empty() ? "0.1:4.8" : arguments.times);
  table::RandomTable result{experiment.method, experiment.plant, arguments.seed, {}, {}};
  result.loads = table::draw_loads(arguments.random_count, arguments.seed, masses_kg, times_s);
  BatchSession session("table", arguments);
  result.cells = table::cells_of(result.loads, session.run(table::batch_of(experiment, result.loads)));
  const auto text = [&] {
    return title_of(experiment) + table::random_text(result, masses_kg) +
           (arguments.lists_falls ? table::falls_text(result.loads, result.cells) : "");
  };
  deliver({text, [&] { return table::to_csv(result.loads, result.cells, {}); }, [&] { return table::to_json(result); }},
          arguments);
  session.forget();
  return judge(table::survivors(result.cells), arguments);
}

run::ExitCode print_band(const TableArguments& arguments) {
  table::Experiment experiment = experiment_of(arguments);
  table::BandAxes axes = table::band_around(complete(experiment));
  if (!arguments.frictions.empty()) axes.frictions = table::parse_list(arguments.frictions);
  if (!arguments.toes.empty()) axes.toes_m = table::parse_list(arguments.toes);
  const table::Grid grid = grid_of(arguments, {table::parse_list("0.3:4.5:0.6"), table::thesis_grid().masses_kg});
  BatchSession session("table", arguments);
  const table::Band band =
      table::band_of(experiment, axes, grid, session.run(table::band_batch(experiment, axes, grid)));
  deliver({[&] { return title_of(experiment) + table::band_text(band); }, [&] { return table::band_csv(band); },
           [&] { return table::to_json(band); }},
          arguments);
  session.forget();
  return judge(table::survivors(band.cells), arguments);
}

run::ExitCode print_table(const TableArguments& arguments) {
  if (arguments.is_band && (arguments.random_count > 0 || !arguments.compare.empty())) {
    throw UsageError("--band goes with neither --random nor --compare");
  }
  if (arguments.random_count > 0 && !arguments.compare.empty()) throw UsageError("--random goes not with --compare");
  if (arguments.is_band) return print_band(arguments);
  return arguments.random_count > 0 ? print_random(arguments) : print_grid(arguments);
}

}  // namespace

void add_table(CLI::App& app, run::ExitCode& result) {
  auto arguments = std::make_shared<TableArguments>();
  CLI::App* command = app.add_subcommand(
      "table",
      "Hang every load on the walking robot at every instant; print what it survives beside the thesis' table.");
  command->add_option("method", arguments->method, "off, original, modified, or another value of reflex.method")
      ->required();
  add_batch_options(*command, *arguments);
  command->add_option("--masses", arguments->masses,
                      "Loads, kg: 2.5,5 or FIRST:LAST:STEP (default 2.5:15:2.5); with --random LOW:HIGH (1:20)");
  command->add_option("--times", arguments->times,
                      "Instants, s: as --masses (default 0.1:4.8:0.1; --band 0.3:4.5:0.6; --random 0.1:4.8)");
  command->add_option("--compare", arguments->compare, "Compare with this table, not the thesis'")->type_name("CSV");
  command->add_flag("--falls", arguments->lists_falls, "List when and how the robot fell in every failed cell");
  command->add_option("--require", arguments->required, "Exit with 2 when fewer cells survive")->type_name("N");
  command->add_option("--random", arguments->random_count, "Draw N loads and instants off the grid instead")
      ->type_name("N")
      ->check(CLI::Range(1, 100000));
  command->add_option("--seed", arguments->seed, "Seed of the draws (default 1)");
  CLI::Option* band = command->add_flag("--band", arguments->is_band,
                                        "Count survivors over a band of plants, floor friction by toe length, instead");
  command->add_option("--friction", arguments->frictions, "The band's frictions (default 0.8, 1, 1.25 x the plant's)")
      ->needs(band);
  command->add_option("--toe", arguments->toes, "The band's toe lengths, m (default the plant's -4, 0, +4 mm)")
      ->needs(band);
  command->footer(
      "A cell survives when the robot does not fall and walks two whole cycles after it has resumed.\n"
      "An interrupted table goes on where it stopped when the same command is given again.\n"
      "Exit codes: 0 the table is done, 2 --require is not met, 64 usage, 65 bad scenario or CSV, 69 the machine\n"
      "lacks something, 130 interrupted.\n"
      "Examples:\n"
      "  surefoot table original --falls --png original.png\n"
      "  surefoot table modified --plant nominal --masses 5,10,15 --times 0.1:2.4:0.1\n"
      "  surefoot table original --random 200 --seed 7\n"
      "  surefoot table off --band --friction 0.09:0.13:0.02 --toe 0.119,0.1228,0.126");
  command->callback(
      [arguments, &result] { result = with_batch_messages("table", [&] { return print_table(*arguments); }); });
}

}  // namespace surefoot::cli
