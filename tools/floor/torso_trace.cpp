#include "tools/floor/torso_trace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "firmware/host/firmware_node.hpp"
#include "firmware/host/memory_bus.hpp"
#include "sim_hw/inclination.hpp"
#include "sim_hw/simulated_robot.hpp"
#include "tools/run/schedule.hpp"
#include "tools/run/standing_pose.hpp"
#include "tools/table/experiment.hpp"

namespace surefoot::floor {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;
constexpr double kSample_s = 0.02;

double largest(const std::vector<double>& values) {
  double magnitude = 0.0;
  for (const double value : values) magnitude = std::max(magnitude, std::abs(value));
  return magnitude;
}

}  // namespace

TorsoTrace trace_of(const scenario::Scenario& given) {
  const scenario::Scenario scenario = run::scheduled(given);
  const run::Schedule schedule = run::schedule_of(scenario);
  const auto every = std::max<std::int64_t>(std::llround(kSample_s / scenario.firmware.period_s), 1);
  host::MemoryBus bus;
  host::FirmwareNode firmware(scenario.firmware);
  sim_hw::SimulatedRobot robot(scenario.sim, run::standing_pose(scenario.firmware));
  TorsoTrace trace;
  for (std::int64_t tick = 0; tick < schedule.ticks && !trace.has_fallen; ++tick) {
    firmware.begin_tick(bus.controller_end());
    robot.serve(bus.robot_end());
    static_cast<void>(firmware.collect(bus.controller_end()));
    static_cast<void>(firmware.finish_tick(bus.controller_end()));
    robot.serve(bus.robot_end());
    trace.has_fallen = robot.truth().has_fallen;
    const std::int64_t scored = tick - schedule.zero_tick;
    if (scored < 0 || scored % every != 0) continue;
    const sim_hw::Inclination torso = sim_hw::inclination(robot.truth(), scenario.sim.contact);
    trace.time_s.push_back(static_cast<double>(scored) * scenario.firmware.period_s);
    trace.roll_deg.push_back(torso.roll_rad * kDegreesPerRadian);
    trace.pitch_deg.push_back(torso.pitch_rad * kDegreesPerRadian);
  }
  return trace;
}

std::vector<TracedWalk> traced_walks(const FloorTableSpec& spec) {
  std::vector<TracedWalk> walks;
  for (const std::string& set : spec.sets) {
    for (const FloorCase floor : kFloorCases) {
      if (floor != FloorCase::kRoom) walks.push_back({set, floor, slope_of(floor, spec.slope_under(set)), {}});
    }
  }
  return walks;
}

scenario::Scenario scenario_of(const TracedWalk& walk, const FloorTableSpec& spec, const batch::Batch& base) {
  batch::Batch alone = base;
  const std::vector<std::string> floor = overrides_of(walk.floor, walk.slope_deg, spec.seeds.at(0), spec.duration_s);
  alone.common.insert(alone.common.end(), floor.begin(), floor.end());
  alone.common.push_back("stabilizer.set=" + walk.set);
  return table::load_common(alone);
}

std::string trace_text(const std::vector<TracedWalk>& walks) {
  std::string text = "largest angles of the torso against the vertical until the end or the fall, degrees\n";
  for (const TracedWalk& walk : walks) {
    const TorsoTrace& trace = walk.trace;
    text += fmt::format("  {:<9}  {:<6}  slope {:g}  roll {:5.2f}  pitch {:5.2f}{}\n", walk.set, name(walk.floor),
                        walk.slope_deg, largest(trace.roll_deg), largest(trace.pitch_deg),
                        trace.has_fallen ? "  falls" : "");
  }
  return text;
}

std::string trace_csv(const std::vector<TracedWalk>& walks) {
  std::string text = "controllers,floor,slope_deg,time_s,roll_deg,pitch_deg\n";
  for (const TracedWalk& walk : walks) {
    for (std::size_t i = 0; i < walk.trace.time_s.size(); ++i) {
      text += fmt::format("{},{},{},{:.3f},{:.4f},{:.4f}\n", walk.set, name(walk.floor), walk.slope_deg,
                          walk.trace.time_s[i], walk.trace.roll_deg[i], walk.trace.pitch_deg[i]);
    }
  }
  return text;
}

std::string to_json(const std::vector<TracedWalk>& walks, const FloorTableSpec& spec) {
  Json lines = Json::array();
  for (const TracedWalk& walk : walks) {
    lines.push_back({{"controllers", walk.set},
                     {"floor", name(walk.floor)},
                     {"slope_deg", walk.slope_deg},
                     {"falls", walk.trace.has_fallen},
                     {"time_s", walk.trace.time_s},
                     {"roll_deg", walk.trace.roll_deg},
                     {"pitch_deg", walk.trace.pitch_deg}});
  }
  return Json{
             {"picture", "floor_traces"}, {"seed", spec.seeds.at(0)}, {"duration_s", spec.duration_s}, {"walks", lines}}
             .dump() +
         "\n";
}

}  // namespace surefoot::floor
