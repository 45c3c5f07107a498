#include "firmware/core/kinematics/leg_rates.hpp"

#include <cmath>

#include "firmware/core/kinematics/leg_kinematics.hpp"

namespace surefoot::kinematics {
namespace {

using geometry::Vector3;

/// Sine below which a pivot of the Jacobian is damped, 2.9 degrees.
constexpr double kDampedSine = 0.05;

/// a / b for |b| >= smallest; below it damped least squares with lambda^2 = smallest^2 - b^2
/// (Nakamura, Hanafusa 1986), which is continuous and bounded by |a| / smallest.
double damped_quotient(double a, double b, double smallest) noexcept {
  return std::abs(b) >= smallest ? a / b : a * b / (smallest * smallest);
}

}  // namespace

LegVector rates_without_rotation(const geometry::RobotGeometry& geometry, const LegTurns& leg,
                                 const Vector3& velocity_body_m_s) noexcept {
  const Vector3 velocity =
      about_y(leg.pitch.reversed(), about_x(leg.roll.reversed(), about_z(leg.yaw.reversed(), velocity_body_m_s)));
  const double calf_x = -geometry.calf_m * leg.knee.sin;
  const double calf_z = -geometry.calf_m * leg.knee.cos;
  const double ankle_x = calf_x;
  const double ankle_z = calf_z - geometry.thigh_m;
  const double reach = geometry.thigh_m + geometry.calf_m;
  const double segments = geometry.thigh_m * geometry.calf_m;

  // Along hip-ankle only the knee acts; across it, in the leg's plane, knee and hip; out of it the rolls.
  const double knee = damped_quotient(-(ankle_x * velocity.x() + ankle_z * velocity.z()), segments * leg.knee.sin,
                                      segments * kDampedSine);
  const double swing = ankle_z * velocity.x() - ankle_x * velocity.z() - knee * (ankle_x * calf_x + ankle_z * calf_z);
  const double shortest = reach * kDampedSine;
  const double thigh_y = damped_quotient(swing, ankle_x * ankle_x + ankle_z * ankle_z, shortest * shortest);
  const double ankle_roll =
      damped_quotient(velocity.y(), leg.pitch_from_thigh.sin * ankle_x + leg.pitch_from_thigh.cos * ankle_z, shortest);

  const Vector3 thigh_rate =
      about_y(leg.pitch, {-leg.pitch_from_thigh.cos * ankle_roll, thigh_y, leg.pitch_from_thigh.sin * ankle_roll});
  const double yaw = damped_quotient(thigh_rate.z(), leg.roll.cos, kDampedSine);
  return {yaw, thigh_rate.x(), thigh_y - yaw * leg.roll.sin, knee, -(thigh_y + knee), ankle_roll};
}

LegVector inverse_rates(const geometry::RobotGeometry& geometry, const LegVector& angle_rad,
                        const Vector3& velocity_body_m_s) noexcept {
  const double knee_rad = angle_rad[index(LegJoint::kKneePitch)];
  return rates_without_rotation(
      geometry,
      {Turn::of(angle_rad[index(LegJoint::kHipYaw)]), Turn::of(angle_rad[index(LegJoint::kHipRoll)]),
       Turn::of(angle_rad[index(LegJoint::kHipPitch)]), Turn::of(knee_rad),
       Turn::of(knee_rad + angle_rad[index(LegJoint::kAnklePitch)])},
      velocity_body_m_s);
}

}  // namespace surefoot::kinematics
