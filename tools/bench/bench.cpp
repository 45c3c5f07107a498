#include "tools/bench/bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <thread>

#include "tools/bench/firmware_stages.hpp"
#include "tools/bench/loop_stages.hpp"
#include "tools/bench/world_stages.hpp"
#include "tools/run/schedule.hpp"
#include "tools/table/experiment.hpp"
#include "tools/table/grid.hpp"

namespace surefoot::bench {
namespace {

GridEstimate grid_of(const scenario::Scenario& scenario, double tick_us) {
  const std::vector<table::Load> loads = table::loads_of(table::thesis_grid());
  GridEstimate grid;
  grid.cells = loads.size();
  grid.cores = std::max(1U, std::thread::hardware_concurrency());
  double last_s = 0.0;
  for (const table::Load& load : loads) last_s = std::max(last_s, load.at_s);
  grid.simulated_s =
      scenario.sim.time_zero_s + last_s + static_cast<double>(grid.cells) * table::seconds_to_judge(scenario);
  grid.wall_s = 1.0e-6 * tick_us * grid.simulated_s / scenario.firmware.period_s / grid.cores;
  return grid;
}

}  // namespace

Report measure(double seconds) {
  const std::vector<std::string> no_load{"payload=[]"};
  const scenario::Scenario scenario = run::scheduled(scenario::load_default(no_load));
  Report report;
  report.period_s = scenario.firmware.period_s;
  report.physics_step_s = scenario.sim.physics_step_s;
  report.bare_bullet_us = bare_bullet_us(scenario, 0.15 * seconds);
  report.tick_us = closed_loop_us(scenario, 0.35 * seconds);
  const double world = world_us(scenario, 0.15 * seconds);
  const LoopStages loop = loop_stages(scenario, 0.2 * seconds);
  const std::vector<Stage> firmware = firmware_stages(scenario.firmware, loop.sensors, 0.15 * seconds);

  report.stages = {{"world: articulated body (Bullet)", report.bare_bullet_us},
                   {"world: contact, joint drive", world - report.bare_bullet_us},
                   {"nodes: sensors, motors, codec, truth", loop.robot_us - world}};
  double control_us = 0.0;
  for (const Stage& stage : firmware) {
    report.stages.push_back(stage);
    control_us += stage.us;
  }
  report.stages.push_back({"firmware: codec, frames in and out", loop.firmware_us - control_us});
  report.stages.push_back({"bus accounting", loop.bus_watch_us});
  report.stages.push_back({"events, judge", loop.judge_us});
  double sum_us = 0.0;
  for (const Stage& stage : report.stages) sum_us += stage.us;
  report.stages.push_back({"the rest: loop, clocks, heap guard", report.tick_us - sum_us});
  report.grid = grid_of(scenario, report.tick_us);
  return report;
}

std::string to_text(const Report& report) {
  std::string text = fmt::format(
      "closed loop, one core   {:.0f} ticks/s   {:.1f} x real time   {:.2f} us a tick of {:g} ms, physics step {:g} "
      "ms\n"
      "\n  {:<38} {:>8}  {:>6}\n",
      report.ticks_per_s(), report.real_time_factor(), report.tick_us, 1e3 * report.period_s,
      1e3 * report.physics_step_s, "stage", "us/tick", "share");
  for (const Stage& stage : report.stages) {
    text += fmt::format("  {:<38} {:>8.3f} {:>5.1f} %\n", stage.name, stage.us, 100.0 * stage.us / report.tick_us);
  }
  text += fmt::format(
      "\nbare btMultiBody {:.2f} us a tick: the closed loop takes {:.2f} times that\n"
      "{} cells, nobody falls ({:.0f} s simulated): about {:.0f} s on {} core{}\n",
      report.bare_bullet_us, report.tick_us / report.bare_bullet_us, report.grid.cells, report.grid.simulated_s,
      report.grid.wall_s, report.grid.cores, report.grid.cores == 1 ? "" : "s");
  return text;
}

std::string to_json(const Report& report) {
  nlohmann::ordered_json stages = nlohmann::ordered_json::array();
  for (const Stage& stage : report.stages) {
    stages.push_back({{"name", stage.name}, {"us", stage.us}, {"share", stage.us / report.tick_us}});
  }
  const nlohmann::ordered_json json{{"ticks_per_s", report.ticks_per_s()},
                                    {"real_time_factor", report.real_time_factor()},
                                    {"tick_us", report.tick_us},
                                    {"period_s", report.period_s},
                                    {"physics_step_s", report.physics_step_s},
                                    {"stages", stages},
                                    {"bare_bullet_us", report.bare_bullet_us},
                                    {"ratio_to_bare_bullet", report.tick_us / report.bare_bullet_us},
                                    {"grid",
                                     {{"cells", report.grid.cells},
                                      {"simulated_s", report.grid.simulated_s},
                                      {"cores", report.grid.cores},
                                      {"wall_s", report.grid.wall_s}}}};
  return json.dump(2) + "\n";
}

}  // namespace surefoot::bench
