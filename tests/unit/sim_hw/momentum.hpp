#pragma once

#include "sim_hw/world/robot_model.hpp"

namespace surefoot::sim_hw::testing {

/// Sums over all bodies, from their masses and motions alone.
struct Momentum {
  double mass_kg = 0.0;
  geometry::Vector3 com_world_m = geometry::Vector3::Zero();
  geometry::Vector3 linear_n_s = geometry::Vector3::Zero();
  geometry::Vector3 angular_nm_s = geometry::Vector3::Zero();  ///< about the common centre of mass
  double kinetic_j = 0.0;
};

inline Momentum momentum(RobotModel& robot) {
  const auto motions = robot.motions();
  const btMultiBody& body = robot.multi_body();
  const auto mass_of = [&](int i) { return i < RobotModel::kLinks ? body.getLinkMass(i) : body.getBaseMass(); };
  Momentum sum;
  btVector3 first_moment{0, 0, 0};
  btVector3 linear{0, 0, 0};
  for (int i = 0; i <= RobotModel::kLinks; ++i) {
    const BodyMotion& motion = motions[static_cast<std::size_t>(i)];
    sum.mass_kg += mass_of(i);
    first_moment += mass_of(i) * motion.position_m;
    linear += mass_of(i) * motion.velocity_m_s;
  }
  const btVector3 com = first_moment / sum.mass_kg;
  btVector3 angular{0, 0, 0};
  for (int i = 0; i <= RobotModel::kLinks; ++i) {
    const BodyMotion& motion = motions[static_cast<std::size_t>(i)];
    const btVector3 inertia = i < RobotModel::kLinks ? body.getLinkInertia(i) : body.getBaseInertia();
    const btVector3 spin = motion.rotation_world_from_body *
                           (inertia * (motion.rotation_world_from_body.transpose() * motion.angular_rad_s));
    angular += spin + (motion.position_m - com).cross(mass_of(i) * motion.velocity_m_s);
    sum.kinetic_j += 0.5 * (mass_of(i) * motion.velocity_m_s.length2() + spin.dot(motion.angular_rad_s));
  }
  sum.com_world_m = from_bullet(com);
  sum.linear_n_s = from_bullet(linear);
  sum.angular_nm_s = from_bullet(angular);
  return sum;
}

}  // namespace surefoot::sim_hw::testing
