#include "sim_hw/world/corner_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace surefoot::sim_hw {
namespace {

constexpr double kBlockKg = 40.0;
constexpr double kStepS = 5.0e-4;

/// A block that only translates, on the four corners of one sole.
class SlidingBlock {
 public:
  explicit SlidingBlock(const ContactConfig& config) : contact_(geometry::RobotGeometry{}, config) {
    motion.rotation_world_from_body.setIdentity();
    motion.angular_rad_s.setZero();
    motion.velocity_m_s.setZero();
    motion.position_m = {0.0, 0.0, -kBlockKg * kGravityM_S2 / (4.0 * config.normal_stiffness_n_per_m)};
  }

  void push(double force_x_n, double duration_s) {
    for (double t = 0.0; t < duration_s; t += kStepS) {
      const btVector3 force = contact_.step(motion).force_world_n + btVector3(force_x_n, 0.0, -kBlockKg * kGravityM_S2);
      motion.velocity_m_s += force / kBlockKg * kStepS;
      motion.position_m += motion.velocity_m_s * kStepS;
    }
  }

  BodyMotion motion;

 private:
  CornerContact contact_;
};

ContactConfig floor_with(double friction) {
  ContactConfig config;
  config.friction = friction;
  return config;
}

TEST(CornerContact, HoldsABlockThatIsPushedLessThanFriction) {
  const ContactConfig config = floor_with(0.5);
  SlidingBlock block(config);
  const double push_n = 0.9 * 0.5 * kBlockKg * kGravityM_S2;
  block.push(push_n, 3.0);
  EXPECT_NEAR(block.motion.velocity_m_s.x(), 0.0, 1e-4);
  EXPECT_NEAR(block.motion.position_m.x(), push_n / (4.0 * config.tangential_stiffness_n_per_m), 1e-4);
  block.push(0.0, 3.0);
  EXPECT_NEAR(block.motion.position_m.x(), 0.0, 1e-4) << "a block that stuck springs back to its anchor";
}

// a = (F - mu m g) / m
TEST(CornerContact, LetsABlockGoThatIsPushedMoreThanFriction) {
  SlidingBlock block(floor_with(0.5));
  block.push(1.5 * 0.5 * kBlockKg * kGravityM_S2, 1.0);
  const double start = block.motion.velocity_m_s.x();
  block.push(1.5 * 0.5 * kBlockKg * kGravityM_S2, 1.0);
  EXPECT_NEAR(block.motion.velocity_m_s.x() - start, 0.25 * kGravityM_S2, 0.01);
}

// Coulomb: v^2 / (2 mu g), whatever the mass, less the spring that relaxes in the end; and it stays there.
TEST(CornerContact, StopsASlidingBlockAfterCoulombsDistance) {
  SlidingBlock block(floor_with(0.5));
  block.motion.velocity_m_s.setX(2.0);
  block.push(0.0, 3.0);
  const double stop_m = block.motion.position_m.x();
  const double spring_m = 0.5 * kBlockKg * kGravityM_S2 / (4.0 * 1.0e4);
  EXPECT_NEAR(stop_m, 4.0 / (2.0 * 0.5 * kGravityM_S2) - spring_m, 0.001);
  block.push(0.0, 1.0);
  EXPECT_NEAR(block.motion.position_m.x(), stop_m, 1e-4);
}

TEST(CornerContact, SlidesForeverWithoutFriction) {
  SlidingBlock block(floor_with(0.0));
  block.motion.velocity_m_s.setX(1.0);
  block.push(0.0, 1.0);
  EXPECT_DOUBLE_EQ(block.motion.velocity_m_s.x(), 1.0);
}

TEST(CornerContact, NeitherPullsNorActsAboveTheFloor) {
  CornerContact contact({}, {});
  BodyMotion foot{btMatrix3x3::getIdentity(), {0.0, 0.0, 1.0e-9}, {1.0, 0.0, -1.0}, {0.0, 0.0, 0.0}};
  EXPECT_EQ(contact.step(foot).load.normal_sum_n(), 0.0);
  EXPECT_EQ(contact.step(foot).force_world_n.length(), 0.0);
  foot.position_m.setZ(-1.0e-4);
  foot.velocity_m_s = {1.0, 0.0, 100.0};  // torn off: the damper alone would pull with 300 kN
  const SoleWrench wrench = contact.step(foot);
  EXPECT_EQ(wrench.load.normal_sum_n(), 0.0);
  EXPECT_EQ(wrench.force_world_n.length(), 0.0) << "no friction without load";
}

TEST(CornerContact, ForgetsItsAnchorWhenItLeavesTheFloor) {
  CornerContact contact({}, {});
  BodyMotion foot{btMatrix3x3::getIdentity(), {0.0, 0.0, -1.0e-4}, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
  (void)contact.step(foot);
  foot.position_m = {0.002, 0.0, -1.0e-4};
  EXPECT_LT(contact.step(foot).force_world_n.x(), -1.0);
  foot.position_m = {0.002, 0.0, 0.01};
  (void)contact.step(foot);
  foot.position_m = {0.002, 0.0, -1.0e-4};
  EXPECT_EQ(contact.step(foot).force_world_n.x(), 0.0);
}

TEST(CornerContact, TellsTheCornersApart) {
  const geometry::RobotGeometry geometry;
  CornerContact contact(geometry, {});
  // Nose down by 0.01 rad and right side down by 0.001 rad: only the front touches, the right corner more.
  btMatrix3x3 tilt;
  tilt.setEulerZYX(0.001, 0.01, 0.0);
  const BodyMotion foot{tilt, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
  const SoleLoad load = contact.step(foot).load;
  EXPECT_GT(load.normal_n[1], load.normal_n[0]);
  EXPECT_GT(load.normal_n[0], 0.0);
  EXPECT_EQ(load.normal_n[2], 0.0);
  EXPECT_EQ(load.normal_n[3], 0.0);
}

}  // namespace
}  // namespace surefoot::sim_hw
