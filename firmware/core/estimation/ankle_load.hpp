#pragma once

#include "firmware/core/sensor_snapshot.hpp"

namespace surefoot::estimation {

/// What a six-axis sensor in the ankle would read of normal force and two moments (Kim, Park, Oh 2007, Table 2: 1,000
/// N, 60 N m), formed from the four load cells of the sole. Foot frame: about the ankle's projection on the sole.
struct AnkleLoad {
  double normal_force_n = 0.0;   ///< compressive positive
  double roll_moment_nm = 0.0;   ///< of the floor on the foot about x: positive when the left edge carries
  double pitch_moment_nm = 0.0;  ///< of the floor on the foot about y: positive when the heel carries

  /// Pressure centre in the foot frame; 0 while the foot carries less than `kLeastForceN`.
  static constexpr double kLeastForceN = 49.0;  ///< 5 kgf
  [[nodiscard]] bool carries() const noexcept { return normal_force_n > kLeastForceN; }
  [[nodiscard]] double zmp_x_foot_m() const noexcept { return carries() ? -pitch_moment_nm / normal_force_n : 0.0; }
  [[nodiscard]] double zmp_y_foot_m() const noexcept { return carries() ? roll_moment_nm / normal_force_n : 0.0; }
};

/// Range of the paper's sensor.
struct AnkleSensorRange {
  double force_n = 1000.0;
  double moment_nm = 60.0;
};

/// Sums the four cells of one sole and clips to the sensor's range.
[[nodiscard]] AnkleLoad ankle_load(const geometry::RobotGeometry&, const FootSensors&,
                                   const AnkleSensorRange& = {}) noexcept;

}  // namespace surefoot::estimation
