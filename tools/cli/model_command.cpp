#include <fmt/format.h>

#include <fstream>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "tools/cli/bus_options.hpp"
#include "tools/cli/commands.hpp"
#include "tools/robot_model/model_json.hpp"
#include "tools/robot_model/urdf.hpp"

namespace surefoot::cli {
namespace {

struct ModelArguments {
  std::string scenario_file;
  std::vector<std::string> overrides;
  std::string urdf;
  std::string poses;
  std::vector<double> extent_m;
  bool is_json = false;
};

scenario::Scenario scenario_of(const ModelArguments& arguments) {
  return arguments.scenario_file.empty() ? scenario::load_default(arguments.overrides)
                                         : scenario::load(arguments.scenario_file, arguments.overrides);
}

robot_model::Extent extent_of(const std::vector<double>& bounds_m) {
  if (bounds_m.empty()) return {};
  const robot_model::Extent extent{bounds_m[0], bounds_m[1], bounds_m[2], bounds_m[3]};
  if (extent.from_x_m < extent.to_x_m && extent.from_y_m < extent.to_y_m) return extent;
  throw std::invalid_argument("--extent is empty\n  remedy: X0,X1,Y0,Y1 in metres with X0 < X1 and Y0 < Y1");
}

/// Text to a file or, for "-", to standard output.
run::ExitCode write(const std::string& file, const std::string& text) {
  if (file == "-") {
    fmt::print("{}", text);
    return run::ExitCode::kVerdictHolds;
  }
  std::ofstream output(file, std::ios::binary);
  output << text;
  output.close();
  if (output) return run::ExitCode::kVerdictHolds;
  fmt::print(stderr, "{}: cannot be written\n  remedy: give a file in a folder that exists and has room\n", file);
  return run::ExitCode::kMachineLacks;
}

std::string poses_text(const ModelArguments& arguments, const sim_hw::SimConfig& sim) {
  std::ifstream file;
  if (arguments.poses != "-") {
    file.open(arguments.poses);
    if (!file)
      throw std::invalid_argument(arguments.poses +
                                  ": cannot be read\n  remedy: name a JSON file, or - for standard input");
  }
  const auto poses = robot_model::read_poses(arguments.poses == "-" ? std::cin : file);
  return robot_model::poses_json(sim, poses).dump() + "\n";
}

std::string summary(const scenario::Scenario& scenario) {
  const robot_model::LinkTree tree = robot_model::link_tree(scenario.sim);
  std::string text = fmt::format("{}: {} links, 12 joints, {:.6g} kg\n", scenario.robot, tree.links.size(),
                                 robot_model::simulated_pose(scenario.sim, {}).mass_kg);
  text += "  link                  mass (kg)   centre of mass in the link's frame (m)\n";
  for (const robot_model::Link& link : tree.links) {
    text += fmt::format("  {:<22} {:>7.3f}   {:>8.4f} {:>8.4f} {:>8.4f}\n", link.name, link.mass_kg, link.com_m.x(),
                        link.com_m.y(), link.com_m.z());
  }
  return text;
}

run::ExitCode show(const ModelArguments& arguments) {
  const scenario::Scenario scenario = scenario_of(arguments);
  try {
    if (!arguments.poses.empty()) return write("-", poses_text(arguments, scenario.sim));
    if (arguments.is_json) {
      return write("-", robot_model::model_json(scenario, extent_of(arguments.extent_m)).dump() + "\n");
    }
  } catch (const std::invalid_argument& error) {
    fmt::print(stderr, "{}\n", error.what());
    return run::ExitCode::kBadInput;
  }
  if (arguments.urdf.empty()) return write("-", summary(scenario));
  return write(arguments.urdf,
               robot_model::to_urdf(scenario.robot, robot_model::link_tree(scenario.sim), scenario.sim,
                                    scenario.firmware.gate));
}

}  // namespace

void add_model(CLI::App& app, run::ExitCode& result) {
  auto arguments = std::make_shared<ModelArguments>();
  CLI::App* command = app.add_subcommand(
      "model", "The simulated robot for other programs: URDF, or all that is needed to draw a scenario.");
  command->add_option("scenario", arguments->scenario_file, "Scenario file (default: main job)")->type_name("FILE");
  command->add_option("--set", arguments->overrides, "Override one key, e.g. robot=khr2; repeatable")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  CLI::Option* urdf = command->add_option("--urdf", arguments->urdf, "Write the robot as URDF, - for standard output");
  urdf->type_name("FILE");
  CLI::Option* json =
      command->add_flag("--json", arguments->is_json, "Print URDF, soles, payloads, pushes and floor as JSON");
  json->excludes(urdf);
  command->add_option("--extent", arguments->extent_m, "With --json: the part of the floor (default: -1,3,-1,1)")
      ->type_name("X0,X1,Y0,Y1")
      ->delimiter(',')
      ->expected(4)
      ->needs(json);
  command
      ->add_option(
          "--poses", arguments->poses,
          "Print where the simulator's bodies are for these joint angles: a JSON array of arrays of 12, in rad")
      ->type_name("FILE")
      ->excludes(urdf)
      ->excludes(json);
  command->footer(
      "Masses, centres of mass, inertias and joints of the URDF are the simulator's to the last bit; its root link is\n"
      "the body frame, right_sole and left_sole are the foot frames. Not in it: reflected rotor inertia (the "
      "simulator\n"
      "adds it to the links; other programs call it armature), friction of the joints, payloads.\n"
      "Exit codes: 0, 64 usage, 65 bad scenario or poses, 69 the file cannot be written.\n"
      "Examples:\n"
      "  surefoot model --urdf elkahlout.urdf\n"
      "  surefoot model --set robot=khr2 --urdf -\n"
      "  surefoot model tools/scenarios/khr2_uneven.toml --json --extent=-1,2,-1,1\n"
      "  echo '[[0,0,-0.3,0.6,-0.3,0, 0,0,-0.3,0.6,-0.3,0]]' | surefoot model --poses -");
  command->callback([arguments, &result] { result = with_error_messages([&] { return show(*arguments); }); });
}

}  // namespace surefoot::cli
