#include "tools/run/shared_past.hpp"

#include <algorithm>
#include <cmath>

#include "sim_hw/simulated_robot.hpp"
#include "tools/run/schedule.hpp"

namespace surefoot::run {

std::string past_key(scenario::Scenario scenario) {
  if (!sim_hw::SimulatedRobot::can_branch(scenario.sim)) return "";
  const scenario::Scenario any;
  scenario = undisturbed(std::move(scenario));
  scenario.duration_s = any.duration_s;
  scenario.limits = any.limits;
  return scenario::to_toml(scenario);
}

std::int64_t undisturbed_ticks(const scenario::Scenario& scenario) noexcept {
  double first_s = sim_hw::kNever_s;
  for (const sim_hw::PayloadConfig& payload : scenario.sim.payloads) first_s = std::min(first_s, payload.at_s);
  for (const sim_hw::PushConfig& push : scenario.sim.pushes) first_s = std::min(first_s, push.at_s);
  const Schedule schedule = schedule_of(scenario);
  const auto all = static_cast<double>(schedule.ticks);
  const double ticks = std::floor(first_s / scenario.firmware.period_s) + static_cast<double>(schedule.zero_tick) - 1.0;
  return static_cast<std::int64_t>(std::clamp(ticks, 0.0, all));
}

scenario::Scenario undisturbed(scenario::Scenario scenario) {
  scenario.sim.payloads.clear();
  scenario.sim.pushes.clear();
  return scenario;
}

}  // namespace surefoot::run
