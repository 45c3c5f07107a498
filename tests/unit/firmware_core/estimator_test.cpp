#include "firmware/core/estimation/estimator.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "firmware/core/kinematics/leg_kinematics.hpp"

namespace surefoot::estimation {
namespace {

const EstimatorConfig kConfig{};
const geometry::RobotGeometry kRobot{};
constexpr double kGravity_m_s2 = 9.81;

/// Fresh sensors of a robot whose soles stand at x, level, with these corner forces on each foot.
SensorSnapshot standing_at(double x_m, const PerSide<std::array<double, 4>>& corner_force_n) {
  SensorSnapshot sensors;
  for (const Side side : kSides) {
    const kinematics::FootPose pose{{x_m, lateral_sign(side) * 0.11, -0.5}, geometry::Matrix3::Identity()};
    sensors.leg[index(side)].angle_rad = kinematics::inverse(kRobot, side, pose).angle_rad;
    sensors.leg[index(side)].freshness.age_ticks = 0;
    sensors.foot[index(side)].corner_force_n = corner_force_n[index(side)];
    sensors.foot[index(side)].freshness.age_ticks = 0;
  }
  return sensors;
}

/// Corner forces of one foot that carry `force_n` at `x_m` ahead of the foot frame, midway between its sides.
std::array<double, 4> foot_load(double force_n, double x_m) {
  const double front = force_n * (x_m + kRobot.sole_heel_m) / (kRobot.sole_heel_m + kRobot.sole_toe_m);
  return {0.5 * front, 0.5 * front, 0.5 * (force_n - front), 0.5 * (force_n - front)};
}

// Appendix A.9: the ZMP of the standing robot with a load m is (0.2 m - 2.5 - 0.3) / (80 + m).
TEST(Estimator, FindsTheZmpOfTheStatics) {
  for (const double mass_kg : {0.0, 2.5, 5.0, 10.0, 15.0}) {
    const double zmp_x_m = (0.2 * mass_kg - 2.8) / (80.0 + mass_kg);
    const double each_n = 0.5 * (80.0 + mass_kg) * kGravity_m_s2;
    const auto load = foot_load(each_n, zmp_x_m + 0.09);
    EstimatorState state;
    const Estimate estimate = step(kConfig, kRobot, state, standing_at(-0.09, {load, load}), 1.0e-3);
    EXPECT_NEAR(estimate.zmp_x_body_m, zmp_x_m, 1.0e-12);
    EXPECT_NEAR(estimate.zmp_y_body_m, 0.0, 1.0e-12);
    EXPECT_NEAR(estimate.vertical_force_n, 2.0 * each_n, 1.0e-9);
    EXPECT_NEAR(estimate.foot_force_n[0], each_n, 1.0e-9);
  }
}

TEST(Estimator, WeighsEveryCornerWhereItStands) {
  for (const Side side : kSides) {
    for (std::size_t corner = 0; corner < geometry::kCornersPerFoot; ++corner) {
      PerSide<std::array<double, 4>> force_n{};
      force_n[index(side)][corner] = 500.0;
      EstimatorState state;
      const Estimate estimate = step(kConfig, kRobot, state, standing_at(-0.05, force_n), 1.0e-3);
      EXPECT_NEAR(estimate.zmp_x_body_m, -0.05 + (corner < 2 ? 0.17 : -0.08), 1.0e-12);
      EXPECT_NEAR(estimate.zmp_y_body_m, lateral_sign(side) * 0.11 + (corner % 2 == 0 ? 0.069 : -0.069), 1.0e-12);
    }
  }
}

TEST(Estimator, TurnsTheCornersWithATiltedFoot) {
  PerSide<std::array<double, 4>> force_n{};
  force_n[index(Side::kLeft)][0] = 500.0;
  SensorSnapshot sensors = standing_at(-0.09, force_n);
  sensors.leg[index(Side::kLeft)].angle_rad[index(LegJoint::kAnklePitch)] += 0.1;
  const kinematics::FootPose pose = kinematics::forward(kRobot, Side::kLeft, sensors.leg[index(Side::kLeft)].angle_rad);
  const geometry::Vector3 corner =
      pose.position_body_m + pose.rotation_body_from_foot * kRobot.corner_foot_m(geometry::Corner::kFrontLeft);
  EstimatorState state;
  const Estimate estimate = step(kConfig, kRobot, state, sensors, 1.0e-3);
  EXPECT_NEAR(estimate.zmp_x_body_m, corner.x(), 1.0e-12);
  EXPECT_GT(std::abs(estimate.zmp_x_body_m - 0.08), 1.0e-3);  // else the tilt did not matter
}

// Soles from heel (x - 0.08) to toe (x + 0.17) at x = -0.09: only a cell that pulls can put the ZMP outside.
TEST(Estimator, SaysWhetherTheFilteredZmpLiesBetweenHeelAndToe) {
  for (const double zmp_x_m : {-0.175, -0.169, -0.05, 0.079, 0.085}) {
    const auto load = foot_load(400.0, zmp_x_m + 0.09);
    EstimatorState state;
    const Estimate estimate = step(kConfig, kRobot, state, standing_at(-0.09, {load, load}), 1.0e-3);
    EXPECT_NEAR(estimate.filtered_zmp_x_body_m, zmp_x_m, 1e-12);
    EXPECT_EQ(estimate.is_zmp_within_feet, zmp_x_m > -0.17 && zmp_x_m < 0.08) << zmp_x_m;
  }
}

SensorSnapshot loaded_with(double force_n, double zmp_x_m) {
  const auto load = foot_load(0.5 * force_n, zmp_x_m + 0.09);
  return standing_at(-0.09, {load, load});
}

TEST(Estimator, StartsItsFiltersAtTheFirstValueNotAtZero) {
  EstimatorState state;
  const Estimate estimate = step(kConfig, kRobot, state, loaded_with(784.8, -0.035), 1.0e-3);
  EXPECT_NEAR(estimate.filtered_force_n, 784.8, 1.0e-9);
  EXPECT_NEAR(estimate.filtered_zmp_x_body_m, -0.035, 1.0e-12);
}

/// Filtered values some time after a step from 700 to 800 N and from -0.035 to 0.005 m.
Estimate after_step(double time_s, double period_s) {
  EstimatorState state;
  Estimate estimate = step(kConfig, kRobot, state, loaded_with(700.0, -0.035), period_s);
  const SensorSnapshot after = loaded_with(800.0, 0.005);
  const auto ticks = static_cast<int>(std::lround(time_s / period_s));
  for (int k = 0; k < ticks; ++k) estimate = step(kConfig, kRobot, state, after, period_s);
  return estimate;
}

// (3.7) and (3.18): 63.2 % of a step after one time constant. A filter fed with its own value in the last
// term, as (3.18) is printed, would never move.
TEST(Estimator, ReachesSixtyThreePercentAfterOneTimeConstant) {
  const double reached = 1.0 - std::exp(-1.0);
  EXPECT_NEAR(after_step(0.09975, 0.25e-3).filtered_force_n, 700.0 + 100.0 * reached, 1.0e-6);
  EXPECT_NEAR(after_step(0.99975, 0.25e-3).filtered_zmp_x_body_m, -0.035 + 0.04 * reached, 1.0e-9);
}

TEST(Estimator, FiltersAlikeAtEveryRate) {
  EXPECT_NEAR(after_step(0.3, 1.0e-3).filtered_force_n, after_step(0.3, 0.5e-3).filtered_force_n, 1.0e-9);
  EXPECT_NEAR(after_step(0.3, 1.0e-3).filtered_zmp_x_body_m, after_step(0.3, 0.5e-3).filtered_zmp_x_body_m, 1.0e-12);
}

TEST(Estimator, HasTheFactorsOfTheThesisAtItsTimeStep) {
  EstimatorState state;
  [[maybe_unused]] const Estimate estimate = step(kConfig, kRobot, state, loaded_with(784.8, -0.035), 0.5e-3);
  EXPECT_NEAR(state.force_factor, 5.0e-3, 1.0e-7);
  EXPECT_NEAR(state.zmp_factor, 5.0e-4, 1.0e-8);
}

TEST(Estimator, HoldsTheZmpWhileNobodyStands) {
  EstimatorState state;
  const Estimate standing = step(kConfig, kRobot, state, loaded_with(784.8, -0.035), 1.0e-3);
  const Estimate airborne = step(kConfig, kRobot, state, loaded_with(49.0, 0.1), 1.0e-3);
  EXPECT_EQ(airborne.zmp_x_body_m, standing.zmp_x_body_m);
  EXPECT_EQ(airborne.filtered_zmp_x_body_m, standing.filtered_zmp_x_body_m);
  EXPECT_LT(airborne.filtered_force_n, standing.filtered_force_n);
}

TEST(Estimator, HoldsWhileAFootIsSilent) {
  EstimatorState state;
  const Estimate before = step(kConfig, kRobot, state, loaded_with(784.8, -0.035), 1.0e-3);
  SensorSnapshot sensors = loaded_with(2000.0, 0.1);
  sensors.foot[index(Side::kLeft)].freshness.age_ticks = 1;
  const Estimate during = step(kConfig, kRobot, state, sensors, 1.0e-3);
  EXPECT_EQ(during.filtered_force_n, before.filtered_force_n);
  EXPECT_EQ(during.zmp_x_body_m, before.zmp_x_body_m);
  EXPECT_EQ(during.filtered_zmp_x_body_m, before.filtered_zmp_x_body_m);
}

TEST(Estimator, HoldsTheZmpAloneWhileALegIsSilent) {
  EstimatorState state;
  const Estimate before = step(kConfig, kRobot, state, loaded_with(784.8, -0.035), 1.0e-3);
  SensorSnapshot sensors = loaded_with(2000.0, 0.1);
  sensors.leg[index(Side::kRight)].freshness.age_ticks = 3;
  const Estimate during = step(kConfig, kRobot, state, sensors, 1.0e-3);
  EXPECT_GT(during.filtered_force_n, before.filtered_force_n);
  EXPECT_EQ(during.zmp_x_body_m, before.zmp_x_body_m);
}

TEST(Estimator, StaysAtZeroUntilEveryNodeWasHeard) {
  EstimatorState state;
  const Estimate nothing = step(kConfig, kRobot, state, SensorSnapshot{}, 1.0e-3);
  EXPECT_EQ(nothing.filtered_force_n, 0.0);
  EXPECT_FALSE(state.has_force);
  const Estimate first = step(kConfig, kRobot, state, loaded_with(784.8, -0.035), 1.0e-3);
  EXPECT_NEAR(first.filtered_force_n, 784.8, 1.0e-9);
}

}  // namespace
}  // namespace surefoot::estimation
