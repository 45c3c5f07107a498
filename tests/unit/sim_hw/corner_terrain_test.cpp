#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim_hw/world/corner_contact.hpp"

namespace surefoot::sim_hw {
namespace {

constexpr double kBlockKg = 40.0;
constexpr double kStepS = 5.0e-4;

BodyMotion at_rest(double x_m, double y_m, double z_m) {
  return {btMatrix3x3::getIdentity(), {x_m, y_m, z_m}, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
}

TerrainConfig patch(const PatchConfig& one) {
  TerrainConfig terrain;
  terrain.patches.push_back(one);
  return terrain;
}

/// One step of 5 mm from x = 1 m on.
TerrainConfig step_ahead() { return patch({.centre_m = {2.0, 0.0}, .size_m = {2.0, 2.0}, .height_m = 0.005}); }

// Bit for bit: a floor whose only patch is far away takes the general way through the code.
TEST(CornerTerrain, LeavesTheFlatFloorAsItIs) {
  ContactConfig config;
  config.friction = 0.3;
  CornerContact flat({}, config);
  CornerContact rough({}, config, patch({.centre_m = {900.0, 0.0}}));
  for (int i = 0; i < 200; ++i) {
    BodyMotion foot = at_rest(0.001 * i, 0.0, -1.0e-4 * std::sin(0.1 * i));
    foot.velocity_m_s = {0.3, 0.1, 0.05 * std::cos(0.1 * i)};
    foot.angular_rad_s = {0.1, -0.2, 0.3};
    const SoleWrench one = flat.step(foot);
    const SoleWrench other = rough.step(foot);
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_EQ(one.force_world_n[axis], other.force_world_n[axis]);
      ASSERT_EQ(one.torque_world_nm[axis], other.torque_world_nm[axis]);
    }
    ASSERT_EQ(one.load.sliding_n_m, other.load.sliding_n_m);
  }
}

// Without the latch an edge of 5 mm would add 3 kN a corner.
TEST(CornerTerrain, ACornerThatSlidesOverAnEdgeFeelsNoStep) {
  CornerContact contact({}, {.friction = 0.0}, step_ahead());
  const double carried_n = contact.step(at_rest(0.0, 0.0, -2.0e-4)).load.normal_sum_n();
  EXPECT_GT(carried_n, 100.0);
  for (int i = 1; i < 600; ++i) {
    BodyMotion foot = at_rest(0.005 * i, 0.0, -2.0e-4);  // all corners over the edge, and down again at the far end
    EXPECT_EQ(contact.step(foot).load.normal_sum_n(), carried_n) << foot.position_m.x();
  }
}

TEST(CornerTerrain, ACornerThatWasLiftedFindsTheSurfaceThatLiesThere) {
  CornerContact contact({}, {}, step_ahead());
  (void)contact.step(at_rest(0.0, 0.0, -2.0e-4));
  EXPECT_EQ(contact.step(at_rest(1.5, 0.0, 0.006)).load.normal_sum_n(), 0.0);
  const ContactConfig config;
  EXPECT_NEAR(contact.step(at_rest(1.5, 0.0, 0.0048)).load.normal_sum_n(),
              4.0 * config.normal_stiffness_n_per_m * 2.0e-4, 1e-6);
}

// A sole that swings 1 mm above the floor meets the side of a step of 5 mm: no force appears from nothing.
TEST(CornerTerrain, AFootThatComesInAtTheSideOfAStepIsNotThrownUp) {
  const ContactConfig config;
  CornerContact contact({}, config, step_ahead());
  BodyMotion foot = at_rest(0.5, 0.0, 0.001);
  foot.velocity_m_s = {0.4, 0.0, -0.002};
  double highest_n = 0.0;
  for (int i = 0; i < 2000; ++i) {
    foot.position_m += foot.velocity_m_s * kStepS;
    const double before_n = highest_n;
    highest_n = std::max(highest_n, contact.step(foot).load.normal_sum_n());
    // Depth grows by 1 um in a step, the damper acts at once.
    ASSERT_LE(highest_n - before_n,
              4.0 * (config.normal_stiffness_n_per_m * 1.0e-6 + config.normal_damping_n_s_per_m * 0.002) + 1e-6);
  }
  EXPECT_GT(highest_n, 100.0) << "it sinks in and is carried";
}

// Energy of a block that falls askew onto tiles, and slides on them: motion, height, sunk springs. Contact may only
// take it away.
TEST(CornerTerrain, TilesGiveASlidingBlockNoEnergy) {
  ContactConfig config;
  config.friction = 0.2;
  CornerContact contact({}, config, {.tile_height_m = 0.01});
  BodyMotion block = at_rest(0.0, 0.0, 0.03);
  block.velocity_m_s = {2.0, 0.5, 0.0};
  const auto energy_j = [&] {
    return 0.5 * kBlockKg * block.velocity_m_s.length2() + kBlockKg * kGravityM_S2 * block.position_m.z();
  };
  const double start_j = energy_j();
  double highest_j = start_j;
  for (int i = 0; i < 4000; ++i) {
    const btVector3 force = contact.step(block).force_world_n + btVector3(0.0, 0.0, -kBlockKg * kGravityM_S2);
    block.velocity_m_s += force / kBlockKg * kStepS;
    block.position_m += block.velocity_m_s * kStepS;
    highest_j = std::max(highest_j, energy_j());
  }
  EXPECT_LT(highest_j, start_j * 1.001);
  EXPECT_LT(block.velocity_m_s.length(), 1e-3) << "it lies still in the end";
  EXPECT_GT(block.position_m.x(), 0.3);
}

/// A block on a ramp of 0.1, let go.
BodyMotion on_ramp(double friction, double duration_s) {
  CornerContact contact(
      {}, {.friction = friction},
      patch({.kind = PatchKind::kRamp, .centre_m = {0.0, 0.0}, .size_m = {2.0, 2.0}, .height_m = 0.2}));
  const double angle = std::atan(0.1);
  BodyMotion block = at_rest(0.0, 0.0, 0.1);
  block.rotation_world_from_body.setEulerZYX(0.0, -angle, 0.0);  // its soles flat on it
  block.position_m.setZ(0.1 - 1.6e-4);
  for (double t = 0.0; t < duration_s; t += kStepS) {
    const btVector3 force = contact.step(block).force_world_n + btVector3(0.0, 0.0, -kBlockKg * kGravityM_S2);
    block.velocity_m_s += force / kBlockKg * kStepS;
    block.position_m += block.velocity_m_s * kStepS;
  }
  return block;
}

// Coulomb on an inclined plane: a = g (sin - mu cos) downhill along the surface; at rest where mu > tan.
TEST(CornerTerrain, ABlockOnARampSlidesAsOnAnInclinedPlane) {
  const double angle = std::atan(0.1);
  const BodyMotion slides = on_ramp(0.05, 0.4);
  const double acceleration_m_s2 = kGravityM_S2 * (std::sin(angle) - 0.05 * std::cos(angle));
  EXPECT_NEAR(slides.velocity_m_s.length(), 0.4 * acceleration_m_s2, 0.02 * acceleration_m_s2);
  EXPECT_NEAR(slides.velocity_m_s.z() / slides.velocity_m_s.x(), 0.1, 0.002);
  EXPECT_LT(slides.velocity_m_s.x(), 0.0);
  EXPECT_LT(on_ramp(0.15, 2.0).velocity_m_s.length(), 1e-6);
}

// From mu = 0.5 onto ice: v^2 falls by 2 mu g on the one and stays on the other.
TEST(CornerTerrain, ABlockKeepsItsSpeedOnAPatchWithoutFriction) {
  CornerContact contact({}, {.friction = 0.5},
                        patch({.kind = PatchKind::kFriction,
                               .centre_m = {1.0, 0.0},
                               .size_m = {1.4, 1.0},
                               .height_m = 0.0,
                               .friction = 0.0}));
  BodyMotion block = at_rest(-0.2, 0.0, -kBlockKg * kGravityM_S2 / (4.0 * 6.0e5));
  block.velocity_m_s.setX(3.0);
  double speed_in = 0.0;
  double speed_out = 0.0;
  for (int i = 0; i < 4000; ++i) {
    const btVector3 force = contact.step(block).force_world_n + btVector3(0.0, 0.0, -kBlockKg * kGravityM_S2);
    block.velocity_m_s += force / kBlockKg * kStepS;
    block.position_m += block.velocity_m_s * kStepS;
    if (block.position_m.x() < 0.45) speed_in = block.velocity_m_s.x();  // its heels are 0.08 m behind
    if (block.position_m.x() < 1.5) speed_out = block.velocity_m_s.x();  // its toes 0.17 m ahead
  }
  EXPECT_GT(speed_in, 1.0);
  EXPECT_NEAR(speed_out, speed_in, 1e-9);
  EXPECT_LT(block.velocity_m_s.x(), 1e-6) << "and stops beyond it";
}

}  // namespace
}  // namespace surefoot::sim_hw
