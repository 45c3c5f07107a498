#include "sim_hw/world/bullet_floor.hpp"

#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <btBulletDynamicsCommon.h>

#include <cmath>

#include "sim_hw/world/bullet_terrain.hpp"

namespace surefoot::sim_hw {
namespace {

constexpr double kSphereRadiusM = 0.01;
constexpr double kReachM = 3.0 * kSphereRadiusM;  // farther than a sphere gets in one step
constexpr int kSolverIterations = 30;
constexpr double kErrorReduction = 0.1;  // share of the depth that one step takes back

/// Middle of the four corners, foot frame.
geometry::Vector3 sole_centre(const geometry::RobotGeometry& geometry) {
  return 0.5 *
         (geometry.corner_foot_m(geometry::Corner::kFrontLeft) + geometry.corner_foot_m(geometry::Corner::kRearRight));
}

/// Adds one point of a manifold to the load of its sole.
void add_contact(SoleLoad& load, const BodyMotion& foot, const btVector3& position_m, double normal_n,
                 double step_s) noexcept {
  const btVector3 arm = position_m - foot.position_m;
  const btVector3 velocity = foot.velocity_m_s + foot.angular_rad_s.cross(arm);
  load.normal_moment_world_nm += normal_n * position_m;
  load.sliding_n_m += normal_n * std::hypot(velocity.x(), velocity.y()) * step_s;
}

}  // namespace

// Members are destroyed in reverse: colliders and shapes outlive the world that refers to them.
struct BulletFloor::BulletWorld {
  BulletWorld(const geometry::RobotGeometry& geometry, double friction, const TerrainConfig& surface, RobotModel& robot)
      : robot_(robot),
        sole_centre_m(to_bullet(sole_centre(geometry)) + robot.foot_frame_from_com_m()),
        sphere(kSphereRadiusM),
        terrain(surface, friction, world) {
    world.setForceUpdateAllAabbs(false);  // the floor does not move
    world.setGravity(to_bullet(robot.gravity_world_m_s2()));
    btContactSolverInfo& settings = world.getSolverInfo();
    settings.m_numIterations = kSolverIterations;
    settings.m_erp2 = kErrorReduction;
    settings.m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
    world.addMultiBody(&robot.multi_body());
    for (const Side side : kSides) add_sole(geometry, side);
  }

  ~BulletWorld() {
    for (auto& sole : soles) world.removeCollisionObject(sole.get());
    for (const Side side : kSides) robot_.multi_body().getLink(foot_link(side)).m_collider = nullptr;
    world.removeMultiBody(&robot_.multi_body());
  }
  BulletWorld(const BulletWorld&) = delete;
  BulletWorld& operator=(const BulletWorld&) = delete;

  static int foot_link(Side side) noexcept { return RobotModel::link(side, LegJoint::kAnkleRoll); }

  void add_sole(const geometry::RobotGeometry& geometry, Side side) {
    for (std::size_t i = 0; i < geometry::kCornersPerFoot; ++i) {
      btVector3 centre =
          robot_.foot_frame_from_com_m() + to_bullet(geometry.corner_foot_m(static_cast<geometry::Corner>(i)));
      centre.setZ(centre.z() + kSphereRadiusM);
      corners[index(side)].addChildShape(btTransform(btQuaternion::getIdentity(), centre), &sphere);
    }
    auto& sole = soles[index(side)];
    sole = std::make_unique<btMultiBodyLinkCollider>(&robot_.multi_body(), foot_link(side));
    sole->setCollisionShape(&corners[index(side)]);
    sole->setFriction(1.0);  // Bullet multiplies both partners'
    sole->setActivationState(DISABLE_DEACTIVATION);
    robot_.multi_body().getLink(foot_link(side)).m_collider = sole.get();
    world.addCollisionObject(sole.get(), btBroadphaseProxy::DefaultFilter, btBroadphaseProxy::StaticFilter);
  }

  void build_floor_under(const RobotModel& robot) {
    for (const Side side : kSides) {
      const BodyMotion foot = robot.foot_motion(side);
      for (std::size_t i = 0; i < geometry::kCornersPerFoot; ++i) {
        const btVector3 centre = corners[index(side)].getChildTransform(static_cast<int>(i)).getOrigin();
        const btVector3 place =
            foot.position_m + foot.rotation_world_from_body * (centre - robot_.foot_frame_from_com_m());
        terrain.reach(place.x(), place.y(), kReachM);
      }
    }
  }

  /// The corner whose sphere made this contact.
  std::size_t corner_at(const btVector3& point_from_com_m) const noexcept {
    const bool rear = point_from_com_m.x() < sole_centre_m.x();
    const bool right = point_from_com_m.y() < sole_centre_m.y();
    return (rear ? 2U : 0U) + (right ? 1U : 0U);
  }

  RobotModel& robot_;
  btVector3 sole_centre_m;  ///< from the foot's centre of mass
  btSphereShape sphere;
  std::array<btCompoundShape, 2> corners;
  PerSide<std::unique_ptr<btMultiBodyLinkCollider>> soles;
  btAlignedObjectArray<btQuaternion> scratch_rotation;
  btAlignedObjectArray<btVector3> scratch_origin;
  btDefaultCollisionConfiguration collision_configuration;
  btCollisionDispatcher dispatcher{&collision_configuration};
  btDbvtBroadphase broadphase;
  btMultiBodyConstraintSolver solver;
  btMultiBodyDynamicsWorld world{&dispatcher, &broadphase, &solver, &collision_configuration};
  BulletTerrain terrain;
};

BulletFloor::BulletFloor(const geometry::RobotGeometry& geometry, const ContactConfig& config,
                         const TerrainConfig& terrain, RobotModel& robot)
    : world_(std::make_unique<BulletWorld>(geometry, config.friction, terrain, robot)) {}

BulletFloor::~BulletFloor() = default;

double BulletFloor::resting_depth_m(double /*total_mass_kg*/) const noexcept { return 0.0; }

void BulletFloor::step(RobotModel& robot, const PerSide<LegVector>& motor_torque_nm, double step_s) noexcept {
  robot.drive_joints(motor_torque_nm);
  robot.multi_body().updateCollisionObjectWorldTransforms(world_->scratch_rotation, world_->scratch_origin);
  world_->build_floor_under(robot);
  world_->world.stepSimulation(step_s, 0);

  load_ = {};
  const PerSide<BodyMotion> foot{robot.foot_motion(Side::kRight), robot.foot_motion(Side::kLeft)};
  for (int m = 0; m < world_->dispatcher.getNumManifolds(); ++m) {
    const btPersistentManifold& manifold = *world_->dispatcher.getManifoldByIndexInternal(m);
    for (const Side side : kSides) {
      const btCollisionObject* sole = world_->soles[index(side)].get();
      const bool sole_is_first = manifold.getBody0() == sole;
      if (!sole_is_first && manifold.getBody1() != sole) continue;
      for (int p = 0; p < manifold.getNumContacts(); ++p) {
        const btManifoldPoint& point = manifold.getContactPoint(p);
        const double normal_n = point.getAppliedImpulse() / step_s;
        SoleLoad& load = load_[index(side)];
        load.normal_n[world_->corner_at(sole_is_first ? point.m_localPointA : point.m_localPointB)] += normal_n;
        add_contact(load, foot[index(side)], sole_is_first ? point.getPositionWorldOnA() : point.getPositionWorldOnB(),
                    normal_n, step_s);
      }
    }
  }
}

}  // namespace surefoot::sim_hw
