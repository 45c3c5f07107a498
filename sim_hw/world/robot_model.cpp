#include "sim_hw/world/robot_model.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "sim_hw/world/hip_spring.hpp"

namespace surefoot::sim_hw {
namespace {

constexpr double kIntermediateLinkKg = 0.01;
constexpr double kThighSectionM = 0.1;  // length and width of the thigh's box
constexpr double kCalfLengthM = 0.05;   // of the calf's box, along x
constexpr double kCalfWidthM = 0.1;     // along y
constexpr double kMaxFootHeightM = 0.1;

/// Links of a leg, from trunk to sole, as Bullet wants them.
struct LinkShape {
  double mass_kg;
  btVector3 inertia_kg_m2;
  btVector3 axis;
  btVector3 parent_com_to_joint_m;
  btVector3 joint_to_com_m;
};

double foot_height_m(const geometry::RobotGeometry& geometry) noexcept {
  return std::min(kMaxFootHeightM, geometry.ankle_height_m);
}

/// Inertia of each joint's rotor behind its gear, where it turns with the link.
LegVector rotor_inertia_kg_m2(const DriveConfig& drive) noexcept {
  LegVector inertia;
  for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
    inertia[joint] = drive.rotor_share[joint] * drive.rotor_inertia_kg_m2;
  }
  if (HipSpring::is_flexible(drive)) inertia[index(LegJoint::kHipRoll)] = 0.0;
  return inertia;
}

LegVector friction_nm_s_per_rad(const DriveConfig& drive) noexcept {
  LegVector friction;
  friction.fill(drive.hip_knee_friction_nm_s_per_rad);
  friction[index(LegJoint::kAnklePitch)] = drive.ankle_friction_nm_s_per_rad;
  friction[index(LegJoint::kAnkleRoll)] = drive.ankle_friction_nm_s_per_rad;
  if (HipSpring::is_flexible(drive)) friction[index(LegJoint::kHipRoll)] = 0.0;
  return friction;
}

btVector3 box(double mass_kg, double length_m, double width_m, double height_m) {
  return to_bullet(box_inertia(mass_kg, {length_m, width_m, height_m}));
}

/// Position, rotation and velocity of one link, in the link's own axes.
struct LinkState {
  btMatrix3x3 rotation_link_from_world;
  btVector3 com_from_trunk_m;
  btVector3 velocity_m_s;
  btVector3 angular_rad_s;
};

LinkState step_outwards(const btMultiBody& body, int link, const LinkState& parent) noexcept {
  const btMultibodyLink& shape = body.getLink(link);
  const btMatrix3x3 rotation{shape.m_cachedRotParentToThis};
  const double rate = body.getJointVel(link);
  LinkState state;
  state.rotation_link_from_world = rotation * parent.rotation_link_from_world;
  state.com_from_trunk_m = rotation * parent.com_from_trunk_m + shape.m_cachedRVector;
  const btVector3 angular = rotation * parent.angular_rad_s;
  state.velocity_m_s =
      rotation * parent.velocity_m_s + angular.cross(shape.m_cachedRVector) + rate * shape.getAxisBottom(0);
  state.angular_rad_s = angular + rate * shape.getAxisTop(0);
  return state;
}

LinkState trunk_state(const btMultiBody& body) noexcept {
  const btMatrix3x3 rotation{body.getWorldToBaseRot()};
  return {rotation, btVector3(0, 0, 0), rotation * body.getBaseVel(), rotation * body.getBaseOmega()};
}

BodyMotion motion_in_world(const btMultiBody& body, const LinkState& state, const btVector3& point_m) noexcept {
  const btMatrix3x3 rotation = state.rotation_link_from_world.transpose();
  return {rotation, body.getBasePos() + rotation * (state.com_from_trunk_m + point_m),
          rotation * (state.velocity_m_s + state.angular_rad_s.cross(point_m)), rotation * state.angular_rad_s};
}

}  // namespace

RobotModel::RobotModel(const geometry::RobotGeometry& geometry, const MassConfig& mass, const DriveConfig& drive,
                       const geometry::Vector3& gravity_world_m_s2)
    : trunk_(unloaded_trunk(mass)),
      gravity_world_m_s2_(gravity_world_m_s2),
      friction_nm_s_per_rad_(friction_nm_s_per_rad(drive)),
      foot_frame_from_com_m_(-mass.foot_com_x_foot_m, 0.0, -0.5 * foot_height_m(geometry)),
      body_(kLinks, trunk_.mass_kg, to_bullet(trunk_.inertia_kg_m2)) {
  for (const Side side : kSides) build_leg(side, geometry, mass, rotor_inertia_kg_m2(drive));
  body_.finish();
  place_body(geometry::Vector3::Zero(), geometry::Matrix3::Identity(), geometry::Vector3::Zero(),
             geometry::Vector3::Zero());
  set_joints({}, {});
  // Bullet sizes its scratch arrays in the first pass; with a step of zero it moves nothing.
  body_.computeAccelerationsArticulatedBodyAlgorithmMultiDof(0.0, scratch_scalar_, scratch_vector_, scratch_matrix_,
                                                             false, false, false);
}

void RobotModel::build_leg(Side side, const geometry::RobotGeometry& geometry, const MassConfig& mass,
                           const LegVector& rotor) {
  const btVector3 yaw{0, 0, 1};
  const btVector3 roll{1, 0, 0};
  const btVector3 pitch{0, 1, 0};
  const btVector3 zero{0, 0, 0};
  const btVector3 half_thigh{0, 0, -0.5 * geometry.thigh_m};
  const btVector3 half_calf{0, 0, -0.5 * geometry.calf_m};
  const btVector3 ankle_to_foot_com = btVector3{0, 0, -geometry.ankle_height_m} - foot_frame_from_com_m_;
  const double thigh_kg = mass.thigh_kg - 2.0 * kIntermediateLinkKg;
  const double foot_kg = mass.foot_kg - kIntermediateLinkKg;
  const btVector3 small = box(kIntermediateLinkKg, kThighSectionM, kThighSectionM, kThighSectionM);

  const std::array<LinkShape, kJointsPerLeg> shapes{{
      {kIntermediateLinkKg, small, yaw, to_bullet(geometry.hip_body_m(side) - trunk_.com_body_m), zero},
      {kIntermediateLinkKg, small, roll, zero, zero},
      {thigh_kg, box(thigh_kg, kThighSectionM, kThighSectionM, geometry.thigh_m), pitch, zero, half_thigh},
      {mass.calf_kg, box(mass.calf_kg, kCalfLengthM, kCalfWidthM, geometry.calf_m), pitch, half_thigh, half_calf},
      {kIntermediateLinkKg, small, pitch, half_calf, zero},
      {foot_kg,
       box(foot_kg, geometry.sole_heel_m + geometry.sole_toe_m, geometry.sole_width_m, foot_height_m(geometry)), roll,
       zero, ankle_to_foot_com},
  }};
  const int first = link(side, LegJoint::kHipYaw);
  for (int i = 0; i < static_cast<int>(kJointsPerLeg); ++i) {
    const auto joint = static_cast<std::size_t>(i);
    const LinkShape& shape = shapes[joint];
    body_.setupRevolute(first + i, shape.mass_kg, shape.inertia_kg_m2 + rotor[joint] * shape.axis,
                        i == 0 ? -1 : first + i - 1, btQuaternion::getIdentity(), shape.axis,
                        shape.parent_com_to_joint_m, shape.joint_to_com_m,
                        /*disableParentCollision=*/true);
  }
}

void RobotModel::set_joints(const PerSide<LegVector>& angle_rad, const PerSide<LegVector>& rate_rad_s) noexcept {
  for (const Side side : kSides) {
    for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
      const int i = link(side, static_cast<LegJoint>(joint));
      body_.setJointPos(i, angle_rad[index(side)][joint]);  // refreshes the link's cache
      body_.setJointVel(i, rate_rad_s[index(side)][joint]);
    }
  }
}

PerSide<LegVector> RobotModel::angles_rad() const noexcept {
  PerSide<LegVector> angle;
  for (int i = 0; i < kLinks; ++i) {
    const auto joint = static_cast<std::size_t>(i);
    angle[joint / kJointsPerLeg][joint % kJointsPerLeg] = body_.getJointPos(i);
  }
  return angle;
}

PerSide<LegVector> RobotModel::rates_rad_s() const noexcept {
  PerSide<LegVector> rate;
  for (int i = 0; i < kLinks; ++i) {
    const auto joint = static_cast<std::size_t>(i);
    rate[joint / kJointsPerLeg][joint % kJointsPerLeg] = body_.getJointVel(i);
  }
  return rate;
}

void RobotModel::place_body(const geometry::Vector3& position_world_m, const geometry::Matrix3& rotation,
                            const geometry::Vector3& velocity_world_m_s,
                            const geometry::Vector3& angular_world_rad_s) noexcept {
  const geometry::Vector3 com_world = rotation * trunk_.com_body_m;
  const btMatrix3x3 basis{rotation(0, 0), rotation(0, 1), rotation(0, 2), rotation(1, 0), rotation(1, 1),
                          rotation(1, 2), rotation(2, 0), rotation(2, 1), rotation(2, 2)};
  body_.setBaseWorldTransform(btTransform(basis, to_bullet(geometry::Vector3(position_world_m + com_world))));
  body_.setBaseVel(to_bullet(geometry::Vector3(velocity_world_m_s + angular_world_rad_s.cross(com_world))));
  body_.setBaseOmega(to_bullet(angular_world_rad_s));
}

geometry::Matrix3 RobotModel::rotation_world_from_body() const noexcept {
  return from_bullet(btMatrix3x3(body_.getWorldToBaseRot())).transpose();
}

geometry::Vector3 RobotModel::body_position_world_m() const noexcept {
  return from_bullet(body_.getBasePos()) - rotation_world_from_body() * trunk_.com_body_m;
}

geometry::Vector3 RobotModel::body_velocity_world_m_s() const noexcept {
  const geometry::Vector3 com_world = rotation_world_from_body() * trunk_.com_body_m;
  return from_bullet(body_.getBaseVel()) - from_bullet(body_.getBaseOmega()).cross(com_world);
}

geometry::Vector3 RobotModel::body_rate_body_rad_s() const noexcept {
  return rotation_world_from_body().transpose() * from_bullet(body_.getBaseOmega());
}

BodyMotion RobotModel::foot_motion(Side side) const noexcept {
  LinkState state = trunk_state(body_);
  const int first = link(side, LegJoint::kHipYaw);
  for (int i = first; i < first + static_cast<int>(kJointsPerLeg); ++i) state = step_outwards(body_, i, state);
  return motion_in_world(body_, state, foot_frame_from_com_m_);
}

std::array<BodyMotion, RobotModel::kLinks + 1> RobotModel::motions() const noexcept {
  std::array<BodyMotion, kLinks + 1> motion;
  const btVector3 com{0, 0, 0};
  const LinkState trunk = trunk_state(body_);
  for (const Side side : kSides) {
    LinkState state = trunk;
    const int first = link(side, LegJoint::kHipYaw);
    for (int i = first; i < first + static_cast<int>(kJointsPerLeg); ++i) {
      state = step_outwards(body_, i, state);
      motion[static_cast<std::size_t>(i)] = motion_in_world(body_, state, com);
    }
  }
  motion[kLinks] = motion_in_world(body_, trunk, com);
  return motion;
}

void RobotModel::set_trunk(const TrunkMass& trunk) noexcept {
  // Bullet's base sits in the centre of mass: move it there, take its velocity along, and leave
  // the hips where they are.
  const btVector3 shift_body = to_bullet(geometry::Vector3(trunk.com_body_m - trunk_.com_body_m));
  const btVector3 shift_world = btMatrix3x3(body_.getWorldToBaseRot()).transpose() * shift_body;
  body_.setBasePos(body_.getBasePos() + shift_world);
  body_.setBaseVel(body_.getBaseVel() + body_.getBaseOmega().cross(shift_world));
  for (const Side side : kSides) {
    btMultibodyLink& hip = body_.getLink(link(side, LegJoint::kHipYaw));
    hip.m_eVector -= shift_body;
    hip.updateCacheMultiDof();
  }
  body_.setBaseMass(trunk.mass_kg);
  body_.setBaseInertia(to_bullet(trunk.inertia_kg_m2));
  trunk_ = trunk;
}

double RobotModel::total_mass_kg() const noexcept {
  double mass = body_.getBaseMass();
  for (int i = 0; i < kLinks; ++i) mass += body_.getLinkMass(i);
  return mass;
}

void RobotModel::push_foot(Side side, const BodyMotion& foot, const btVector3& force_n,
                           const btVector3& torque_nm) noexcept {
  const int foot_link = link(side, LegJoint::kAnkleRoll);
  const btVector3 lever = foot.rotation_world_from_body * foot_frame_from_com_m_;
  body_.addLinkForce(foot_link, force_n);  // Bullet applies it at the centre of mass
  body_.addLinkTorque(foot_link, torque_nm + lever.cross(force_n));
}

void RobotModel::push_trunk(const geometry::Vector3& force_world_n, const geometry::Vector3& point_body_m) noexcept {
  const geometry::Vector3 lever = rotation_world_from_body() * (point_body_m - trunk_.com_body_m);
  body_.addBaseForce(to_bullet(force_world_n));  // at the centre of mass, world axes
  body_.addBaseTorque(to_bullet(lever.cross(force_world_n)));
}

void RobotModel::drive_joints(const PerSide<LegVector>& motor_torque_nm) noexcept {
  for (int i = 0; i < kLinks; ++i) {
    const std::size_t side = static_cast<std::size_t>(i) / kJointsPerLeg;
    const std::size_t joint = static_cast<std::size_t>(i) % kJointsPerLeg;
    body_.addJointTorque(i, motor_torque_nm[side][joint] - friction_nm_s_per_rad_[joint] * body_.getJointVel(i));
  }
}

void RobotModel::integrate(double step_s) noexcept {
  body_.computeAccelerationsArticulatedBodyAlgorithmMultiDof(step_s, scratch_scalar_, scratch_vector_, scratch_matrix_,
                                                             false, false, false);
  // Uniform gravity on every body accelerates the tree as a whole and no joint: exactly this.
  body_.setBaseVel(body_.getBaseVel() + to_bullet(gravity_world_m_s2_) * step_s);
  body_.stepPositionsMultiDof(step_s);
  body_.clearForcesAndTorques();
}

}  // namespace surefoot::sim_hw
