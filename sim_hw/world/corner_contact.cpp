#include "sim_hw/world/corner_contact.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot::sim_hw {

CornerContact::CornerContact(const geometry::RobotGeometry& geometry, const ContactConfig& config) noexcept
    : config_(config) {
  for (std::size_t i = 0; i < geometry::kCornersPerFoot; ++i) {
    corner_foot_m_[i] = to_bullet(geometry.corner_foot_m(static_cast<geometry::Corner>(i)));
  }
}

SoleWrench CornerContact::step(const BodyMotion& foot) noexcept {
  SoleWrench wrench;
  for (std::size_t i = 0; i < geometry::kCornersPerFoot; ++i) {
    Anchor& anchor = anchor_[i];
    const btVector3 arm = foot.rotation_world_from_body * corner_foot_m_[i];
    const btVector3 position = foot.position_m + arm;
    if (position.z() >= 0.0) {
      anchor.touches = false;
      continue;
    }
    const btVector3 velocity = foot.velocity_m_s + foot.angular_rad_s.cross(arm);
    const double normal = std::max(
        0.0, -config_.normal_stiffness_n_per_m * position.z() - config_.normal_damping_n_s_per_m * velocity.z());
    if (!anchor.touches) anchor = {position.x(), position.y(), true};

    const double limit = config_.friction * normal;
    double spring_x = -config_.tangential_stiffness_n_per_m * (position.x() - anchor.x_m);
    double spring_y = -config_.tangential_stiffness_n_per_m * (position.y() - anchor.y_m);
    const double spring_squared = spring_x * spring_x + spring_y * spring_y;
    if (spring_squared > limit * limit) {
      const double spring = std::sqrt(spring_squared);
      const double kept = limit / spring;
      wrench.load.sliding_n_m += normal * (spring - limit) / config_.tangential_stiffness_n_per_m;
      spring_x *= kept;
      spring_y *= kept;
      anchor.x_m = position.x() + spring_x / config_.tangential_stiffness_n_per_m;
      anchor.y_m = position.y() + spring_y / config_.tangential_stiffness_n_per_m;
    }
    double friction_x = spring_x - config_.tangential_damping_n_s_per_m * velocity.x();
    double friction_y = spring_y - config_.tangential_damping_n_s_per_m * velocity.y();
    const double friction_squared = friction_x * friction_x + friction_y * friction_y;
    if (friction_squared > limit * limit) {
      const double kept = limit / std::sqrt(friction_squared);
      friction_x *= kept;
      friction_y *= kept;
    }
    const btVector3 force{friction_x, friction_y, normal};
    wrench.force_world_n += force;
    wrench.torque_world_nm += arm.cross(force);
    wrench.load.normal_n[i] = normal;
    wrench.load.normal_moment_world_nm += normal * position;
  }
  return wrench;
}

}  // namespace surefoot::sim_hw
