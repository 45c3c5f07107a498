// A copy of the robot goes on as the original does.
#include "sim_hw/world/tree_body.hpp"

#include <gtest/gtest.h>

#include "sim_hw/world/world.hpp"

namespace surefoot::sim_hw {
namespace {

constexpr double kStepS = 5.0e-4;

PerSide<LegVector> bent() {
  PerSide<LegVector> angle{};
  for (LegVector& leg : angle) leg = {0.0, 0.02, -0.4, 0.8, -0.4, -0.02};
  return angle;
}

void expect_same_bits(const World& a, const World& b) {
  EXPECT_EQ(a.robot().angles_rad(), b.robot().angles_rad());
  EXPECT_EQ(a.robot().rates_rad_s(), b.robot().rates_rad_s());
  EXPECT_EQ(a.robot().body_position_world_m(), b.robot().body_position_world_m());
  EXPECT_EQ(a.robot().body_velocity_world_m_s(), b.robot().body_velocity_world_m_s());
  EXPECT_EQ(a.robot().rotation_world_from_body(), b.robot().rotation_world_from_body());
  EXPECT_EQ(a.robot().body_rate_body_rad_s(), b.robot().body_rate_body_rad_s());
  EXPECT_EQ(a.robot().total_mass_kg(), b.robot().total_mass_kg());
  EXPECT_EQ(a.slip_m(), b.slip_m());
}

void advance(World& world, int steps, double torque_nm) {
  PerSide<LegVector> torque{};
  for (int step = 0; step < steps; ++step) {
    for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
      torque[0][joint] = torque_nm * static_cast<double>(joint);
      torque[1][joint] = -0.5 * torque_nm;
    }
    world.advance(torque, kStepS);
  }
}

TEST(TreeBody, ACopyTakesTheSameStepsToTheLastBit) {
  World original(SimConfig{}, bent());
  advance(original, 137, 5.0);
  original.hang(PayloadConfig{});
  advance(original, 100, -3.0);  // soles slide, anchors have moved
  World copy(original);
  expect_same_bits(original, copy);
  for (int round = 0; round < 20; ++round) {
    advance(original, 25, 2.0);
    advance(copy, 25, 2.0);
    expect_same_bits(original, copy);
  }
}

TEST(TreeBody, ACopyIsNoPartOfTheOriginal) {
  World original(SimConfig{}, bent());
  World untouched(SimConfig{}, bent());
  {
    World copy(original);
    copy.hang(PayloadConfig{.mass_kg = 30.0});
    advance(copy, 200, 40.0);
  }
  advance(original, 50, 1.0);
  advance(untouched, 50, 1.0);
  expect_same_bits(original, untouched);
}

}  // namespace
}  // namespace surefoot::sim_hw
