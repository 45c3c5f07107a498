#include <fmt/format.h>
#include <unistd.h>

#include <charconv>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "tools/cli/batch_session.hpp"
#include "tools/cli/commands.hpp"
#include "tools/cli/picture.hpp"
#include "tools/plan/comparison.hpp"
#include "tools/plan/gait_file.hpp"
#include "tools/plan/plan_json.hpp"
#include "tools/plan/plan_text.hpp"
#include "tools/plan/samples.hpp"
#include "tools/plan/speeds.hpp"
#include "tools/plan/walked.hpp"
#include "tools/run/run_folder.hpp"
#include "tools/scenario/scenario_error.hpp"

namespace surefoot::cli {
namespace {

constexpr int kCsvSamples = 501;

struct PlanArguments {
  std::string file;
  std::vector<std::string> overrides;
  bool is_json = false;
  std::string csv;
  std::string png;
  std::string out;
  bool only_checks = false;
  bool compares = false;
  std::optional<double> speed_m_s;
  bool chooses_step = false;
  std::string speeds;
  std::vector<std::string> walks;
  int steps = 20;
  bool prints_keys = false;

  [[nodiscard]] std::string source() const { return file.empty() ? "surefoot plan" : file; }
};

/// The gaits as a scenario, where there is a robot for them.
void write_gait_file(const PlanArguments& arguments, const std::vector<plan::PlanResult>& gaits) {
  if (arguments.out.empty()) return;
  run::write_whole_file(arguments.out, plan::gait_file_text(gaits, arguments.steps));
}

/// Says what keeps a request from being met, and what is next to it.
run::ExitCode verdict(const PlanArguments& arguments, const plan::PlanResult& result) {
  if (result.is_feasible()) return run::ExitCode::kVerdictHolds;
  fmt::print(stderr, "{}: infeasible ({}): {}\n  remedy: {}\n", arguments.source(), result.after.broken(),
             plan::complaint(result.request, result.after), plan::remedy_text(result));
  return run::ExitCode::kFellOrLimit;
}

run::ExitCode print_plan(const PlanArguments& arguments, const plan::PlanRequest& request) {
  const plan::PlanResult result = plan::plan_gait(request, {.compensates = !arguments.only_checks,
                                                            .speed_m_s = arguments.speed_m_s,
                                                            .chooses_step = arguments.chooses_step});
  fmt::print("{}", arguments.is_json ? plan::to_json(result) : plan::plan_text(result));
  if (!arguments.csv.empty()) {
    run::write_whole_file(arguments.csv, plan::samples_csv(plan::samples_of(request, result.after.plan, kCsvSamples)));
  }
  if (!arguments.png.empty()) draw_picture(plan::picture_json(result), arguments.png);
  if (result.is_feasible()) {
    write_gait_file(arguments, {result});
    if (!arguments.out.empty() && !arguments.is_json) {
      fmt::print("  written      {0}\n  next         tools/surefoot run {0}\n", arguments.out);
    }
  }
  return verdict(arguments, result);
}

run::ExitCode print_comparison(const PlanArguments& arguments, const plan::PlanRequest& request) {
  const plan::PlanResult result = plan::plan_gait(request, {.compensates = !arguments.only_checks});
  const std::vector<plan::CheckedGait> gaits = plan::compare(request, result.after.plan.gait);
  if (arguments.is_json) {
    fmt::print("{}", plan::to_json(gaits));
  } else {
    const planning::GaitFactors& gait = gaits.front().plan.gait;
    fmt::print("Gait for {}: H {:.3f} m, S {:.3f} m, T_s {:.4f} s; feet {:g} and {:g} degrees\n{}", request.robot,
               gait.com_height_m, gait.step_length_m, gait.single_support_s, request.toe_angle_deg,
               request.heel_angle_deg, plan::comparison_text(gaits));
  }
  return run::ExitCode::kVerdictHolds;
}

run::ExitCode print_library(const PlanArguments& arguments, const plan::PlanRequest& request) {
  const std::vector<double> speeds_m_s = plan::parse_speeds(arguments.speeds);
  if (!arguments.out.empty() && speeds_m_s.size() > plan::kMostGaits) {
    throw UsageError(fmt::format("--speeds {} are {} gaits; a gait file takes {}", arguments.speeds, speeds_m_s.size(),
                                 plan::kMostGaits));
  }
  const std::vector<plan::PlanResult> gaits = plan::library(request, speeds_m_s, arguments.chooses_step);
  fmt::print("{}", arguments.is_json ? plan::to_json(gaits) : plan::library_text(gaits));
  run::ExitCode code = run::ExitCode::kVerdictHolds;
  for (const plan::PlanResult& result : gaits) {
    if (result.is_feasible()) continue;
    code = verdict(arguments, result);
  }
  if (code == run::ExitCode::kVerdictHolds) write_gait_file(arguments, gaits);
  return code;
}

scenario::Scenario load_planned(const std::string& file, const std::vector<std::string>& overrides) {
  scenario::Scenario scenario = scenario::load(file, overrides);
  if (!scenario.gaits.empty()) return scenario;
  throw scenario::ScenarioError({{file, "has no [[planned_gait]], so that there is no plan to compare the walk with",
                                  "write a gait with surefoot plan --out FILE"}});
}

run::ExitCode print_walks(const PlanArguments& arguments) {
  if (!arguments.png.empty()) check_picture(arguments.png);
  std::vector<scenario::Scenario> scenarios;
  for (const std::string& file : arguments.walks) scenarios.push_back(load_planned(file, arguments.overrides));
  const bool is_interactive = isatty(STDERR_FILENO) == 1;
  std::vector<plan::Walked> walks;
  run::ExitCode code = run::ExitCode::kVerdictHolds;
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    if (is_interactive) fmt::print(stderr, "\r{} of {} walks\033[K", i, scenarios.size());
    walks.push_back(plan::walk(arguments.walks[i], scenarios[i]));
    if (walks.back().has_fallen) code = run::ExitCode::kFellOrLimit;
    if (walks.back().has_fault && code == run::ExitCode::kVerdictHolds) code = run::ExitCode::kFault;
  }
  if (is_interactive) fmt::print(stderr, "\r\033[K");
  fmt::print("{}", arguments.is_json ? plan::walked_json(walks, false) : plan::walked_text(walks));
  if (!arguments.png.empty()) draw_picture(plan::walked_json(walks, true), arguments.png);
  return code;
}

run::ExitCode answer(const PlanArguments& arguments) {
  if (!arguments.walks.empty()) return print_walks(arguments);
  if (arguments.prints_keys) {
    fmt::print("{}", plan::describe_request_keys());
    return run::ExitCode::kVerdictHolds;
  }
  const plan::PlanRequest request = arguments.file.empty()
                                        ? plan::load_request_text("surefoot plan", "", arguments.overrides)
                                        : plan::load_request(arguments.file, arguments.overrides);
  if (!arguments.out.empty() && request.robot == "paper") {
    throw UsageError("--out writes a gait for a robot that there is: add --set robot=khr2 or elkahlout");
  }
  if (!arguments.png.empty()) check_picture(arguments.png);
  if (arguments.compares) return print_comparison(arguments, request);
  return arguments.speeds.empty() ? print_plan(arguments, request) : print_library(arguments, request);
}

run::ExitCode with_messages(const std::function<run::ExitCode()>& work) {
  try {
    return work();
  } catch (const scenario::ScenarioError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return run::ExitCode::kBadInput;
  } catch (const plan::BadSpeeds& error) {
    fmt::print(stderr, "surefoot plan: {}\n  remedy: write FROM:TO:STEP in m/s, as in --speeds 0.1:0.25:0.05\n",
               error.what());
  } catch (const UsageError& error) {
    fmt::print(stderr, "surefoot plan: {}\n  remedy: see surefoot plan --help\n", error.what());
  } catch (const run::RecordingFailure& error) {
    fmt::print(stderr, "{}\n", error.what());
    return run::ExitCode::kMachineLacks;
  }
  return run::ExitCode::kUsage;
}

/// What is wrong with a speed, or nothing.
std::string refuse_speed(const std::string& text) {
  double speed_m_s = 0.0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), speed_m_s);
  const bool is_whole = error == std::errc{} && rest == text.data() + text.size();
  if (is_whole && speed_m_s >= plan::kSlowest_m_s && speed_m_s <= plan::kFastest_m_s) return "";
  return fmt::format("is {}; expected {} to {} m/s", text, plan::kSlowest_m_s, plan::kFastest_m_s);
}

}  // namespace

void add_plan(CLI::App& app, run::ExitCode& result) {
  auto arguments = std::make_shared<PlanArguments>();
  CLI::App* command = app.add_subcommand(
      "plan", "Plan a gait: check it against knees, friction and ZMP, retune it until it is feasible.");
  command
      ->add_option("request", arguments->file,
                   "What is wanted (TOML): robot, gait, feet, limits; without one the case of Al-Shuka et al. 2014")
      ->type_name("FILE");
  command->add_option("--set", arguments->overrides, "Override one key, e.g. gait.step_length_m=0.4; repeatable")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  CLI::Option* check =
      command->add_flag("--no-compensation", arguments->only_checks, "Check only; exit code 2 where it is infeasible");
  CLI::Option* speed = command
                           ->add_option("--speed", arguments->speed_m_s,
                                        "Solve T_s, T_d, p and, for the knees, H for this speed, m/s; S as asked")
                           ->type_name("M/S")
                           ->check(refuse_speed)
                           ->excludes(check);
  CLI::Option* speeds =
      command->add_option("--speeds", arguments->speeds, "A gait for each of these speeds: FROM:TO:STEP, m/s")
          ->type_name("A:B:STEP")
          ->excludes(check)
          ->excludes(speed);
  command->add_flag("--choose-step", arguments->chooses_step,
                    "With --speed or --speeds: S too, the feasible one next to that asked for");
  CLI::Option* compare = command
                             ->add_flag("--compare", arguments->compares,
                                        "Patterns 1, 2, 3 with each way of the centre of mass, after compensation")
                             ->excludes(speed)
                             ->excludes(speeds);
  CLI::Option* walks = command
                           ->add_option("--walk", arguments->walks,
                                        "Walk these gait files; planned against true ZMP (table, --json, --png)")
                           ->type_name("FILE")
                           ->excludes(check)
                           ->excludes(speed)
                           ->excludes(speeds)
                           ->excludes(compare)
                           ->excludes("request");
  CLI::Option* out = command->add_option("--out", arguments->out, "Write the gait as a scenario, for surefoot run")
                         ->type_name("FILE")
                         ->excludes(check)
                         ->excludes(compare)
                         ->excludes(walks);
  command->add_option("--steps", arguments->steps, "With --out: steps walked with each gait")
      ->check(CLI::Range(2, 1000))
      ->needs(out)
      ->capture_default_str();
  command->add_option("--csv", arguments->csv, "Write samples over a step: COG, ZMP, support, feet, loads")
      ->type_name("FILE")
      ->excludes(compare)
      ->excludes(walks)
      ->excludes(speeds);
  command->add_option("--png", arguments->png, "Draw COG, ZMP, stick figures, feet, and the patterns")
      ->type_name("FILE")
      ->excludes(compare)
      ->excludes(speeds);
  command->add_flag("--json", arguments->is_json, "Print JSON");
  command->add_flag("--keys", arguments->prints_keys, "Print every key with unit, range, default and meaning");
  command->footer(
      "Compensation: a stretched knee lowers H; a foot that slips or pulls, or a ZMP that leaves its support makes "
      "the\n"
      "step slower, then shorter; T_d stays a fifth of the step's time and p follows.\n"
      "Exit codes: 0 feasible, 2 infeasible (the message names the constraint and the nearest feasible values)\n"
      "or, with --walk, fallen, 3 a fault in a walk, 64 usage, 65 bad request, 69 the machine lacks something.\n"
      "Examples:\n"
      "  surefoot plan\n"
      "  surefoot plan --no-compensation                          # exit code 2: a leg is too short\n"
      "  surefoot plan --compare\n"
      "  surefoot plan tools/plans/khr2.toml --speed 0.15 --png plan.png\n"
      "  surefoot plan tools/plans/khr2.toml --speeds 0.1:0.2:0.05 --out gaits.toml\n"
      "  surefoot plan --set robot=khr2 --set pattern=flat_feet --out gait.toml && surefoot run gait.toml\n"
      "  surefoot plan --walk tools/scenarios/khr2_pattern3.toml --png zmp.png");
  command->callback([arguments, &result] { result = with_messages([&] { return answer(*arguments); }); });
}

}  // namespace surefoot::cli
