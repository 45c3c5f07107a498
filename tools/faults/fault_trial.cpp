#include "tools/faults/fault_trial.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "firmware/host/firmware_node.hpp"
#include "firmware/host/memory_bus.hpp"
#include "sim_hw/simulated_robot.hpp"
#include "tools/faults/command_watch.hpp"
#include "tools/run/schedule.hpp"
#include "tools/run/standing_pose.hpp"

namespace surefoot::faults {
namespace {

constexpr double kLoadAt_s = 1.2;

/// On the scenario's clock.
double instant_s(Situation situation, double time_zero_s) {
  switch (situation) {
    case Situation::kStanding:
      return 1.5 - time_zero_s;
    case Situation::kWalking:
      return 2.0;
    case Situation::kReflex:
      return kLoadAt_s + 0.12;  // the reflex begins some 0.08 s after the load and lasts 0.1 s
  }
  return 0.0;
}

}  // namespace

const char* name(Situation situation) noexcept {
  switch (situation) {
    case Situation::kStanding:
      return "standing";
    case Situation::kWalking:
      return "walking";
    case Situation::kReflex:
      return "reflex";
  }
  return "unknown";
}

TrialResult try_fault(scenario::Scenario scenario, Situation situation, sim_hw::FaultConfig fault) {
  scenario = run::scheduled(std::move(scenario));
  const double period_s = scenario.firmware.period_s;
  const double time_zero_s = scenario.sim.time_zero_s;
  fault.at_s = instant_s(situation, time_zero_s);
  scenario.sim.payloads.clear();
  if (situation == Situation::kReflex) scenario.sim.payloads.push_back({.mass_kg = 5.0, .at_s = kLoadAt_s});
  scenario.sim.faults = {fault};
  const auto first_tick = std::llround((fault.at_s + time_zero_s) / period_s);
  const bool is_for_good = fault.kind == sim_hw::FaultKind::kDeadNode;
  const auto ticks = first_tick + std::llround((kWatch_s + (is_for_good ? 0.0 : fault.for_s)) / period_s);

  host::MemoryBus bus;
  host::FirmwareNode firmware(scenario.firmware);
  sim_hw::SimulatedRobot robot(scenario.sim, run::standing_pose(scenario.firmware));
  CommandWatch commands(scenario.firmware.gate, period_s);
  TrialResult result;
  result.lowest_body_m = robot.truth().body_position_world_m[2];
  for (std::int64_t tick = 0; tick < ticks; ++tick) {
    firmware.begin_tick(bus.controller_end());
    robot.serve(bus.robot_end());
    static_cast<void>(firmware.collect(bus.controller_end()));
    const TickOutput& output = firmware.finish_tick(bus.controller_end());
    robot.serve(bus.robot_end());
    commands.observe(output.command, firmware.snapshot().leg);
    if (output.fault != safety::Fault::kNone && !result.answer_ticks) result.answer_ticks = tick - first_tick;
    if (robot.truth().has_fallen && !result.fell_after_s) {
      result.fell_after_s = static_cast<double>(tick - first_tick) * period_s;
    }
    result.lowest_body_m = std::min(result.lowest_body_m, robot.truth().body_position_world_m[2]);
    result.fault = output.fault;
    result.safe_state = output.safe_state;
  }
  result.command = commands.extremes();
  return result;
}

}  // namespace surefoot::faults
