#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "tools/batch/parallel_for.hpp"
#include "tools/cli/batch_session.hpp"
#include "tools/cli/bus_options.hpp"
#include "tools/cli/commands.hpp"
#include "tools/floor/ablation.hpp"
#include "tools/floor/criteria.hpp"
#include "tools/floor/floor_maps.hpp"
#include "tools/floor/floor_table.hpp"
#include "tools/floor/torso_trace.hpp"
#include "tools/map/survival_map.hpp"

namespace surefoot::cli {
namespace {

struct FloorArguments : BatchArguments {
  std::string sets = "all";
  std::string seeds;
  double slope_deg = 3.0;
  double duration_s = 10.0;
  bool is_ablation = false;
  std::string map;
  bool is_trace = false;
  bool is_criteria = false;
  std::string controller;
  bool has_cases = false;  ///< an option was given that `is_criteria` knows nothing of
};

floor::FloorTableSpec spec_of(const FloorArguments& arguments, const char* default_seeds) {
  floor::FloorTableSpec spec;
  spec.sets = {arguments.sets};
  if (arguments.sets == "all") spec.sets = {"off", "paper", "extended"};
  spec.seeds = floor::parse_seeds(arguments.seeds.empty() ? default_seeds : arguments.seeds);
  spec.slope_deg = arguments.slope_deg;
  spec.duration_s = arguments.duration_s;
  return spec;
}

run::ExitCode print_cases(const FloorArguments& arguments, const batch::Batch& base) {
  if (!arguments.png.empty()) throw UsageError("--png goes with --trace or --map");
  const floor::FloorTableSpec spec = spec_of(arguments, "1-20");
  BatchSession session("floor-table", arguments);
  const floor::FloorTable table = floor::table_of(spec, session.run(floor::table_batch(spec, base)));
  deliver({[&] { return floor::floor_text(table); }, [&] { return floor::floor_csv(table); },
           [&] { return floor::to_json(table); }},
          arguments);
  session.forget();
  const std::size_t falls = table.falls("extended");
  if (falls == 0) return run::ExitCode::kVerdictHolds;
  fmt::print(stderr, "surefoot floor-table: {} falls under the extended set\n", falls);
  return run::ExitCode::kFellOrLimit;
}

run::ExitCode print_ablation(const FloorArguments& arguments, const batch::Batch& base) {
  if (!arguments.png.empty()) throw UsageError("--png goes with --trace or --map");
  if (arguments.sets == "off") throw UsageError("--ablation takes controllers from a set: paper or extended");
  const floor::FloorTableSpec spec = spec_of(arguments, "1-10");
  const floor::Ablation plan =
      floor::planned({arguments.sets == "paper" ? "paper" : "extended", spec.seeds, spec.slope_deg, spec.duration_s});
  BatchSession session("floor-ablation", arguments);
  const floor::Ablation ablation = floor::ablation_of(plan, session.run(floor::ablation_batch(plan, base)));
  deliver({[&] { return floor::ablation_text(ablation); }, [&] { return floor::ablation_csv(ablation); },
           [&] { return floor::to_json(ablation); }},
          arguments);
  session.forget();
  return run::ExitCode::kVerdictHolds;
}

run::ExitCode print_map(const FloorArguments& arguments, const batch::Batch& base) {
  const floor::FloorTableSpec cases = spec_of(arguments, "1-4");
  const bool varies_load = arguments.map == "payload";
  map::MapSpec spec = varies_load               ? floor::payload_map(arguments.duration_s)
                      : arguments.map == "push" ? floor::push_map(arguments.duration_s)
                                                : floor::rough_map(cases.seeds, arguments.duration_s);
  if (arguments.sets != "all") {
    if (varies_load) throw UsageError("--map payload compares the reflex off and on; leave --set-of-controllers out");
    spec.methods = cases.sets;
  }
  BatchSession session("floor-map", arguments);
  const map::SurvivalMap result = map::map_of(spec, "nominal", session.run(map::map_batch(spec, base)));
  deliver({[&] { return map::map_text(result); }, [&] { return map::map_csv(result); },
           [&] { return map::to_json(result); }},
          arguments);
  session.forget();
  return run::ExitCode::kVerdictHolds;
}

run::ExitCode print_traces(const FloorArguments& arguments, const batch::Batch& base) {
  floor::FloorTableSpec spec = spec_of(arguments, "1");
  if (arguments.sets == "all") spec.sets = {"off", "extended"};
  std::vector<floor::TracedWalk> walks = floor::traced_walks(spec);
  const BatchSession session("floor-trace", arguments);  // refuses a picture that cannot be drawn before the walks
  std::vector<scenario::Scenario> scenarios;
  for (const floor::TracedWalk& walk : walks) scenarios.push_back(floor::scenario_of(walk, spec, base));
  const bool is_interactive = isatty(STDERR_FILENO) == 1;
  std::atomic<std::size_t> done = 0;
  hear_stop_signals();
  const bool is_whole = batch::parallel_for(walks.size(), {arguments.jobs, &stop_requested()}, [&](std::size_t i) {
    walks[i].trace = floor::trace_of(scenarios[i]);
    const std::size_t count = ++done;
    if (is_interactive) fmt::print(stderr, "\r{} of {} walks\033[K", count, walks.size());
  });
  if (is_interactive) fmt::print(stderr, "\r\033[K");
  if (!is_whole) throw batch::Interrupted{done, walks.size()};
  deliver({[&] { return floor::trace_text(walks); }, [&] { return floor::trace_csv(walks); },
           [&] { return floor::to_json(walks, spec); }},
          arguments);
  return run::ExitCode::kVerdictHolds;
}

run::ExitCode print_criteria(const FloorArguments& arguments, const batch::Batch& base) {
  if (!arguments.png.empty()) throw UsageError("--png goes with --trace or --map");
  if (arguments.has_cases) {
    throw UsageError("--criteria has its own floors: --slope, --duration and --set-of-controllers do not go with it");
  }
  const floor::FloorTableSpec spec = spec_of(arguments, "1-20");
  const std::vector<floor::Experiment> experiments = floor::criterion_experiments(spec.seeds, arguments.controller);
  if (experiments.empty()) {
    throw UsageError(fmt::format("--controller: the paper has no {}; surefoot stages lists its thirteen first",
                                 arguments.controller));
  }
  const bool is_interactive = isatty(STDERR_FILENO) == 1;
  const auto start = std::chrono::steady_clock::now();
  floor::CriteriaOptions options{arguments.jobs, &stop_requested(), {}};
  if (is_interactive) {
    options.on_progress = [start](std::size_t done, std::size_t all) {
      const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
      fmt::print(stderr, "\r{} of {} walks, ETA {:.0f} s\033[K", done, all,
                 wall.count() * static_cast<double>(all - done) / static_cast<double>(done));
    };
  }
  hear_stop_signals();
  const floor::Criteria criteria = floor::measure(experiments, base, options);
  if (is_interactive) fmt::print(stderr, "\r\033[K");
  deliver({[&] { return floor::criteria_text(criteria); }, [&] { return floor::criteria_csv(criteria); },
           [&] { return floor::to_json(criteria); }},
          arguments);
  if (criteria.missed() == 0) return run::ExitCode::kVerdictHolds;
  fmt::print(stderr, "surefoot floor-table: {} criteria miss their number\n", criteria.missed());
  return run::ExitCode::kFellOrLimit;
}

run::ExitCode print_floor_table(const FloorArguments& arguments) {
  if (!arguments.plant.empty()) throw UsageError("--plant: khr2 has one plant; change it with --set");
  const int modes = (arguments.is_ablation ? 1 : 0) + (arguments.map.empty() ? 0 : 1) + (arguments.is_trace ? 1 : 0) +
                    (arguments.is_criteria ? 1 : 0);
  if (modes > 1) throw UsageError("give one of --ablation, --criteria, --map and --trace");
  if (!arguments.controller.empty() && !arguments.is_criteria) throw UsageError("--controller goes with --criteria");
  const batch::Batch base = floor::base_of(arguments.scenario_file, arguments.overrides);
  if (arguments.is_ablation) return print_ablation(arguments, base);
  if (!arguments.map.empty()) return print_map(arguments, base);
  if (arguments.is_criteria) return print_criteria(arguments, base);
  return arguments.is_trace ? print_traces(arguments, base) : print_cases(arguments, base);
}

}  // namespace

void add_floor_table(CLI::App& app, run::ExitCode& result) {
  auto arguments = std::make_shared<FloorArguments>();
  CLI::App* command = app.add_subcommand(
      "floor-table",
      "KHR-2 on uneven and inclined floors with and without its controllers, beside the paper's figures.");
  command->add_option("--set-of-controllers", arguments->sets, "off, paper, extended or all")
      ->check(CLI::IsMember({"off", "paper", "extended", "all"}))
      ->capture_default_str();
  command->add_option("--seeds", arguments->seeds,
                      "Seeds of tiles and plates: 1-20 or 1,4,9-12 (default 1-20; --ablation 1-10; --map rough 1-4; "
                      "--trace the first)");
  command->add_option("--slope", arguments->slope_deg, "Slope in roll and pitch with controllers; without them it is 2")
      ->check(CLI::Range(-10.0, 10.0))
      ->type_name("DEG")
      ->capture_default_str();
  command->add_option("--duration", arguments->duration_s, "Length of the walks on the spot")
      ->check(CLI::Range(1.0, 600.0))
      ->type_name("S")
      ->capture_default_str();
  command->add_flag("--ablation", arguments->is_ablation,
                    "Tiles on the slope: each controller alone, and the set (paper, else extended) minus each");
  command
      ->add_option("--map", arguments->map,
                   "What the sets survive: rough (slope by tile height), push (impulse by instant, on the "
                   "scenario's floor), payload (load by instant, with and without the payload reflex)")
      ->check(CLI::IsMember({"rough", "push", "payload"}));
  command->add_flag("--trace", arguments->is_trace,
                    "Torso angles over time on the four floors, without controllers and with the extended set");
  command->add_flag("--criteria", arguments->is_criteria,
                    "Each controller of the paper on against off, in the quantity that it regulates");
  command->add_option("--controller", arguments->controller, "With --criteria: this one alone, e.g. upright_pose")
      ->type_name("NAME");
  add_batch_options(*command, *arguments);
  command->footer(
      "Floors: flat; local: tiles of 30 x 30 mm up to 4 mm; global: a slope in roll and pitch; both; room: steps of\n"
      "20 cm for 55 s on tiles of 2 to 4 mm, plates of 120 x 120 x 4 mm and a slope of 1 degree.\n"
      "An interrupted table goes on where it stopped when the same command is given again;\n"
      "--criteria and --trace begin anew.\n"
      "Exit codes: 0 the extended set falls nowhere (also where it is not asked for), 2 it falls, or a criterion "
      "misses\n"
      "its number, 64 usage, 65 bad scenario, 69 the machine lacks something, 130 interrupted.\n"
      "Examples:\n"
      "  surefoot floor-table\n"
      "  surefoot floor-table --set-of-controllers paper --seeds 1-5 --duration 60 --csv\n"
      "  surefoot floor-table --ablation --set-of-controllers paper\n"
      "  surefoot floor-table --criteria\n"
      "  surefoot floor-table --criteria --controller shock_absorber --seeds 1-50 --json\n"
      "  surefoot floor-table --map rough --png floor_map.png\n"
      "  surefoot floor-table --map push --set floor.slope_roll_deg=3 --set floor.tile_height_m=0.004\n"
      "  surefoot floor-table --map payload --duration 11\n"
      "  surefoot floor-table --trace --png floor_traces.png");
  command->callback([arguments, command, &result] {
    arguments->has_cases =
        command->count("--slope") + command->count("--duration") + command->count("--set-of-controllers") > 0;
    result = with_batch_messages("floor-table", [&] { return print_floor_table(*arguments); });
  });
}

}  // namespace surefoot::cli
