#include "sim_hw/world/robot_model.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tests/unit/sim_hw/momentum.hpp"
#include "tests/unit/sim_hw/standing.hpp"

namespace surefoot::sim_hw {
namespace {

using geometry::Matrix3;
using geometry::Vector3;
using testing::momentum;

constexpr PerSide<LegVector> kSomeAngles{{{0.2, -0.1, -0.5, 0.9, -0.3, 0.1}, {-0.3, 0.2, 0.1, 0.4, 0.2, -0.2}}};
constexpr PerSide<LegVector> kSomeRates{{{1.0, -0.5, 2.0, -1.5, 0.7, 0.3}, {-0.4, 0.8, -1.2, 1.1, -0.6, 0.9}}};

Matrix3 some_rotation() { return Eigen::AngleAxisd(0.7, Vector3(1.0, 2.0, -0.5).normalized()).toRotationMatrix(); }

void tumble(RobotModel& robot) {
  robot.set_joints(kSomeAngles, kSomeRates);
  robot.place_body({0.3, -0.2, 5.0}, some_rotation(), {0.4, 0.5, -0.6}, {1.0, -2.0, 0.5});
}

TEST(RobotModel, Weighs80Kilograms) {
  const RobotModel robot({}, {}, {});
  EXPECT_NEAR(robot.total_mass_kg(), 80.0, 1e-12);
}

// The same angles must mean the same foot to firmware and plant: a swapped sign, order or offset shows here.
TEST(RobotModel, PutsItsFeetWhereTheFirmwareExpectsThem) {
  const SimConfig config;
  RobotModel robot(config.geometry, config.mass, config.drive);
  tumble(robot);
  for (const Side side : kSides) {
    const kinematics::FootPose pose = kinematics::forward(config.geometry, side, kSomeAngles[index(side)]);
    const BodyMotion foot = robot.foot_motion(side);
    const Vector3 expected = robot.body_position_world_m() + some_rotation() * pose.position_body_m;
    EXPECT_TRUE(from_bullet(foot.position_m).isApprox(expected, 1e-13));
    EXPECT_TRUE(
        from_bullet(foot.rotation_world_from_body).isApprox(some_rotation() * pose.rotation_body_from_foot, 1e-13));
  }
}

// Velocities against a central difference of the positions.
TEST(RobotModel, ReportsTheFootsVelocityAsTheChangeOfItsPlace) {
  const SimConfig config;
  const double dt = 1.0e-6;
  const auto at = [&](double time) {
    RobotModel robot(config.geometry, config.mass, config.drive);
    PerSide<LegVector> angle = kSomeAngles;
    for (std::size_t s = 0; s < 2; ++s) {
      for (std::size_t j = 0; j < kJointsPerLeg; ++j) angle[s][j] += time * kSomeRates[s][j];
    }
    const Vector3 spin{1.0, -2.0, 0.5};
    const Matrix3 turn = Eigen::AngleAxisd(time * spin.norm(), spin.normalized()).toRotationMatrix();
    robot.set_joints(angle, kSomeRates);
    robot.place_body(Vector3(0.3, -0.2, 5.0) + time * Vector3(0.4, 0.5, -0.6), turn * some_rotation(), {0.4, 0.5, -0.6},
                     spin);
    return PerSide<BodyMotion>{robot.foot_motion(Side::kRight), robot.foot_motion(Side::kLeft)};
  };
  const auto before = at(-dt);
  const auto now = at(0.0);
  const auto after = at(dt);
  for (std::size_t s = 0; s < 2; ++s) {
    const Vector3 change = from_bullet(after[s].position_m - before[s].position_m) / (2.0 * dt);
    EXPECT_TRUE(from_bullet(now[s].velocity_m_s).isApprox(change, 1e-7));
    const Matrix3 turn =
        (from_bullet(after[s].rotation_world_from_body) - from_bullet(before[s].rotation_world_from_body)) /
        (2.0 * dt) * from_bullet(now[s].rotation_world_from_body).transpose();
    EXPECT_TRUE(from_bullet(now[s].angular_rad_s).isApprox(Vector3(turn(2, 1), turn(0, 2), turn(1, 0)), 1e-7));
  }
}

// El-Kahlout 2003 prints -0.035 m; spec A.9: (0.2 m - 2.5 - 0.3) / (80 + m) with a load.
TEST(RobotModel, HasTheThesisStandingZmpFromItsMassesAlone) {
  const SimConfig config;
  for (const double load_kg : {0.0, 2.5, 5.0, 7.5, 10.0, 12.5, 15.0}) {
    RobotModel robot(config.geometry, config.mass, config.drive);
    robot.set_joints(testing::stance(config.geometry), {});
    PayloadConfig payload;
    payload.mass_kg = load_kg;
    robot.set_trunk(hang_payload(robot.trunk(), payload));
    const double com_x = momentum(robot).com_world_m.x();
    EXPECT_NEAR(com_x, (0.2 * load_kg - 2.5 - 0.3) / (80.0 + load_kg), 0.001) << load_kg;
    if (load_kg == 0.0) {
      EXPECT_NEAR(com_x, -0.0344, 2e-4);
    }
  }
}

TEST(RobotModel, FallsFreelyLikeAStone) {
  RobotModel robot({}, {}, {});
  tumble(robot);
  const testing::Momentum start = momentum(robot);
  const double step_s = 5.0e-4;
  const int steps = 1000;
  for (int i = 0; i < steps; ++i) {
    robot.drive_joints({});
    robot.integrate(step_s);
  }
  const testing::Momentum end = momentum(robot);
  const double t = steps * step_s;
  const Vector3 start_velocity = start.linear_n_s / start.mass_kg;
  const Vector3 expected = start.com_world_m + t * start_velocity + Vector3(0, 0, -0.5 * kGravityM_S2 * t * t);
  EXPECT_LT((end.com_world_m - expected).norm(), 5.0e-3);  // semi-implicit Euler: g t dt / 2 = 1.2 mm, and tumbling
  EXPECT_LT((end.linear_n_s / end.mass_kg - start_velocity - Vector3(0, 0, -kGravityM_S2 * t)).norm(), 5.0e-3);
}

double angular_momentum_drift(double step_s) {
  SimConfig config;
  RobotModel robot(config.geometry, config.mass, config.drive);
  tumble(robot);
  const Vector3 start = momentum(robot).angular_nm_s;
  for (double t = 0.0; t < 0.2; t += step_s) {
    robot.drive_joints({});
    robot.integrate(step_s);
  }
  return (momentum(robot).angular_nm_s - start).norm() / start.norm();
}

// Joint friction and gravity are inner and central: angular momentum stays, to the integrator's first order.
TEST(RobotModel, KeepsItsAngularMomentumInFreeFall) {
  const double coarse = angular_momentum_drift(5.0e-4);
  const double fine = angular_momentum_drift(1.25e-4);
  EXPECT_LT(coarse, 2.0e-2);
  EXPECT_LT(fine, 0.35 * coarse);
}

// Straight leg under an immovable trunk, torque about the vertical: tau / (rotor + sum of the links' I_zz).
TEST(RobotModel, AcceleratesAJointByTorqueOverRotorAndLinkInertia) {
  MassConfig mass;
  mass.trunk_kg = 1.0e12;
  mass.foot_com_x_foot_m = 0.0;  // all centres on the yaw axis: no coupling into other joints
  const geometry::RobotGeometry geometry;
  for (const double rotor : {0.0, 0.4, 2.0}) {
    RobotModel robot(geometry, mass, {.rotor_inertia_kg_m2 = rotor});
    const double sole = geometry.sole_heel_m + geometry.sole_toe_m;
    const double links = 9.48 / 12.0 * (0.01 + 0.01) + 0.5 / 12.0 * (0.0025 + 0.01) +
                         4.99 / 12.0 * (sole * sole + geometry.sole_width_m * geometry.sole_width_m) +
                         3.0 * 0.01 / 12.0 * 0.02;
    PerSide<LegVector> torque{};
    torque[index(Side::kLeft)][index(LegJoint::kHipYaw)] = 7.0;
    const double step_s = 1.0e-4;
    robot.drive_joints(torque);
    robot.integrate(step_s);
    const PerSide<LegVector> rate = robot.rates_rad_s();
    const double expected = 7.0 * step_s / (rotor + links);
    EXPECT_NEAR(rate[1][0], expected, 1e-9 * expected);
    for (std::size_t joint = 1; joint < kJointsPerLeg; ++joint) EXPECT_NEAR(rate[1][joint], 0.0, 1e-9);
    for (const double other : rate[0]) EXPECT_NEAR(other, 0.0, 1e-9);
  }
}

TEST(RobotModel, BrakesAJointByItsViscousFriction) {
  MassConfig mass;
  mass.trunk_kg = 1.0e12;
  mass.foot_com_x_foot_m = 0.0;
  const auto rate_change = [&](double friction) {
    RobotModel robot({}, mass, {.hip_knee_friction_nm_s_per_rad = friction});
    PerSide<LegVector> rate{};
    rate[0][0] = 1.0;
    robot.set_joints({}, rate);
    robot.drive_joints({});
    robot.integrate(1.0e-4);
    return robot.rates_rad_s()[0][0] - 1.0;
  };
  EXPECT_NEAR(rate_change(0.0), 0.0, 1e-9);
  EXPECT_LT(rate_change(10.0), 0.0);
  EXPECT_NEAR(rate_change(20.0), 2.0 * rate_change(10.0), 1e-9);
}

TEST(RobotModel, ChangesNoPlaceAndNoVelocityWhenALoadIsHungOn) {
  RobotModel robot({}, {}, {});
  tumble(robot);
  const auto before = robot.motions();
  const PerSide<BodyMotion> feet_before{robot.foot_motion(Side::kRight), robot.foot_motion(Side::kLeft)};
  const Vector3 position = robot.body_position_world_m();
  const Vector3 velocity = robot.body_velocity_world_m_s();

  PayloadConfig payload;
  payload.mass_kg = 15.0;
  payload.position_m = {0.2, -0.1, 0.4};
  robot.set_trunk(hang_payload(robot.trunk(), payload));

  EXPECT_LT((robot.body_position_world_m() - position).norm(), 1e-13);
  EXPECT_LT((robot.body_velocity_world_m_s() - velocity).norm(), 1e-13);
  const auto after = robot.motions();
  for (std::size_t i = 0; i < RobotModel::kLinks; ++i) {  // the hip links come first: their centres are the hips
    EXPECT_LT((after[i].position_m - before[i].position_m).length(), 1e-13);
    EXPECT_LT((after[i].velocity_m_s - before[i].velocity_m_s).length(), 1e-13);
  }
  for (const Side side : kSides) {
    const BodyMotion foot = robot.foot_motion(side);
    EXPECT_LT((foot.position_m - feet_before[index(side)].position_m).length(), 1e-13);
    EXPECT_LT((foot.velocity_m_s - feet_before[index(side)].velocity_m_s).length(), 1e-13);
    EXPECT_LT((foot.angular_rad_s - feet_before[index(side)].angular_rad_s).length(), 1e-13);
  }
}

// The box brings the momentum of its place on the moving trunk, nothing else.
TEST(RobotModel, GainsTheMomentumOfTheLoadAndNoOther) {
  RobotModel robot({}, {}, {});
  tumble(robot);
  PayloadConfig payload;
  payload.mass_kg = 15.0;
  payload.position_m = {0.2, -0.1, 0.4};
  const Vector3 arm_world = robot.rotation_world_from_body() * Vector3(0.2, -0.1, 0.4);
  const Vector3 spin_world = robot.rotation_world_from_body() * robot.body_rate_body_rad_s();
  const Vector3 load_velocity = robot.body_velocity_world_m_s() + spin_world.cross(arm_world);
  const Vector3 before = momentum(robot).linear_n_s;
  robot.set_trunk(hang_payload(robot.trunk(), payload));
  EXPECT_LT((momentum(robot).linear_n_s - before - 15.0 * load_velocity).norm(), 1e-11);
  EXPECT_NEAR(robot.total_mass_kg(), 95.0, 1e-12);
}

}  // namespace
}  // namespace surefoot::sim_hw
