#include "tools/bench/world_stages.hpp"

#include <cmath>
#include <optional>

#include "sim_hw/world/world.hpp"
#include "tools/bench/stopwatch.hpp"
#include "tools/run/standing_pose.hpp"

namespace surefoot::bench {
namespace {

constexpr int kTicksOfFall = 1000;  // before the next fall begins: speeds stay those of a robot

int steps_per_tick(const sim_hw::SimConfig& sim) {
  return static_cast<int>(std::lround(sim.control_period_s / sim.physics_step_s));
}

}  // namespace

double bare_bullet_us(const scenario::Scenario& scenario, double seconds) {
  const sim_hw::SimConfig& sim = scenario.sim;
  sim_hw::RobotModel standing(sim.geometry, sim.mass, sim.drive);
  standing.set_joints(run::standing_pose(scenario.firmware), {});
  std::optional<sim_hw::RobotModel> robot;
  int ticks = 0;
  const int steps = steps_per_tick(sim);
  return least_us_per_call(seconds, [&] {
    if (ticks++ % kTicksOfFall == 0) robot.emplace(standing);
    for (int step = 0; step < steps; ++step) robot->integrate(sim.physics_step_s);
  });
}

double world_us(const scenario::Scenario& scenario, double seconds) {
  const sim_hw::SimConfig& sim = scenario.sim;
  const servo::ServoConfig& servo = scenario.firmware.servo;
  const PerSide<LegVector> wanted = run::standing_pose(scenario.firmware);
  sim_hw::World world(sim, wanted);
  const int steps = steps_per_tick(sim);
  return least_us_per_call(seconds, [&] {
    const PerSide<LegVector> angle = world.robot().angles_rad();
    const PerSide<LegVector> rate = world.robot().rates_rad_s();
    PerSide<LegVector> torque_nm{};
    for (const Side side : kSides) {
      for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
        const servo::JointGains& gains = servo.gains[joint];
        torque_nm[index(side)][joint] = gains.kp_nm_per_rad * (wanted[index(side)][joint] - angle[index(side)][joint]) -
                                        gains.kd_nm_s_per_rad * rate[index(side)][joint];
      }
    }
    for (int step = 0; step < steps; ++step) world.advance(torque_nm, sim.physics_step_s);
  });
}

}  // namespace surefoot::bench
