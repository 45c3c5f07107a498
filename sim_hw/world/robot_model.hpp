#pragma once

#include <array>
#include <cstddef>

#include "sim_hw/plant_config.hpp"
#include "sim_hw/world/bullet_math.hpp"
#include "sim_hw/world/tree_body.hpp"
#include "sim_hw/world/trunk_mass.hpp"

namespace surefoot::sim_hw {

/// Motion of one rigid body, all in the world frame.
struct BodyMotion {
  btMatrix3x3 rotation_world_from_body;
  btVector3 position_m;    ///< of the reference point: centre of mass, or foot frame
  btVector3 velocity_m_s;  ///< of the same point
  btVector3 angular_rad_s;
};

/// The twelve-joint biped as a tree of rigid bodies: the trunk, and for each leg hip yaw, hip roll,
/// thigh, calf, ankle, foot (joints.hpp: yaw +z, roll +x, pitch +y; all frames parallel in the zero pose).
///
/// Links are uniform boxes: thigh 0.1 x 0.1 m and calf 0.05 x 0.1 m wide and as long as the geometry says, with their
/// centres in the middle; foot as long and wide as the sole and 0.1 m high, or up to the ankle where that is lower. The
/// two links between the hip axes and the one between the ankle axes carry 10 g each, taken from thigh and foot, so
/// that the masses add up to the configured ones.
///
/// The drives' rotor inertia, each joint's share of it, is added to the distal link about its joint's axis. A geared
/// rotor turns with the joint, not with the body: in a rotation of the whole robot this over-counts, by a few percent
/// of its pitch inertia.
class RobotModel {
 public:
  static constexpr int kLinks = 12;

  /// @param gravity_world_m_s2  the same everywhere and always
  RobotModel(const geometry::RobotGeometry&, const MassConfig&, const DriveConfig&,
             const geometry::Vector3& gravity_world_m_s2 = {0.0, 0.0, -kGravityM_S2});

  [[nodiscard]] static constexpr int link(Side side, LegJoint joint) noexcept {
    return static_cast<int>(index(side) * kJointsPerLeg + index(joint));
  }

  // Joints.
  void set_joints(const PerSide<LegVector>& angle_rad, const PerSide<LegVector>& rate_rad_s) noexcept;
  [[nodiscard]] PerSide<LegVector> angles_rad() const noexcept;
  [[nodiscard]] PerSide<LegVector> rates_rad_s() const noexcept;

  // The body frame, which is not Bullet's base frame: that one sits in the trunk's centre of mass.
  void place_body(const geometry::Vector3& position_world_m, const geometry::Matrix3& rotation_world_from_body,
                  const geometry::Vector3& velocity_world_m_s, const geometry::Vector3& angular_world_rad_s) noexcept;
  [[nodiscard]] geometry::Vector3 body_position_world_m() const noexcept;
  [[nodiscard]] geometry::Matrix3 rotation_world_from_body() const noexcept;
  [[nodiscard]] geometry::Vector3 body_velocity_world_m_s() const noexcept;
  [[nodiscard]] geometry::Vector3 body_rate_body_rad_s() const noexcept;

  /// Motion of the foot frame (ankle projected on the sole).
  [[nodiscard]] BodyMotion foot_motion(Side) const noexcept;
  /// Motion of every body's centre of mass: the links in order, then the trunk. For analysis.
  [[nodiscard]] std::array<BodyMotion, kLinks + 1> motions() const noexcept;

  [[nodiscard]] const TrunkMass& trunk() const noexcept { return trunk_; }
  /// Gives the trunk another mass distribution; no point of any body changes its place or velocity.
  void set_trunk(const TrunkMass&) noexcept;

  [[nodiscard]] double total_mass_kg() const noexcept;
  [[nodiscard]] const geometry::Vector3& gravity_world_m_s2() const noexcept { return gravity_world_m_s2_; }

  // One step, in this order: forces, torques, integrate.
  /// Adds a force at the origin of the foot frame and a torque, world frame.
  /// @param foot  what `foot_motion` says in this step
  void push_foot(Side, const BodyMotion& foot, const btVector3& force_n, const btVector3& torque_nm) noexcept;
  /// Adds a force on the trunk, world frame, at a point of the body frame.
  void push_trunk(const geometry::Vector3& force_world_n, const geometry::Vector3& point_body_m) noexcept;
  /// Adds motor torques less viscous friction.
  void drive_joints(const PerSide<LegVector>& motor_torque_nm) noexcept;
  /// Takes one step of the floating tree under gravity (semi-implicit Euler) and clears the forces.
  void integrate(double step_s) noexcept;

  [[nodiscard]] btMultiBody& multi_body() noexcept { return body_; }
  /// From the foot's centre of mass to the foot frame, foot axes.
  [[nodiscard]] const btVector3& foot_frame_from_com_m() const noexcept { return foot_frame_from_com_m_; }

 private:
  void build_leg(Side, const geometry::RobotGeometry&, const MassConfig&, const LegVector& rotor_inertia_kg_m2);

  TrunkMass trunk_;
  geometry::Vector3 gravity_world_m_s2_;
  LegVector friction_nm_s_per_rad_;
  btVector3 foot_frame_from_com_m_;
  TreeBody body_;
  btAlignedObjectArray<btScalar> scratch_scalar_;
  btAlignedObjectArray<btVector3> scratch_vector_;
  btAlignedObjectArray<btMatrix3x3> scratch_matrix_;
};

}  // namespace surefoot::sim_hw
