#include <fmt/format.h>

#include <memory>
#include <string>

#include "tools/cli/batch_session.hpp"
#include "tools/cli/commands.hpp"
#include "tools/table/false_alarms.hpp"
#include "tools/table/trigger_delays.hpp"

namespace surefoot::cli {
namespace {

struct TriggerArguments : BatchArguments {
  std::string study;
  std::string method = "original";
  std::string masses;
  std::string times;
  table::NoisePlan plan;
};

std::string title_of(const table::Experiment& experiment) {
  return fmt::format("payload detector, reflex {}, plant {}\n", experiment.method, experiment.plant);
}

run::ExitCode print_delays(const TriggerArguments& arguments, const table::Experiment& experiment) {
  table::Grid grid = table::thesis_grid();
  if (!arguments.masses.empty()) grid.masses_kg = table::parse_list(arguments.masses);
  if (!arguments.times.empty()) grid.times_s = table::parse_list(arguments.times);
  BatchSession session("triggers", arguments);
  const table::TriggerDelays study =
      table::delays_of(experiment, grid, session.run(table::delay_batch(experiment, grid)));
  deliver({[&] { return title_of(experiment) + table::delay_text(study); }, [&] { return table::delay_csv(study); },
           [&] { return table::to_json(study); }},
          arguments);
  session.forget();
  return run::ExitCode::kVerdictHolds;
}

run::ExitCode print_alarms(const TriggerArguments& arguments, const table::Experiment& experiment) {
  BatchSession session("triggers", arguments);
  const table::FalseAlarms study =
      table::false_alarms_of(experiment, arguments.plan, session.run(table::noise_batch(experiment, arguments.plan)));
  deliver({[&] { return title_of(experiment) + table::alarm_text(study); }, [&] { return table::alarm_csv(study); },
           [&] { return table::to_json(study); }},
          arguments);
  session.forget();
  return study.runs_not_walked == 0 ? run::ExitCode::kVerdictHolds : run::ExitCode::kFellOrLimit;
}

run::ExitCode print_study(const TriggerArguments& arguments) {
  table::Experiment experiment{arguments.method, arguments.plant, arguments.scenario_file, arguments.overrides};
  experiment.plant = table::load_common(table::batch_of(experiment)).plant;
  return arguments.study == "delay" ? print_delays(arguments, experiment) : print_alarms(arguments, experiment);
}

void add_noise_options(CLI::App& command, table::NoisePlan& plan) {
  table::SensorNoise& noise = plan.noise;
  const auto add = [&](const char* option, double& value, double largest, const char* what) {
    command.add_option(option, value, what)->check(CLI::Range(0.0, largest))->capture_default_str();
  };
  command.add_option("--cycles", plan.cycles, "noise: gait cycles in all")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  command.add_option("--cycles-per-run", plan.cycles_per_run, "noise: gait cycles with one seed")
      ->check(CLI::Range(1, 700))
      ->capture_default_str();
  command.add_option("--seed", plan.first_seed, "noise: seed of the first run; the next has the next")
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{1} << 52U))
      ->capture_default_str();
  add("--force-noise", noise.force_n, 1000.0, "noise: standard deviation of a corner force, N");
  add("--encoder-noise", noise.encoder_rad, 0.1, "noise: standard deviation of a joint angle, rad");
  add("--rate-noise", noise.joint_rate_rad_s, 10.0, "noise: standard deviation of a joint rate, rad/s");
  add("--gyro-noise", noise.gyro_rad_s, 10.0, "noise: standard deviation of a gyro, rad/s");
  add("--accelerometer-noise", noise.accelerometer_m_s2, 100.0, "noise: standard deviation of an accelerometer, m/s2");
}

}  // namespace

void add_triggers(CLI::App& app, run::ExitCode& result) {
  auto arguments = std::make_shared<TriggerArguments>();
  CLI::App* command = app.add_subcommand(
      "triggers", "When the payload detector fires: after a load (delay), and without one under sensor noise (noise).");
  command->add_option("study", arguments->study, "delay: time from load to detection; noise: false alarms")
      ->required()
      ->check(CLI::IsMember({"delay", "noise"}));
  add_batch_options(*command, *arguments);
  command->add_option("--method", arguments->method, "reflex.method")->capture_default_str();
  command->add_option("--masses", arguments->masses, "delay: loads, kg: 2.5,5 or FIRST:LAST:STEP (2.5:15:2.5)");
  command->add_option("--times", arguments->times, "delay: instants, s, as --masses (0.1:4.8:0.1)");
  add_noise_options(*command, arguments->plan);
  command->footer(
      "Exit codes: 0 done, 2 a false alarm, or a noisy run that did not walk through, 64 usage, 65 bad scenario,\n"
      "69 the machine lacks something, 130 interrupted; the same command then goes on where it stopped.\n"
      "Examples:\n"
      "  surefoot triggers delay --png delay.png\n"
      "  surefoot triggers noise --plant nominal --force-noise 5");
  command->callback(
      [arguments, &result] { result = with_batch_messages("triggers", [&] { return print_study(*arguments); }); });
}

}  // namespace surefoot::cli
