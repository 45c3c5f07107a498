#include "sim_hw/world/corner_contact.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot::sim_hw {

CornerContact::CornerContact(const geometry::RobotGeometry& geometry, const ContactConfig& config,
                             const TerrainConfig& terrain)
    : config_(config), terrain_(terrain, config.friction) {
  for (std::size_t i = 0; i < geometry::kCornersPerFoot; ++i) {
    corner_foot_m_[i] = to_bullet(geometry.corner_foot_m(static_cast<geometry::Corner>(i)));
  }
}

CornerContact::Plane CornerContact::surface_under(const Anchor& anchor, const btVector3& corner_m) const noexcept {
  if (terrain_.is_plane()) return {};
  const Surface surface = terrain_.at(corner_m.x(), corner_m.y());
  Plane plane{.offset_m = surface.height_m - surface.slope_x * corner_m.x(), .slope = surface.slope_x};
  if (plane.slope != 0.0) {
    plane.cosine = 1.0 / std::sqrt(1.0 + plane.slope * plane.slope);
    plane.sine = plane.slope * plane.cosine;
  }
  plane.offset_m += std::min(0.0, anchor.free_z_m - (plane.offset_m + plane.slope * anchor.free_x_m));
  return plane;
}

SoleWrench CornerContact::step(const BodyMotion& foot) noexcept {
  SoleWrench wrench;
  for (std::size_t i = 0; i < geometry::kCornersPerFoot; ++i) {
    Anchor& anchor = anchor_[i];
    const btVector3 arm = foot.rotation_world_from_body * corner_foot_m_[i];
    const btVector3 position = foot.position_m + arm;
    if (!anchor.touches) anchor.surface = surface_under(anchor, position);
    const Plane& plane = anchor.surface;
    const double distance = (position.z() - plane.offset_m - plane.slope * position.x()) * plane.cosine;
    if (distance >= 0.0) {
      anchor.touches = false;
      anchor.free_x_m = position.x();
      anchor.free_z_m = position.z();
      continue;
    }
    // In the surface's axes: along it ahead, to the left, away from it.
    const btVector3 world_velocity = foot.velocity_m_s + foot.angular_rad_s.cross(arm);
    const double along = position.x() * plane.cosine + position.z() * plane.sine;
    const btVector3 velocity{world_velocity.x() * plane.cosine + world_velocity.z() * plane.sine, world_velocity.y(),
                             world_velocity.z() * plane.cosine - world_velocity.x() * plane.sine};
    const double normal =
        std::max(0.0, -config_.normal_stiffness_n_per_m * distance - config_.normal_damping_n_s_per_m * velocity.z());
    if (!anchor.touches) {
      anchor.along_m = along;
      anchor.y_m = position.y();
      anchor.touches = true;
    }

    const double limit = terrain_.friction(position.x(), position.y()) * normal;
    double spring_x = -config_.tangential_stiffness_n_per_m * (along - anchor.along_m);
    double spring_y = -config_.tangential_stiffness_n_per_m * (position.y() - anchor.y_m);
    const double spring_squared = spring_x * spring_x + spring_y * spring_y;
    if (spring_squared > limit * limit) {
      const double spring = std::sqrt(spring_squared);
      const double kept = limit / spring;
      wrench.load.sliding_n_m += normal * (spring - limit) / config_.tangential_stiffness_n_per_m;
      spring_x *= kept;
      spring_y *= kept;
      anchor.along_m = along + spring_x / config_.tangential_stiffness_n_per_m;
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
    const btVector3 force{friction_x * plane.cosine - normal * plane.sine, friction_y,
                          normal * plane.cosine + friction_x * plane.sine};
    wrench.force_world_n += force;
    wrench.torque_world_nm += arm.cross(force);
    wrench.load.normal_n[i] = normal;
    wrench.load.normal_moment_world_nm += normal * position;
  }
  return wrench;
}

}  // namespace surefoot::sim_hw
