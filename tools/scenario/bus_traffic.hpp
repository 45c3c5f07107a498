#pragma once

#include "sim_hw/bus/traffic.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::scenario {

/// What crosses the bus of this scenario's robot in a healthy tick.
[[nodiscard]] inline sim_hw::TrafficOptions bus_traffic(const Scenario& scenario) noexcept {
  return {.has_inertial_legs = scenario.sim.sensor.has_inertial_legs,
          .commands_angles = scenario.firmware.method == WalkMethod::kFloorWalk};
}

}  // namespace surefoot::scenario
