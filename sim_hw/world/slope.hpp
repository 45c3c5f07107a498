#pragma once

#include <cmath>
#include <numbers>

#include "sim_hw/plant_config.hpp"
#include "sim_hw/world/bullet_math.hpp"

namespace surefoot::sim_hw {

/// Gravity in the floor's frame: straight down on a level floor, to the bit; else its reaction is the last row of
/// rotation_level_from_floor = Ry(pitch) Rx(roll).
[[nodiscard]] inline geometry::Vector3 gravity_floor_m_s2(const ContactConfig& floor) noexcept {
  if (floor.slope_pitch_deg == 0.0 && floor.slope_roll_deg == 0.0) return {0.0, 0.0, -kGravityM_S2};
  const double pitch = floor.slope_pitch_deg * std::numbers::pi / 180.0;
  const double roll = floor.slope_roll_deg * std::numbers::pi / 180.0;
  return {kGravityM_S2 * std::sin(pitch), -kGravityM_S2 * std::cos(pitch) * std::sin(roll),
          -kGravityM_S2 * std::cos(pitch) * std::cos(roll)};
}

}  // namespace surefoot::sim_hw
