#include "tests/unit/sim_hw/standing.hpp"

#include <gtest/gtest.h>

#include "tests/unit/sim_hw/momentum.hpp"

namespace surefoot::sim_hw {
namespace {

using testing::StandingRobot;

TEST(Standing, CarriesItsWeightAndNothingElse) {
  StandingRobot robot({});
  robot.stand(2.0);
  EXPECT_NEAR(robot.carried_n(), 80.0 * kGravityM_S2, 0.001 * 80.0 * kGravityM_S2);
  EXPECT_NEAR(robot.world.robot().body_position_world_m().z(), 0.5, 0.001);
}

// Spec A.9, statics; within 3 mm.
TEST(Standing, HasItsZmpWhereStaticsPutIt) {
  for (const double load_kg : {0.0, 2.5, 5.0, 10.0, 15.0}) {
    StandingRobot robot({});
    PayloadConfig payload;
    payload.mass_kg = load_kg;
    robot.world.hang(payload);
    robot.stand(2.0);
    EXPECT_NEAR(robot.zmp_x_body_m(), (0.2 * load_kg - 2.5 - 0.3) / (80.0 + load_kg), 0.003) << load_kg;
    EXPECT_NEAR(robot.carried_n(), (80.0 + load_kg) * kGravityM_S2, 1.0);
  }
}

TEST(Standing, IsQuietAtOneMillisecondOfLatency) {
  StandingRobot robot({});
  robot.stand(2.0);
  const double slip_m = robot.world.slip_m();
  for (int i = 0; i < 1000; ++i) {
    robot.tick();
    ASSERT_LT(robot.ripple_nm, 1.0e-3);
  }
  EXPECT_LT(robot.world.slip_m() - slip_m, 1.0e-6);
}

TEST(Standing, IsTheSameAtHalfThePhysicsStep) {
  SimConfig half;
  half.physics_step_s = 2.5e-4;
  StandingRobot whole_robot({});
  StandingRobot half_robot(half);
  whole_robot.stand(0.05);
  half_robot.stand(0.05);  // still moving
  EXPECT_NEAR(whole_robot.carried_n(), half_robot.carried_n(), 0.03 * 784.8);
  whole_robot.stand(2.0);
  half_robot.stand(2.0);
  EXPECT_NEAR(whole_robot.zmp_x_body_m(), half_robot.zmp_x_body_m(), 1.0e-5);
  EXPECT_NEAR(whole_robot.world.robot().body_position_world_m().z(),
              half_robot.world.robot().body_position_world_m().z(), 1.0e-6);
}

/// Motion, height, sole springs and joint springs; the anchors' energy is left out, it can only be missing.
double energy_j(StandingRobot& robot, const SimConfig& config) {
  RobotModel& model = robot.world.robot();
  const testing::Momentum sum = testing::momentum(model);
  double energy = sum.kinetic_j + sum.mass_kg * kGravityM_S2 * sum.com_world_m.z();
  const PerSide<LegVector> wanted = testing::stance(config.geometry);
  const PerSide<LegVector> angle = model.angles_rad();
  for (const Side side : kSides) {
    const BodyMotion foot = model.foot_motion(side);
    for (std::size_t i = 0; i < geometry::kCornersPerFoot; ++i) {
      const btVector3 corner = to_bullet(config.geometry.corner_foot_m(static_cast<geometry::Corner>(i)));
      const double depth = std::min(0.0, (foot.position_m + foot.rotation_world_from_body * corner).z());
      energy += 0.5 * config.contact.normal_stiffness_n_per_m * depth * depth;
    }
    for (std::size_t j = 0; j < kJointsPerLeg; ++j) {
      const double error = wanted[index(side)][j] - angle[index(side)][j];
      energy += 0.5 * testing::kStiffness[j] * error * error;
    }
  }
  return energy;
}

TEST(Standing, GainsNoEnergyFromADropOfAMillimetre) {
  SimConfig config;
  config.control_period_s = config.physics_step_s;  // nearly continuous: the PD is then a spring and a damper
  StandingRobot robot(config, /*latency_ticks=*/0);
  RobotModel& model = robot.world.robot();
  const geometry::Vector3 up{0.0, 0.0, 0.001};
  model.place_body(model.body_position_world_m() + up, geometry::Matrix3::Identity(), {0.05, 0.03, 0.0},
                   geometry::Vector3::Zero());
  const double start = energy_j(robot, config);
  double highest = start;
  for (int i = 0; i < 4000; ++i) {
    robot.tick();
    highest = std::max(highest, energy_j(robot, config));
  }
  const double end = energy_j(robot, config);
  EXPECT_LT(highest - start, 0.05 * (start - end));
  EXPECT_LT(testing::momentum(model).kinetic_j, 1.0e-6);
}

TEST(Standing, CarriesTheSameWeightOnBulletsOwnContacts) {
  SimConfig config;
  config.contact.model = ContactModel::kBullet;
  StandingRobot robot(config);
  robot.stand(1.5);
  StandingRobot reference({});
  reference.stand(1.5);
  EXPECT_NEAR(robot.carried_n(), 80.0 * kGravityM_S2, 0.01 * 80.0 * kGravityM_S2);
  EXPECT_NEAR(robot.zmp_x_body_m(), reference.zmp_x_body_m(), 0.002);
  for (const Side side : kSides) {
    for (const double corner_n : robot.world.loads()[index(side)].normal_n) EXPECT_GE(corner_n, 0.0);
    EXPECT_NEAR(robot.world.loads()[index(side)].normal_sum_n(), 0.5 * 784.8, 8.0);
    // Four rigid corners share a load in many ways, but front against rear follows from statics.
    const SoleLoad& load = robot.world.loads()[index(side)];
    const SoleLoad& sprung = reference.world.loads()[index(side)];
    EXPECT_NEAR(load.normal_n[0] + load.normal_n[1], sprung.normal_n[0] + sprung.normal_n[1], 3.0);
  }
}

// Forces times the places of their corners give the moment that the solver reports: none is booked elsewhere.
TEST(Standing, BooksEachOfBulletsForcesUnderTheCornerWhereItActs) {
  SimConfig config;
  config.contact.model = ContactModel::kBullet;
  StandingRobot robot(config);
  PayloadConfig payload;
  payload.mass_kg = 20.0;
  payload.position_m = {0.2, 0.3, 0.25};  // left and front carry more
  robot.world.hang(payload);
  robot.stand(0.5);
  for (const Side side : kSides) {
    const SoleLoad& load = robot.world.loads()[index(side)];
    const BodyMotion foot = robot.world.robot().foot_motion(side);
    btVector3 moment{0, 0, 0};
    for (std::size_t i = 0; i < geometry::kCornersPerFoot; ++i) {
      const btVector3 corner = to_bullet(config.geometry.corner_foot_m(static_cast<geometry::Corner>(i)));
      moment += load.normal_n[i] * (foot.position_m + foot.rotation_world_from_body * corner);
    }
    EXPECT_NEAR(moment.x(), load.normal_moment_world_nm.x(), 0.05);
    EXPECT_NEAR(moment.y(), load.normal_moment_world_nm.y(), 0.05);
    EXPECT_GT(std::abs(load.normal_n[0] + load.normal_n[2] - load.normal_n[1] - load.normal_n[3]), 5.0);
  }
}

// The whole robot slides at 0.5 m/s: Coulomb slows it by mu g, and all its travel is slip.
TEST(Standing, SlidesToAHaltByCoulombsLawOnEitherFloor) {
  for (const ContactModel model : {ContactModel::kSpringDamper, ContactModel::kBullet}) {
    SimConfig config;
    config.contact.model = model;
    config.contact.friction = 0.1;
    StandingRobot robot(config);
    robot.stand(0.5);
    RobotModel& body = robot.world.robot();
    body.place_body(body.body_position_world_m(), body.rotation_world_from_body(), {0.5, 0.0, 0.0},
                    geometry::Vector3::Zero());
    robot.stand(0.05);  // friction builds up
    const testing::Momentum start = testing::momentum(body);
    const double slip_m = robot.world.slip_m();
    robot.stand(0.2);
    const testing::Momentum end = testing::momentum(body);
    EXPECT_NEAR((start.linear_n_s.x() - end.linear_n_s.x()) / start.mass_kg, 0.1 * kGravityM_S2 * 0.2, 0.02);
    EXPECT_NEAR(robot.world.slip_m() - slip_m, end.com_world_m.x() - start.com_world_m.x(), 0.005);
  }
}

TEST(Standing, GivesTheSameBitsTwiceOnEitherFloor) {
  for (const ContactModel model : {ContactModel::kSpringDamper, ContactModel::kBullet}) {
    SimConfig config;
    config.contact.model = model;
    StandingRobot one(config);
    one.stand(0.1);
    StandingRobot two(config);  // made while the first lives: no shared state
    two.stand(0.1);
    EXPECT_EQ(one.torque_nm, two.torque_nm);
    EXPECT_EQ(one.world.robot().body_position_world_m(), two.world.robot().body_position_world_m());
    EXPECT_EQ(one.world.slip_m(), two.world.slip_m());
  }
}

TEST(Standing, NeverFeelsTheFloorPull) {
  StandingRobot robot({});
  RobotModel& model = robot.world.robot();
  model.place_body(model.body_position_world_m() + geometry::Vector3(0.0, 0.0, 0.05), geometry::Matrix3::Identity(),
                   {0.3, 0.2, 0.0}, {0.5, 0.5, 0.0});
  for (int i = 0; i < 1500; ++i) {
    robot.tick();
    for (const SoleLoad& load : robot.world.loads()) {
      for (const double corner_n : load.normal_n) ASSERT_GE(corner_n, 0.0);
    }
  }
}

}  // namespace
}  // namespace surefoot::sim_hw
