#pragma once

#include <cstddef>
#include <cstdint>

#include "firmware/core/gait/planned_stride.hpp"
#include "firmware/core/geometry/robot_geometry.hpp"

namespace surefoot::scenario {

/// One [[planned_gait]] table: angles in degrees, lengths of the sole left to the robot.
struct PlannedGaitConfig {
  std::uint32_t steps = 0;
  planning::WalkingPattern pattern = planning::WalkingPattern::kFlatFeet;
  planning::ComMethod com_method = planning::ComMethod::kSharedPressure;
  bool lands_hard = false;
  planning::GaitFactors gait{.com_height_m = 0.57,
                             .step_length_m = 0.15,
                             .single_support_share = 0.614434,
                             .single_support_s = 1.0,
                             .double_support_s = 0.25};
  double toe_angle_deg = 0.0;
  double heel_angle_deg = 0.0;
  double top_share = 0.5;
  double top_x_m = 0.0;
  double top_z_m = 0.05;
};

/// Most gaits one run takes.
inline constexpr std::size_t kMaxPlannedGaits = gait::kMostPlannedGaits;

/// As the firmware takes it.
[[nodiscard]] gait::PlannedGait planned_gait(const PlannedGaitConfig&, const geometry::RobotGeometry&);

}  // namespace surefoot::scenario
