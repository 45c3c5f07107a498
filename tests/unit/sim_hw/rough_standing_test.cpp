#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "sim_hw/world/terrain.hpp"
#include "tests/unit/sim_hw/standing.hpp"
#include "tests/unit/sim_hw/wire.hpp"

namespace surefoot::sim_hw {
namespace {

using testing::StandingRobot;

constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;
constexpr double kWeightN = 80.0 * kGravityM_S2;

SimConfig on_tiles(double edge_m, std::uint64_t seed, ContactModel model = ContactModel::kSpringDamper) {
  SimConfig config;
  config.contact.model = model;
  config.terrain = {.tile_height_m = 0.004, .tile_edge_m = edge_m, .tile_seed = seed};
  return config;
}

/// How a robot stands, as a mean: Bullet's rigid contacts tremble.
struct Stand {
  double roll_deg = 0.0;
  double pitch_deg = 0.0;
  double height_m = 0.0;
  double carried_n = 0.0;
};

Stand settled(const SimConfig& config) {
  StandingRobot robot(config);
  robot.stand(1.0);
  Stand mean;
  constexpr int kTicks = 500;
  for (int i = 0; i < kTicks; ++i) {
    robot.tick();
    const geometry::Matrix3 rotation = robot.world.robot().rotation_world_from_body();
    mean.roll_deg += std::atan2(rotation(2, 1), rotation(2, 2)) * kDegreesPerRadian / kTicks;
    mean.pitch_deg -= std::asin(rotation(2, 0)) * kDegreesPerRadian / kTicks;
    mean.height_m += robot.world.robot().body_position_world_m().z() / kTicks;
    mean.carried_n += robot.carried_n() / kTicks;
  }
  return mean;
}

// On tiles of 100 mm every corner stands 20 mm or more from an edge, farther than the radius of Bullet's spheres.
TEST(RoughStanding, SpringsAndBulletsBoxesTiltTheRobotAlikeOnTheSameTiles) {
  double largest_deg = 0.0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Stand sprung = settled(on_tiles(0.1, seed));
    const Stand boxed = settled(on_tiles(0.1, seed, ContactModel::kBullet));
    EXPECT_NEAR(sprung.carried_n, kWeightN, 0.001 * kWeightN);
    EXPECT_NEAR(boxed.carried_n, kWeightN, 0.01 * kWeightN);
    EXPECT_NEAR(boxed.roll_deg, sprung.roll_deg, 0.1) << seed;
    EXPECT_NEAR(boxed.pitch_deg, sprung.pitch_deg, 0.1) << seed;
    EXPECT_NEAR(boxed.height_m, sprung.height_m, 0.0005);
    largest_deg = std::max({largest_deg, std::abs(sprung.roll_deg), std::abs(sprung.pitch_deg)});
  }
  EXPECT_GT(largest_deg, 0.3) << "the tiles are felt";
}

SimConfig on_patches(std::vector<PatchConfig> patches, ContactModel model) {
  SimConfig config;
  config.contact.model = model;
  config.terrain.patches = std::move(patches);
  return config;
}

TEST(RoughStanding, OnARampTheRobotLeansByItsAngleOnEitherFloor) {
  for (const ContactModel model : {ContactModel::kSpringDamper, ContactModel::kBullet}) {
    const Stand stand = settled(on_patches(
        {{.kind = PatchKind::kRamp, .centre_m = {0.0, 0.0}, .size_m = {2.0, 2.0}, .height_m = 0.04}}, model));
    EXPECT_NEAR(stand.pitch_deg, -std::atan(0.02) * kDegreesPerRadian, 0.15);
    EXPECT_NEAR(stand.roll_deg, 0.0, 0.1);
    EXPECT_NEAR(stand.carried_n, kWeightN, 0.01 * kWeightN);
  }
}

// The right sole on a plate of 4 mm: the soles stay parallel, so each stands on one edge or the drives give way.
TEST(RoughStanding, OnAPlateUnderOneFootTheRobotLeansToTheOtherOnEitherFloor) {
  for (const ContactModel model : {ContactModel::kSpringDamper, ContactModel::kBullet}) {
    const Stand stand =
        settled(on_patches({{.centre_m = {0.0, -0.5}, .size_m = {2.0, 1.0}, .height_m = 0.004}}, model));
    EXPECT_LT(stand.roll_deg, -0.5 * std::atan(0.004 / 0.22) * kDegreesPerRadian);
    EXPECT_GT(stand.roll_deg, -1.5 * std::atan(0.004 / 0.22) * kDegreesPerRadian);
    EXPECT_NEAR(stand.carried_n, kWeightN, 0.01 * kWeightN);
  }
}

// Coulomb on a lean of 3 degrees, tan 0.0524: a sheet of friction 0.02 lets the robot slide where 0.7 holds it.
TEST(RoughStanding, OnASlipperyPatchTheRobotSlidesDownhillOnEitherFloor) {
  for (const ContactModel model : {ContactModel::kSpringDamper, ContactModel::kBullet}) {
    for (const double friction : {0.02, 0.5}) {
      SimConfig config = on_patches(
          {{.kind = PatchKind::kFriction, .centre_m = {0.0, 0.0}, .size_m = {2.0, 2.0}, .friction = friction}}, model);
      config.contact.slope_pitch_deg = 3.0;
      StandingRobot robot(config);
      robot.stand(1.0);
      EXPECT_EQ(robot.world.robot().body_position_world_m().x() > 0.05, friction == 0.02) << friction;
    }
  }
}

// The corners that touch carry the weight in the very first pose, whatever the tiles; and nothing is thrown up.
TEST(RoughStanding, BeginsWithItsWeightOnTheFloorAndWithoutAJump) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    StandingRobot robot(on_tiles(0.03, seed));
    EXPECT_NEAR(robot.carried_n(), kWeightN, 1e-9 * kWeightN);
    const double start_m = robot.world.robot().body_position_world_m().z();
    double highest_m = start_m;
    for (int i = 0; i < 200; ++i) {
      robot.tick();
      highest_m = std::max(highest_m, robot.world.robot().body_position_world_m().z());
    }
    EXPECT_LT(highest_m, start_m + 2e-4);
  }
}

TEST(RoughStanding, OnBulletsBoxesBeginsAtTheHighestTile) {
  StandingRobot robot(on_tiles(0.03, 3, ContactModel::kBullet));
  const Terrain terrain({.tile_height_m = 0.004, .tile_seed = 3}, 0.7);
  const geometry::RobotGeometry geometry;
  double highest_m = 0.0;
  double sole_m = 0.0;
  for (const Side side : kSides) {
    const BodyMotion foot = robot.world.robot().foot_motion(side);
    sole_m = foot.position_m.z();
    for (std::size_t i = 0; i < geometry::kCornersPerFoot; ++i) {
      const geometry::Vector3 corner = geometry.corner_foot_m(static_cast<geometry::Corner>(i));
      highest_m =
          std::max(highest_m, terrain.height_m(foot.position_m.x() + corner.x(), foot.position_m.y() + corner.y()));
    }
  }
  EXPECT_NEAR(sole_m, highest_m, 1e-12);
}

TEST(RoughStanding, BulletsBoxesComeInTheSameOrderInEveryRun) {
  StandingRobot one(on_tiles(0.03, 5, ContactModel::kBullet));
  StandingRobot other(on_tiles(0.03, 5, ContactModel::kBullet));
  one.stand(0.3);
  other.stand(0.3);
  EXPECT_EQ(one.world.robot().body_position_world_m(), other.world.robot().body_position_world_m());
  EXPECT_EQ(one.world.robot().angles_rad(), other.world.robot().angles_rad());
}

/// One tick of a controller that holds the first pose by the truth.
void drive(SimulatedRobot& robot, testing::Wire& wire, std::uint32_t tick, const PerSide<LegVector>& pose) {
  const auto counter = static_cast<std::uint8_t>(tick);
  const PerSide<LegVector> torque = testing::hold(pose, robot.truth().angle_rad, robot.truth().rate_rad_s);
  wire.to_robot.push_back(can::encode_sync({.tick = tick, .counter = counter}));
  if (tick == 0) {
    wire.to_robot.push_back(can::encode_heartbeat(can::Node::kController, {.tick = tick, .counter = 0},
                                                  {.state = can::NodeState::kOperational}));
  }
  for (const Side side : kSides) {
    wire.to_robot.push_back(
        can::encode_leg_command(side, {.tick = tick, .counter = counter}, {LegMode::kTorque, torque[index(side)]}));
  }
  robot.serve(wire);
}

// All that the world remembers goes into a branch: anchors and latched tiles, rotors behind flexible hips.
TEST(RoughStanding, ABranchOnTilesGoesOnAsTheOriginalDoesToTheLastBit) {
  SimConfig config = on_tiles(0.03, 2);
  config.terrain.plates_per_m2 = 5.0;
  config.drive.hip_roll_stiffness_nm_per_rad = 3000.0;
  config.contact.friction = 0.1;
  const PerSide<LegVector> pose = testing::stance(config.geometry);
  PerSide<LegVector> wanted = pose;
  wanted[0][index(LegJoint::kHipRoll)] += 0.2;  // stands badly, slides and trips
  SimulatedRobot robot(config, pose);
  testing::Wire wire;
  std::uint32_t tick = 0;
  for (; tick < 300; ++tick) drive(robot, wire, tick, wanted);
  ASSERT_EQ(robot.periods(), 300);
  ASSERT_GT(robot.truth().slip_m, 1e-4);
  const std::unique_ptr<SimulatedRobot> branch = robot.branch(config);
  testing::Wire branch_wire;
  for (; tick < 600; ++tick) {
    drive(robot, wire, tick, wanted);
    drive(*branch, branch_wire, tick, wanted);
    ASSERT_EQ(robot.truth().body_position_world_m, branch->truth().body_position_world_m) << tick;
    ASSERT_EQ(robot.truth().angle_rad, branch->truth().angle_rad);
    ASSERT_EQ(robot.truth().corner_force_n, branch->truth().corner_force_n);
  }
  EXPECT_TRUE(std::ranges::equal(wire.from_robot.end() - 100, wire.from_robot.end(), branch_wire.from_robot.end() - 100,
                                 branch_wire.from_robot.end(),
                                 [](const can::CanFrame& a, const can::CanFrame& b) {
                                   return a.identifier == b.identifier && std::ranges::equal(a.bytes(), b.bytes());
                                 }))
      << "what the encoders see as well";
}

}  // namespace
}  // namespace surefoot::sim_hw
