// Where the time of one control tick goes: each stage alone and the whole closed loop, in one run.
// All figures are per tick of 1 ms; the world takes its default physics step.

#include <benchmark/benchmark.h>

#include "firmware/core/gait/stance.hpp"
#include "firmware/core/kinematics/leg_kinematics.hpp"
#include "firmware/host/firmware_node.hpp"
#include "firmware/host/memory_bus.hpp"
#include "sim_hw/simulated_robot.hpp"
#include "sim_hw/world/world.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot {
namespace {

constexpr int kTicksToWalking = 8000;

const scenario::Scenario& walk_scenario() {
  static const scenario::Scenario scenario = [] {
    const std::vector<std::string> overrides{"payload=[]"};
    return scenario::load_default(overrides);
  }();
  return scenario;
}

PerSide<LegVector> standing_angles() {
  const ControllerConfig& firmware = walk_scenario().firmware;
  const double reference_x_m = firmware.walk.reference_x_body_m;
  return kinematics::inverse(firmware.geometry, gait::stance(firmware.walk, {reference_x_m, reference_x_m})).angle_rad;
}

/// Firmware and robot on a memory bus, already walking.
struct ClosedLoop {
  ClosedLoop() {
    for (int i = 0; i < kTicksToWalking; ++i) cycle();
  }

  void cycle() {
    firmware.begin_tick(bus.controller_end());
    robot.serve(bus.robot_end());
    static_cast<void>(firmware.collect(bus.controller_end()));
    firmware.finish_tick(bus.controller_end());
    robot.serve(bus.robot_end());
  }

  host::MemoryBus bus;
  host::FirmwareNode firmware{walk_scenario().firmware};
  sim_hw::SimulatedRobot robot{walk_scenario().sim, standing_angles()};
};

void WholeClosedLoop(benchmark::State& state) {
  ClosedLoop loop;
  for (auto _ : state) loop.cycle();
  state.counters["x_real_time"] =
      benchmark::Counter(1e-3 * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK(WholeClosedLoop);

/// Bullet's multi-body alone, falling: what no contact, node, codec or controller can go below.
void BareBulletSteps(benchmark::State& state) {
  const sim_hw::SimConfig& config = walk_scenario().sim;
  sim_hw::RobotModel robot(config.geometry, config.mass, config.drive);
  robot.set_joints(standing_angles(), {});
  for (auto _ : state) {
    for (double t_s = 0.0; t_s < config.control_period_s - 1e-9; t_s += config.physics_step_s) {
      robot.integrate(config.physics_step_s);
    }
  }
}
BENCHMARK(BareBulletSteps)->Iterations(20000);

/// Bullet with corner contact and joint friction; the joints are driven to hold the standing pose.
void WorldSteps(benchmark::State& state) {
  const sim_hw::SimConfig& config = walk_scenario().sim;
  const servo::ServoConfig gains;
  sim_hw::World world(config, standing_angles());
  const PerSide<LegVector> wanted = standing_angles();
  PerSide<LegVector> torque_nm{};
  for (auto _ : state) {
    const PerSide<LegVector> angle = world.robot().angles_rad();
    const PerSide<LegVector> rate = world.robot().rates_rad_s();
    for (std::size_t side = 0; side < 2; ++side) {
      for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
        torque_nm[side][joint] = gains.gains[joint].kp_nm_per_rad * (wanted[side][joint] - angle[side][joint]) -
                                 gains.gains[joint].kd_nm_s_per_rad * rate[side][joint];
      }
    }
    for (double t_s = 0.0; t_s < config.control_period_s - 1e-9; t_s += config.physics_step_s) {
      world.advance(torque_nm, config.physics_step_s);
    }
  }
}
BENCHMARK(WorldSteps);

/// Decode, control, encode: the firmware's whole tick on frames that were recorded once.
void FirmwareTick(benchmark::State& state) {
  ClosedLoop loop;
  for (auto _ : state) {
    state.PauseTiming();
    loop.robot.serve(loop.bus.robot_end());
    state.ResumeTiming();
    loop.firmware.begin_tick(loop.bus.controller_end());
    state.PauseTiming();
    loop.robot.serve(loop.bus.robot_end());
    state.ResumeTiming();
    static_cast<void>(loop.firmware.collect(loop.bus.controller_end()));
    benchmark::DoNotOptimize(loop.firmware.finish_tick(loop.bus.controller_end()));
  }
}
BENCHMARK(FirmwareTick)->Iterations(20000);

/// The controller alone, on the snapshot of a walking robot.
void ControllerOnly(benchmark::State& state) {
  ClosedLoop loop;
  SensorSnapshot sensors = loop.firmware.snapshot();
  Controller controller(walk_scenario().firmware);
  for (auto _ : state) {
    ++sensors.tick;
    benchmark::DoNotOptimize(controller.tick(sensors));
  }
}
BENCHMARK(ControllerOnly);

}  // namespace
}  // namespace surefoot

BENCHMARK_MAIN();
