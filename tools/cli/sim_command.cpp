#include <fmt/format.h>

#include <memory>

#include "firmware/host/realtime/realtime_rights.hpp"
#include "tools/cli/bus_options.hpp"
#include "tools/cli/commands.hpp"
#include "tools/run/robot_service.hpp"
#include "tools/run/run_folder.hpp"

namespace surefoot::cli {
namespace {

void say(const std::string& message) { fmt::print(stderr, "sim: {}\n", message); }

run::ExitCode serve(const BusProcessArguments& arguments) {
  const scenario::Scenario scenario = load_scenario(arguments);
  if (!arguments.folder.empty() && !arguments.overwrites) run::refuse_earlier_run(arguments.folder);
  const auto bus = host::open_bus(arguments.bus, host::BusRole::kRobot);
  hear_stop_signals();
  host::RealtimeRequest rights;
  rights.fifo_priority = arguments.fifo_priority;
  rights.cpu = arguments.cpu;
  rights.memory = {.lock_all = false, .stack_prefault_bytes = 0};  // locking all memory and Bullet do not go together
  std::optional<host::RealtimeRights> realtime;
  if (arguments.fifo_priority > 0 || arguments.cpu >= 0) {
    realtime.emplace(rights);
    if (!realtime->missing().empty()) say(host::to_text(realtime->missing()));
  }

  run::RobotServiceOptions options;
  options.clock = arguments.is_lockstep() ? sim_hw::WorldClock::kLockstep : sim_hw::WorldClock::kFreeRunning;
  options.folder = arguments.folder;
  options.is_live = arguments.is_live;
  options.ends_with_master = arguments.ends_with_run;
  options.stop = &stop_requested();
  options.on_message = say;
  const run::RobotServiceReport report = run::serve_robot(scenario, *bus, options);
  if (arguments.is_json) {
    fmt::print("{}", run::to_json(report));
  } else {
    fmt::print("  robot        driven by {} master(s), fell {} time(s); {} periods at {:.2f} x real time\n",
               report.masters, report.falls, report.periods, report.real_time_factor);
  }
  return run::ExitCode::kVerdictHolds;
}

}  // namespace

void add_sim(CLI::App& app, run::ExitCode& result) {
  auto arguments = std::make_shared<BusProcessArguments>();
  CLI::App* command = app.add_subcommand("sim", "The simulated robot as a service: five nodes on a CAN bus.");
  add_bus_process_options(*command, *arguments);
  command->add_flag("--once", arguments->ends_with_run, "End when the first master is gone or the robot has fallen");
  command->footer(
      "Whoever speaks firmware/can/surefoot.dbc may drive it: `surefoot firmware`, or a few lines of Python\n"
      "(examples/). The world stands still until the first SYNC. When the master falls silent the leg boards\n"
      "damp, and after that the robot is put back on its feet for the next one.\n"
      "Exit codes: 0 stopped as asked, 64 usage, 65 bad scenario or address, 69 the machine lacks something.\n"
      "Examples:\n"
      "  tools/with-vcan sh -c 'tools/surefoot sim --bus socketcan:vcan0 & tools/surefoot firmware --bus "
      "socketcan:vcan0'\n"
      "  surefoot sim --bus socketcan:vcan0 --clock wall --priority 70\n"
      "  surefoot sim --bus udp                              # no CAN in this kernel: python-can joins over loopback");
  command->callback([arguments, &result] { result = with_error_messages([&] { return serve(*arguments); }); });
}

}  // namespace surefoot::cli
