#pragma once

#include "firmware/core/geometry/robot_geometry.hpp"
#include "firmware/core/sensor_snapshot.hpp"

namespace surefoot::estimation {

/// Filters as time constants, so that another tick rate keeps the same filter.
/// Source: El-Kahlout 2003, (3.7) with lambda 5e-3 and (3.18) with 5e-4, both at 0.5 ms.
struct EstimatorConfig {
  double force_time_constant_s = 0.09975;
  double zmp_time_constant_s = 0.99975;
  double min_force_for_zmp_n = 50.0;  ///< below it the ZMP keeps its last value: nobody stands
};

/// Everything that lives between two ticks.
struct EstimatorState {
  double filtered_force_n = 0.0;
  double zmp_x_body_m = 0.0;
  double zmp_y_body_m = 0.0;
  double filtered_zmp_x_body_m = 0.0;
  double filtered_zmp_y_body_m = 0.0;
  double roll_rate_rad_s = 0.0;
  double pitch_rate_rad_s = 0.0;
  double mean_pitch_rate_rad_s = 0.0;  ///< through the force filter's time constant
  bool has_pitch_rate = false;
  bool has_force = false;          ///< first valid force seen; the force filter starts there, not at zero
  bool has_zmp = false;            ///< first valid ZMP seen
  bool is_zmp_within_feet = true;  ///< judged when the ZMP last moved
  double factor_period_s = 0.0;    ///< period that the two factors below were computed for
  double force_factor = 0.0;       ///< lambda of (3.7): 1 - exp(-period / time constant)
  double zmp_factor = 0.0;         ///< lambda of (3.18)
};

/// What the sensors say about the robot as a whole.
struct Estimate {
  double vertical_force_n = 0.0;  ///< fs: sum of the eight corner forces
  double filtered_force_n = 0.0;  ///< (3.7)
  double zmp_x_body_m = 0.0;      ///< from the eight corner forces at the measured joint angles
  double zmp_y_body_m = 0.0;
  double filtered_zmp_x_body_m = 0.0;  ///< (3.18) with the raw ZMP in its last term
  double filtered_zmp_y_body_m = 0.0;  ///< the same for y
  double roll_rate_rad_s = 0.0;        ///< gyro's x
  double pitch_rate_rad_s = 0.0;       ///< gyro's y, forward positive
  double pitch_rate_rise_rad_s = 0.0;  ///< gyro's y less its mean: how the body has begun to tip, forward positive
  bool is_zmp_within_feet = true;      ///< filtered ZMP between the rearmost heel and the foremost toe: it must be
  PerSide<double> foot_force_n{};
};

/// One tick of estimation. Non-finite inputs cannot occur: the codec refuses them.
///
/// The forces are those of the snapshot, which keeps a silent node's last values. Filters and ZMP
/// move only on values of this tick (both feet, for the ZMP both legs too); otherwise they hold.
///
/// @param period_s  time since the last call, > 0
[[nodiscard]] Estimate step(const EstimatorConfig&, const geometry::RobotGeometry&, EstimatorState&,
                            const SensorSnapshot&, double period_s) noexcept;

}  // namespace surefoot::estimation
