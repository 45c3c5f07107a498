#include "sim_hw/nodes/position_servo.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot::sim_hw {

PositionServo::PositionServo(const SimConfig& config) noexcept
    : stiffness_nm_per_rad_(config.drive.servo_stiffness_nm_per_rad),
      damping_nm_s_per_rad_(config.drive.servo_damping_nm_s_per_rad),
      period_s_(config.control_period_s),
      steps_per_period_(
          static_cast<std::uint64_t>(std::max(std::llround(config.control_period_s / config.physics_step_s), 1LL))) {}

void PositionServo::aim(const LegVector& wanted_rad, const LegVector& angle_rad) noexcept {
  for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
    from_rad_[joint] = is_running_ ? reference_rad(joint) : angle_rad[joint];
  }
  wanted_rad_ = wanted_rad;
  steps_done_ = 0;
  is_running_ = true;
}

LegVector PositionServo::step(const LegVector& angle_rad, const LegVector& rate_rad_s) noexcept {
  const bool is_under_way = steps_done_ < steps_per_period_;
  LegVector torque_nm;
  for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
    const double reference_rate_rad_s = is_under_way ? (wanted_rad_[joint] - from_rad_[joint]) / period_s_ : 0.0;
    torque_nm[joint] = stiffness_nm_per_rad_[joint] * (reference_rad(joint) - angle_rad[joint]) +
                       damping_nm_s_per_rad_[joint] * (reference_rate_rad_s - rate_rad_s[joint]);
  }
  if (is_under_way) ++steps_done_;
  return torque_nm;
}

double PositionServo::reference_rad(std::size_t joint) const noexcept {
  if (steps_done_ == steps_per_period_) return wanted_rad_[joint];  // exactly, whatever the division rounds to
  const double share = static_cast<double>(steps_done_) / static_cast<double>(steps_per_period_);
  return from_rad_[joint] + share * (wanted_rad_[joint] - from_rad_[joint]);
}

}  // namespace surefoot::sim_hw
