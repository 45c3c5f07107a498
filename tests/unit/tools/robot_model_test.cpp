#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>

#include "sim_hw/world/terrain.hpp"
#include "sim_hw/world/trunk_mass.hpp"
#include "tools/robot_model/model_json.hpp"
#include "tools/robot_model/urdf.hpp"

namespace surefoot::robot_model {
namespace {

TEST(EquivalentBox, HasTheEdgesOfTheBoxThatMadeTheInertia) {
  const geometry::Vector3 size_m{0.2, 0.4, 0.5};
  Link link;
  link.mass_kg = 7.0;
  link.inertia_kg_m2 = sim_hw::box_inertia(link.mass_kg, size_m);
  EXPECT_LT((equivalent_box_m(link) - size_m).norm(), 1e-12);
}

// El-Kahlout 2003: a trunk of 50 kg, 80 kg in all.
TEST(LinkTree, HoldsTheThesisRobotsMass) {
  const LinkTree tree = link_tree({});
  double mass_kg = 0.0;
  for (const Link& link : tree.links) mass_kg += link.mass_kg;
  EXPECT_EQ(tree.links.size(), 13U);
  EXPECT_DOUBLE_EQ(tree.links.front().mass_kg, 50.0);
  EXPECT_NEAR(mass_kg, 80.0, 1e-12);
}

TEST(LinkTree, LeavesRotorInertiaOut) {
  sim_hw::SimConfig light;
  light.drive.rotor_inertia_kg_m2 = 0.0;
  const LinkTree with = link_tree({});
  const LinkTree without = link_tree(light);
  for (std::size_t i = 0; i < with.links.size(); ++i) {
    EXPECT_EQ(with.links[i].inertia_kg_m2, without.links[i].inertia_kg_m2) << with.links[i].name;
  }
}

// Legs straight: the sole lies thigh, calf and ankle height under the hip.
TEST(SimulatedPose, StandsOnStraightLegsInTheZeroPose) {
  const sim_hw::SimConfig config;
  const SimulatedPose pose = simulated_pose(config, {});
  const double down_m = config.geometry.thigh_m + config.geometry.calf_m + config.geometry.ankle_height_m;
  for (const Side side : kSides) {
    const geometry::Vector3 expected = config.geometry.hip_body_m(side) - geometry::Vector3(0.0, 0.0, down_m);
    EXPECT_LT((pose.sole_body_m[index(side)] - expected).norm(), 1e-12);
  }
}

TEST(FloorView, TilesLieWhereTheRobotFeelsThem) {
  sim_hw::SimConfig config;
  config.terrain.tile_height_m = 0.012;
  const nlohmann::ordered_json tiles = floor_json(config, {-0.1, 0.2, -0.05, 0.1})["tiles"];
  const sim_hw::Terrain terrain(config.terrain, config.contact.friction);
  const double edge_m = tiles["edge_m"];
  const std::size_t ny = tiles["ny"];
  ASSERT_EQ(tiles["height_m"].size(), tiles["nx"].get<std::size_t>() * ny);
  for (std::size_t i = 0; i < tiles["height_m"].size(); ++i) {
    const double x_m = tiles["x0_m"].get<double>() + edge_m * (static_cast<double>(i / ny) + 0.5);
    const double y_m = tiles["y0_m"].get<double>() + edge_m * (static_cast<double>(i % ny) + 0.5);
    EXPECT_EQ(tiles["height_m"][i].get<double>(), terrain.height_m(x_m, y_m));
  }
}

TEST(FloorView, AFlatFloorHasNoTilesAndNoPlates) {
  const nlohmann::ordered_json floor = floor_json({}, {});
  EXPECT_TRUE(floor["tiles"].is_null());
  EXPECT_TRUE(floor["plates"].empty());
}

TEST(FloorView, RefusesMoreTilesThanAnyoneDraws) {
  sim_hw::SimConfig config;
  config.terrain.tile_height_m = 0.012;
  EXPECT_THROW(static_cast<void>(floor_json(config, {-100.0, 100.0, -100.0, 100.0})), std::invalid_argument);
}

TEST(ModelJson, AnInstantThatNeverComesIsNull) {
  scenario::Scenario scenario;
  scenario.sim.payloads = {{}, {.mass_kg = 5.0, .at_s = 1.0, .removed_at_s = 3.0}};
  const nlohmann::ordered_json payloads = model_json(scenario, {})["payloads"];
  EXPECT_TRUE(payloads[0]["removed_at_s"].is_null());
  EXPECT_EQ(payloads[1]["removed_at_s"], 3.0);
}

TEST(ReadPoses, TakesTheRightLegFirst) {
  std::istringstream input("[[1,2,3,4,5,6,7,8,9,10,11,12]]");
  const std::vector<JointAngles> poses = read_poses(input);
  ASSERT_EQ(poses.size(), 1U);
  EXPECT_EQ(poses[0][index(Side::kRight)][0], 1.0);
  EXPECT_EQ(poses[0][index(Side::kLeft)][5], 12.0);
}

}  // namespace
}  // namespace surefoot::robot_model
