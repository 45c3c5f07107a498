#include "sim_hw/world/disturbances.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "tests/unit/sim_hw/held_robot.hpp"
#include "tests/unit/sim_hw/momentum.hpp"

namespace surefoot::sim_hw {
namespace {

using geometry::Vector3;
using testing::HeldRobot;
using testing::momentum;

constexpr double kStep_s = 5.0e-4;

/// High above the floor, upright and at rest.
void lift(World& world) {
  world.robot().place_body({0.0, 0.0, 5.0}, geometry::Matrix3::Identity(), Vector3::Zero(), Vector3::Zero());
}

// Newton and Euler for the whole robot: dp = F dt, dL = (point - common centre of mass) x F dt. One step from rest:
// what the bodies move meanwhile is of second order in the step. A force that is turned or acts elsewhere shows at
// once.
TEST(Push, GivesAFreeRobotItsImpulseAndItsMomentOnEitherFloor) {
  const Vector3 force_n{300.0, -200.0, 100.0};
  const Vector3 point_m{0.05, 0.1, 0.45};
  for (const ContactModel model : {ContactModel::kSpringDamper, ContactModel::kBullet}) {
    SimConfig config;
    config.contact.model = model;
    World world(config, testing::stance(config.geometry));
    lift(world);
    const testing::Momentum start = momentum(world.robot());
    const Vector3 arm_m = world.robot().body_position_world_m() + point_m - start.com_world_m;
    world.push(force_n, point_m);
    world.advance({}, kStep_s);
    const testing::Momentum end = momentum(world.robot());
    const Vector3 fallen{0.0, 0.0, -start.mass_kg * kGravityM_S2 * kStep_s};
    EXPECT_LT((end.linear_n_s - start.linear_n_s - fallen - kStep_s * force_n).norm(), 1e-4 * kStep_s * force_n.norm());
    // The rotors' inertia counts in the sum as in the model: nothing is left out on either side.
    EXPECT_LT((end.angular_nm_s - start.angular_nm_s - kStep_s * arm_m.cross(force_n)).norm(),
              2e-3 * kStep_s * arm_m.cross(force_n).norm());
    world.advance({}, kStep_s);
    EXPECT_LT((momentum(world.robot()).linear_n_s - end.linear_n_s - fallen).norm(), 1e-5) << "it acts for one step";
  }
}

// 20 N s on 80 kg: 0.25 m/s.
TEST(Push, OfTwentyNewtonSecondsSpeedsTheFreeRobotUpByAQuarterOfAMetreASecond) {
  SimConfig config;
  config.pushes = {{.at_s = 0.01, .duration_s = 0.1, .force_n = {0.0, 200.0, 0.0}}};
  World world(config, testing::stance(config.geometry));
  lift(world);
  Disturbances disturbances(config);
  for (int step = 0; step < 400; ++step) {
    disturbances.begin_due(step * kStep_s, world);
    disturbances.push(world);
    world.advance({}, kStep_s);
  }
  EXPECT_NEAR(momentum(world.robot()).linear_n_s.y() / 80.0, 0.25, 0.0025);
  EXPECT_NEAR(world.push_impulse_n_s().y(), 20.0, 1e-12);
}

TEST(Push, HasItsImpulseWhateverItsDurationInSteps) {
  for (const double duration_s : {1.0e-4, 5.0e-4, 1.23e-3, 0.0333, 0.1}) {
    SimConfig config;
    config.pushes = {{.at_s = 0.0, .duration_s = duration_s, .force_n = {100.0, -50.0, 10.0}}};
    World world(config, testing::stance(config.geometry));
    lift(world);
    Disturbances disturbances(config);
    int steps = 0;
    for (int step = 0; disturbances.pushes_ended() == 0; ++step) {
      const Vector3 before = world.push_impulse_n_s();
      disturbances.begin_due(step * kStep_s, world);
      disturbances.push(world);
      world.advance({}, kStep_s);
      if (world.push_impulse_n_s() != before) ++steps;
    }
    EXPECT_LT((world.push_impulse_n_s() - duration_s * Vector3(100.0, -50.0, 10.0)).norm(), 1e-12) << duration_s;
    EXPECT_EQ(steps, std::max(1, static_cast<int>(std::lround(duration_s / kStep_s)))) << duration_s;
  }
}

TEST(Push, BeginsAndEndsOnTheScenariosClockAndInItsPlaceOfTheScenario) {
  SimConfig config;
  config.time_zero_s = 0.02;
  config.pushes = {{.at_s = 0.01, .duration_s = 0.005, .force_n = {10.0, 0.0, 0.0}},
                   {.at_s = -0.01, .duration_s = 0.0005, .force_n = {0.0, 10.0, 0.0}}};
  HeldRobot held(config);
  const auto at_end_of_tick = [&](int ticks) {
    while (static_cast<int>(held.puppeteer.tick) < ticks) held.tick();
    return std::pair{held.robot.truth().pushes_begun, held.robot.truth().pushes_ended};
  };
  EXPECT_EQ(at_end_of_tick(10), std::pair(0U, 0U));
  EXPECT_EQ(at_end_of_tick(11), std::pair(0b10U, 0b10U)) << "one step long: both within a tick";
  EXPECT_EQ(at_end_of_tick(30), std::pair(0b10U, 0b10U));
  EXPECT_EQ(at_end_of_tick(31), std::pair(0b11U, 0b10U));
  EXPECT_EQ(at_end_of_tick(35), std::pair(0b11U, 0b10U));
  EXPECT_EQ(at_end_of_tick(36), std::pair(0b11U, 0b11U));
  EXPECT_NEAR(held.robot.truth().push_impulse_world_n_s[0], 0.05, 1e-15);
  EXPECT_NEAR(held.robot.truth().push_impulse_world_n_s[1], 0.005, 1e-15);
}

TEST(Removal, ComesAtItsTimeOnTheScenariosClockAndInAnyOrder) {
  SimConfig config;
  config.time_zero_s = 0.02;
  config.payloads = {{.mass_kg = 3.0, .at_s = 0.0, .removed_at_s = 0.01},
                     {.mass_kg = 2.0, .at_s = -0.01, .removed_at_s = 0.02},
                     {.mass_kg = 1.0, .at_s = -0.005}};
  HeldRobot held(config);
  const auto removed_kg_after = [&](int ticks) {
    while (static_cast<int>(held.puppeteer.tick) < ticks) held.tick();
    return held.robot.truth().removed_kg;
  };
  EXPECT_EQ(removed_kg_after(30), 0.0);
  EXPECT_EQ(removed_kg_after(31), 3.0);
  EXPECT_EQ(removed_kg_after(40), 3.0);
  EXPECT_EQ(removed_kg_after(41), 5.0);
  held.stand(1.5);
  EXPECT_EQ(held.robot.truth().payloads_hung, 3);
  EXPECT_EQ(held.robot.truth().payloads_removed, 2);
  EXPECT_EQ(held.robot.truth().payload_kg, 6.0);
  double carried_n = 0.0;  // the encoders' steps let the joints tremble: a mean
  constexpr int kTicks = 500;
  for (int i = 0; i < kTicks; ++i) {
    held.tick();
    for (const auto& foot : held.robot.truth().corner_force_n) {
      for (const double corner_n : foot) carried_n += corner_n / kTicks;
    }
  }
  EXPECT_NEAR(carried_n, 81.0 * kGravityM_S2, 1.0);
}

// Hung on and taken off: the trunk has its own mass, centre of mass and inertia again, not nearly.
TEST(Removal, LeavesTheTrunkAsItWas) {
  for (const PayloadInertia inertia : {PayloadInertia::kThesis, PayloadInertia::kExact}) {
    World world(SimConfig{}, testing::stance({}));
    const TrunkMass before = world.robot().trunk();
    const auto feet = [&] { return world.robot().foot_motion(Side::kLeft).position_m; };
    const btVector3 foot = feet();
    world.hang({.mass_kg = 15.0, .position_m = {0.2, 0.1, 0.4}, .inertia = inertia});
    world.hang({.mass_kg = 7.0, .position_m = {-0.2, 0.0, 0.3}, .inertia = inertia});
    world.take_off(0);
    world.take_off(1);
    world.take_off(1);  // nothing hangs there any more
    EXPECT_EQ(world.robot().trunk().mass_kg, before.mass_kg);
    EXPECT_EQ(world.robot().trunk().com_body_m, before.com_body_m);
    EXPECT_EQ(world.robot().trunk().inertia_kg_m2, before.inertia_kg_m2);
    EXPECT_LT((feet() - foot).length(), 1e-12);
    EXPECT_NEAR(world.robot().total_mass_kg(), 80.0, 1e-12);
    EXPECT_EQ(world.payloads_removed(), 2);
    EXPECT_EQ(world.removed_kg(), 22.0);
  }
}

// Statics: the ZMP moves by mass times place over all masses. Back, left, right.
TEST(SideLoad, MovesTheZmpToItsSide) {
  for (const auto& [x_m, y_m] : {std::pair{-0.2, 0.0}, {0.0, 0.3}, {0.0, -0.3}}) {
    testing::StandingRobot robot({});
    robot.world.hang({.mass_kg = 10.0, .position_m = {x_m, y_m, 0.25}});
    EXPECT_NEAR(robot.world.robot().trunk().com_body_m.y(), 10.0 * y_m / 60.0, 1e-15);
    robot.stand(2.0);
    EXPECT_NEAR(robot.zmp_x_body_m(), (10.0 * x_m - 2.5 - 0.3) / 90.0, 0.003);
    const double roll_moment =
        robot.world.loads()[0].normal_moment_world_nm.y() + robot.world.loads()[1].normal_moment_world_nm.y();
    EXPECT_NEAR(roll_moment / robot.carried_n() - robot.world.robot().body_position_world_m().y(), 10.0 * y_m / 90.0,
                0.003);
  }
}

}  // namespace
}  // namespace surefoot::sim_hw
