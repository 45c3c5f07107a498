#pragma once

#include "tests/unit/sim_hw/standing.hpp"
#include "tests/unit/sim_hw/wire.hpp"

namespace surefoot::sim_hw::testing {

/// A robot on its wire, held standing by a PD on what its frames say.
struct HeldRobot {
  explicit HeldRobot(const SimConfig& config) : pose(stance(config.geometry)), robot(config, pose), puppeteer(robot) {}

  [[nodiscard]] PerSide<LegVector> wanted() const {
    const PerSide<LegVector> angle{puppeteer.leg[0].angle_rad, puppeteer.leg[1].angle_rad};
    const PerSide<LegVector> rate{puppeteer.leg[0].rate_rad_s, puppeteer.leg[1].rate_rad_s};
    return hold(pose, angle, rate);
  }

  void tick() {
    puppeteer.sync();
    puppeteer.command(wanted());
  }

  void stand(double duration_s) {
    for (double t = 0.0; t < duration_s; t += 1.0e-3) tick();
  }

  PerSide<LegVector> pose;
  SimulatedRobot robot;
  Puppeteer puppeteer;
};

}  // namespace surefoot::sim_hw::testing
