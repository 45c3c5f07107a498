#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "firmware/core/gait/floor_walk.hpp"
#include "firmware/core/kinematics/leg_kinematics.hpp"

namespace surefoot::gait {
namespace {

using decision::WalkStage;
using planning::WalkingPattern;

constexpr double kTick_s = 1e-3;

PlannedGait gait_of(WalkingPattern pattern, double step_length_m, double single_support_s, std::uint32_t steps) {
  PlannedGait gait;
  gait.steps = steps;
  gait.plan.pattern = pattern;
  gait.plan.gait.com_height_m = 0.57;
  gait.plan.gait.step_length_m = step_length_m;
  gait.plan.gait.single_support_s = single_support_s;
  gait.plan.gait.double_support_s = 0.25 * single_support_s;
  gait.plan.gait.single_support_share =
      planning::continuous_single_support_share(0.57, single_support_s, 0.25 * single_support_s).value();
  gait.plan.foot.toe_m = 0.128;
  gait.plan.foot.heel_m = 0.105;
  gait.plan.foot.toe_angle_rad = gait.plan.foot.heel_angle_rad = 0.12;
  gait.plan.foot.top_z_m = 0.05;
  return gait;
}

/// What the legs are told, tick by tick, on a floor where every foot is loaded as planned.
struct Told {
  std::vector<FootReference> feet;
  std::vector<WalkStage> stage;
};

/// Slow, fast, slow, feet closed, at rest.
Told walk_through(WalkingPattern pattern) {
  WalkParameters walk;
  walk.foot_offset_y_m = 0.071;
  walk.body_height_m = 0.63;
  FourFactorParameters parameters;
  parameters.standing_s = 0.5;
  parameters.gaits.gait[0] = gait_of(pattern, 0.08, 1.2, 3);
  parameters.gaits.gait[1] = gait_of(pattern, 0.16, 0.8, 3);
  parameters.gaits.gait[2] = gait_of(pattern, 0.10, 1.0, 2);
  parameters.gaits.count = 3;
  FloorWalkState state;
  PerSide<estimation::AnkleLoad> load{};
  for (auto& foot : load) foot.normal_force_n = 275.0;
  Told told;
  for (int tick = 0; tick < 18'000; ++tick) {
    const stabilizer::WalkView view = advance(walk, parameters, state, load, {}, false, kTick_s);
    told.feet.push_back(foot_reference(walk, parameters, state, {}));
    told.stage.push_back(view.stage);
  }
  return told;
}

class PlannedFloorWalk : public ::testing::TestWithParam<WalkingPattern> {};

INSTANTIATE_TEST_SUITE_P(OfEachPattern, PlannedFloorWalk,
                         ::testing::Values(WalkingPattern::kFlatFeet, WalkingPattern::kRolledTogether,
                                           WalkingPattern::kRolledInTurn));

// Through start, two changes of gait, the closing step and the stop: no step in position or velocity. What is left is
// the acceleration, of the feet at their quickest 20 m/s2 and 70 rad/s2.
TEST_P(PlannedFloorWalk, TellsTheLegsNoJump) {
  const Told told = walk_through(GetParam());
  for (std::size_t i = 2; i < told.feet.size(); ++i) {
    for (const Side side : kSides) {
      const auto& now = told.feet[i][index(side)];
      const auto& before = told.feet[i - 1][index(side)];
      const auto& earlier = told.feet[i - 2][index(side)];
      const geometry::Vector3 bend_m = now.position_body_m - 2.0 * before.position_body_m + earlier.position_body_m;
      ASSERT_LT(bend_m.norm(), 2.5e-5) << "at tick " << i;
      ASSERT_LT(std::abs(now.pitch_rad - 2.0 * before.pitch_rad + earlier.pitch_rad), 1e-4) << "at tick " << i;
    }
  }
}

TEST_P(PlannedFloorWalk, TakesItsStepsClosesItsFeetAndStands) {
  const Told told = walk_through(GetParam());
  int lifts = 0;
  for (std::size_t i = 1; i < told.stage.size(); ++i) {
    lifts += decision::is_lifting(told.stage[i]) && !decision::is_lifting(told.stage[i - 1]) ? 1 : 0;
  }
  EXPECT_EQ(lifts, 3 + 3 + 2 + 1);
  EXPECT_EQ(told.stage.back(), WalkStage::kStanding);
  for (const Side side : kSides) {
    const FootPath& foot = told.feet.back()[index(side)];
    EXPECT_NEAR(foot.position_body_m.x(), 0.0, 1e-9);
    EXPECT_NEAR(foot.position_body_m.y(), lateral_sign(side) * 0.071, 1e-9);
    EXPECT_NEAR(foot.position_body_m.z(), -0.63, 1e-9);
    EXPECT_NEAR(foot.pitch_rad, 0.0, 1e-12);
  }
}

TEST_P(PlannedFloorWalk, NeverPutsASoleBelowTheFloor) {
  for (const FootReference& feet : walk_through(GetParam()).feet) {
    for (const FootPath& foot : feet) {
      const double toe_m = foot.position_body_m.z() - 0.128 * std::sin(foot.pitch_rad);
      const double heel_m = foot.position_body_m.z() + 0.105 * std::sin(foot.pitch_rad);
      EXPECT_GE(std::min(toe_m, heel_m), -0.63 - 1e-9);
    }
  }
}

// Joint angles of a rolled foot, taken through the legs again, give the foot that was asked for.
TEST(PlannedFloorWalkKinematics, RolledFeetComeBackFromTheJoints) {
  geometry::RobotGeometry robot;
  robot.hip_x_body_m = 0.0;
  robot.hip_y_body_m = 0.071;
  robot.thigh_m = 0.29;
  robot.calf_m = 0.28;
  for (const FootReference& feet : walk_through(WalkingPattern::kRolledInTurn).feet) {
    const JointReference joints = kinematics::inverse(robot, feet);
    ASSERT_TRUE(joints.is_reachable);
    for (const Side side : kSides) {
      const kinematics::FootPose pose = kinematics::forward(robot, side, joints.angle_rad[index(side)]);
      const FootPath& foot = feet[index(side)];
      ASSERT_NEAR((pose.position_body_m - foot.position_body_m).norm(), 0.0, 1e-12);
      ASSERT_NEAR(-pose.rotation_body_from_foot(2, 0), std::sin(foot.pitch_rad), 1e-12) << "toe down by the pitch";
      ASSERT_NEAR(pose.rotation_body_from_foot(1, 0), 0.0, 1e-12) << "the foot points ahead";
    }
  }
}

}  // namespace
}  // namespace surefoot::gait
