#pragma once

#include "sim_hw/plant_config.hpp"

namespace surefoot::sim_hw {

/// The hip roll drive of one leg with a flexible transmission: the rotor, reflected to the joint, turns on its own
/// behind a spring and a damper. Its encoder and its viscous friction sit at the motor.
///
///   J w' = motor torque - friction w - s,   s = k (angle - joint angle) + c (w - joint rate)
///
/// A geared rotor turns with the joint, not with the body: the trunk feels the reaction to s.
class HipSpring {
 public:
  /// @param joint_angle_rad  the spring is relaxed at the start
  HipSpring(const DriveConfig&, double joint_angle_rad) noexcept;

  [[nodiscard]] static bool is_flexible(const DriveConfig& drive) noexcept {
    return drive.hip_roll_stiffness_nm_per_rad > 0.0;
  }

  /// One step of the rotor: symplectic Euler, implicit in both dampers, so that no damping makes it unstable.
  /// @return s, which drives the joint during this step
  [[nodiscard]] double step(double motor_torque_nm, double joint_angle_rad, double joint_rate_rad_s,
                            double step_s) noexcept;

  [[nodiscard]] double angle_rad() const noexcept { return angle_rad_; }
  [[nodiscard]] double rate_rad_s() const noexcept { return rate_rad_s_; }

 private:
  double inertia_kg_m2_;
  double friction_nm_s_per_rad_;
  double stiffness_nm_per_rad_;
  double damping_nm_s_per_rad_;
  double angle_rad_;
  double rate_rad_s_ = 0.0;
};

}  // namespace surefoot::sim_hw
