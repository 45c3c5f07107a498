#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <vector>

#include "firmware/core/planning/spline.hpp"

namespace surefoot::planning {
namespace {

TEST(Spline, IsThePolynomialThatItsConditionsAreTakenFrom) {
  // 1 - 2 t + 3 t^3 in one piece from 0.5 s to 2.5 s.
  const auto value = [](double t) { return 1.0 - 2.0 * t + 3.0 * t * t * t; };
  const auto slope = [](double t) { return -2.0 + 9.0 * t * t; };
  const Spline cubic(
      std::array{0.5, 2.5}, std::array{3},
      std::array<SplineCondition, 4>{{{0, 0, value(0.5)}, {0, 1, slope(0.5)}, {1, 0, value(2.5)}, {1, 2, 18.0 * 2.5}}});
  ASSERT_TRUE(cubic.is_determined());
  for (const double t : {0.5, 1.0, 1.7, 2.5}) {
    EXPECT_NEAR(cubic.at(t).position, value(t), 1e-11);
    EXPECT_NEAR(cubic.at(t).velocity, slope(t), 1e-11);
    EXPECT_NEAR(cubic.at(t).acceleration, 18.0 * t, 1e-11);
  }
  EXPECT_EQ(cubic.at(9.0).position, cubic.at(2.5).position) << "held behind the end";
  EXPECT_EQ(cubic.at(-9.0).position, cubic.at(0.5).position);
}

TEST(Spline, JoinsThreePiecesUpToTheAcceleration) {
  const std::array knots_s{0.0, 0.1, 0.7, 0.8};
  const Spline path(
      knots_s, std::array{4, 3, 4},
      std::array<SplineCondition, 8>{
          {{0, 0, 0.0}, {0, 1, 0.0}, {0, 2, 0.0}, {1, 0, 0.3}, {2, 0, -0.2}, {3, 0, 0.0}, {3, 1, 0.0}, {3, 2, 0.0}}});
  ASSERT_TRUE(path.is_determined());
  for (const double joint_s : {0.1, 0.7}) {
    const gait::ScalarMotion before = path.at(joint_s - 1e-13);
    const gait::ScalarMotion after = path.at(joint_s);
    EXPECT_NEAR(before.position, after.position, 1e-10);
    EXPECT_NEAR(before.velocity, after.velocity, 1e-9);
    EXPECT_NEAR(before.acceleration, after.acceleration, 1e-7);
  }
  EXPECT_NEAR(path.at(0.1).position, 0.3, 1e-12);
  EXPECT_NEAR(path.at(0.7).position, -0.2, 1e-12);
}

TEST(Spline, RestsAtZeroWhereItsConditionsDoNotDetermineIt) {
  const std::vector<SplineCondition> right{{0, 0, 1.0}, {1, 0, 2.0}};
  const std::array line{1};
  EXPECT_TRUE(Spline(std::array{0.0, 1.0}, line, right).is_determined());
  EXPECT_FALSE(Spline(std::array{1.0, 1.0}, line, right).is_determined()) << "no duration";
  EXPECT_FALSE(Spline(std::array{1.0, 0.0}, line, right).is_determined());
  EXPECT_FALSE(Spline(std::array{0.0, std::numeric_limits<double>::quiet_NaN()}, line, right).is_determined());
  EXPECT_FALSE(Spline(std::array{0.0, 1.0}, std::array{5}, right).is_determined());
  EXPECT_FALSE(Spline(std::array{0.0, 1.0}, std::array{2}, right).is_determined()) << "a condition too few";
  EXPECT_FALSE(
      Spline(std::array{0.0, 1.0}, line, std::vector<SplineCondition>{{0, 0, 1.0}, {0, 0, 1.0}}).is_determined())
      << "one condition twice";
  EXPECT_FALSE(
      Spline(std::array{0.0, 1.0}, line, std::vector<SplineCondition>{{0, 0, 1.0}, {7, 0, 1.0}}).is_determined());
  EXPECT_FALSE(Spline({}, {}, {}).is_determined());
  EXPECT_EQ(Spline({}, {}, {}).at(1.0).position, 0.0);
}

}  // namespace
}  // namespace surefoot::planning
