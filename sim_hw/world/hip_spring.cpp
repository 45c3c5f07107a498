#include "sim_hw/world/hip_spring.hpp"

namespace surefoot::sim_hw {

HipSpring::HipSpring(const DriveConfig& drive, double joint_angle_rad) noexcept
    : inertia_kg_m2_(drive.rotor_share[index(LegJoint::kHipRoll)] * drive.rotor_inertia_kg_m2),
      friction_nm_s_per_rad_(drive.hip_knee_friction_nm_s_per_rad),
      stiffness_nm_per_rad_(drive.hip_roll_stiffness_nm_per_rad),
      damping_nm_s_per_rad_(drive.hip_roll_damping_nm_s_per_rad),
      angle_rad_(joint_angle_rad) {}

double HipSpring::step(double motor_torque_nm, double joint_angle_rad, double joint_rate_rad_s,
                       double step_s) noexcept {
  const double elastic_nm = stiffness_nm_per_rad_ * (angle_rad_ - joint_angle_rad);
  const double impulse_nm_s = step_s * (motor_torque_nm - elastic_nm + damping_nm_s_per_rad_ * joint_rate_rad_s);
  rate_rad_s_ = (inertia_kg_m2_ * rate_rad_s_ + impulse_nm_s) /
                (inertia_kg_m2_ + step_s * (friction_nm_s_per_rad_ + damping_nm_s_per_rad_));
  angle_rad_ += step_s * rate_rad_s_;
  return elastic_nm + damping_nm_s_per_rad_ * (rate_rad_s_ - joint_rate_rad_s);
}

}  // namespace surefoot::sim_hw
