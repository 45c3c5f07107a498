#include "tools/floor/nominal_recorder.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "firmware/host/firmware_node.hpp"
#include "firmware/host/memory_bus.hpp"
#include "sim_hw/simulated_robot.hpp"
#include "tools/run/schedule.hpp"
#include "tools/run/standing_pose.hpp"

namespace surefoot::floor {
namespace {

using stabilizer::NominalTable;
using stabilizer::PhaseSample;

constexpr int kStepsBefore = 20;  // of the walk's own transient
constexpr int kSteps = 20;

scenario::Scenario flat_walk(double step_length_m, const std::vector<std::string>& more) {
  std::vector<std::string> overrides{"robot=khr2", "stabilizer.set=off",
                                     fmt::format("pattern.step_length_m={}", step_length_m), "payload=[]",
                                     "pattern.standing_s=2"};
  overrides.insert(overrides.end(), more.begin(), more.end());
  return run::scheduled(scenario::load_default(overrides));
}

/// Running mean.
struct Mean {
  PhaseSample sample{};
  int count = 0;

  void add(const PhaseSample& value) noexcept {
    ++count;
    sample = stabilizer::between(sample, value, 1.0 / count);
  }
};

}  // namespace

NominalTable record_nominal(double step_length_m, const std::vector<std::string>& overrides) {
  const scenario::Scenario scenario = flat_walk(step_length_m, overrides);
  host::MemoryBus bus;
  host::FirmwareNode firmware(scenario.firmware);
  sim_hw::SimulatedRobot robot(scenario.sim, run::standing_pose(scenario.firmware));
  std::array<Mean, NominalTable::kPlaces> mean{};
  int steps = 0;
  while (steps < kStepsBefore + kSteps) {
    firmware.begin_tick(bus.controller_end());
    robot.serve(bus.robot_end());
    static_cast<void>(firmware.collect(bus.controller_end()));
    const stabilizer::StabilizerInput& input = firmware.finish_tick(bus.controller_end()).floor.input;
    robot.serve(bus.robot_end());
    if (robot.truth().has_fallen) throw std::runtime_error("the robot fell on a flat floor: there is no nominal walk");
    steps += input.walk.begins_step ? 1 : 0;
    if (steps < kStepsBefore || input.walk.stage == decision::WalkStage::kStanding) continue;
    Side stepping = input.walk.is_double_support ? opposite(input.walk.moving) : input.walk.moving;
    auto place = static_cast<std::size_t>(std::lround(input.walk.step_share * NominalTable::kPlaces));
    if (place == NominalTable::kPlaces) continue;  // the end of a step: its load is on both feet already
    mean[place].add(stepping == Side::kLeft ? input.measured : stabilizer::mirrored(input.measured));
  }
  NominalTable table;
  for (std::size_t i = 0; i < table.of_left_step.size(); ++i) table.of_left_step[i] = mean[i].sample;
  return table;
}

std::string to_source(const NominalTable& table) {
  std::string text;
  for (const PhaseSample& sample : table.of_left_step) {
    text +=
        fmt::format("PhaseSample{{{:.5f}, {:.5f}, {:.4f}, {:.4f}, {:.5f}, {:.5f}, {:.4f}}},\n", sample.torso_roll_rad,
                    sample.torso_pitch_rad, sample.torso_roll_rate_rad_s, sample.torso_pitch_rate_rad_s,
                    sample.zmp_x_foot_m, sample.zmp_y_foot_m, sample.support_roll_rate_rad_s);
  }
  return text;
}

}  // namespace surefoot::floor
