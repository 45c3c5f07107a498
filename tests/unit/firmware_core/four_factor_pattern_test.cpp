#include "firmware/core/gait/four_factor_pattern.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace surefoot::gait {
namespace {

WalkParameters khr2_walk() {
  WalkParameters walk;
  walk.single_support_s = 0.9025;
  walk.double_support_s = 0.0475;
  walk.swing_height_m = 0.04;
  return walk;
}

// Kim, Park, Oh 2007, Table 3: 5 % of 0.95 s.
TEST(FourFactorPattern, TakesTheStepTimeOfTheTable) { EXPECT_NEAR(khr2_walk().step_s(), 0.95, 1e-12); }

TEST(FourFactorPattern, BringsTheBodyOverTheFootThatStands) {
  const WalkParameters walk = khr2_walk();
  const double middle_s = 0.5 * (walk.double_support_s + walk.step_s());
  EXPECT_NEAR(sway_y_m(walk, 0.032, Side::kLeft, middle_s), -0.032, 1e-12);
  EXPECT_NEAR(sway_y_m(walk, 0.032, Side::kRight, middle_s), 0.032, 1e-12);
}

TEST(FourFactorPattern, SwaysOnWithoutAJumpIntoTheOtherFootsStep) {
  const WalkParameters walk = khr2_walk();
  EXPECT_NEAR(sway_y_m(walk, 0.06, Side::kLeft, walk.step_s()), sway_y_m(walk, 0.06, Side::kRight, 0.0), 1e-15);
  EXPECT_NEAR(sway_y_m(walk, 0.06, Side::kLeft, 0.5 * walk.double_support_s), 0.0, 1e-15);
}

// Y_zmp = A (1 + l w^2 / g): 32 mm of sway put the ZMP at 64 mm, 39 at 78 (w = pi / 0.95 s rounds to 3.3).
TEST(FourFactorPattern, PutsTheZeroMomentPointWhereThePaperPrintsIt) {
  constexpr double kRate = 3.3;
  const double factor = 1.0 + 0.9 * kRate * kRate / 9.81;
  EXPECT_NEAR(32.0 * factor, 64.0, 0.1);
  EXPECT_NEAR(39.0 * factor, 78.0, 0.1);
  EXPECT_NEAR(std::numbers::pi / khr2_walk().step_s(), kRate, 0.01);
}

TEST(FourFactorPattern, LiftsTheFootToItsHeightAtHalfAndSetsItDownAtTheEnd) {
  const WalkParameters walk = khr2_walk();
  EXPECT_EQ(swing_share(walk, 0.0), 0.0);
  EXPECT_EQ(swing_share(walk, walk.double_support_s), 0.0);
  EXPECT_NEAR(swing_share(walk, walk.step_s()), 1.0, 1e-12);
  EXPECT_EQ(swing_share(walk, 2.0), 1.0);
  EXPECT_NEAR(swing_height_m(walk, 0.5), 0.04, 1e-15);
  EXPECT_NEAR(swing_height_m(walk, 0.0), 0.0, 1e-15);
  EXPECT_NEAR(swing_height_m(walk, 1.0), 0.0, 1e-15);
  EXPECT_NEAR(swing_progress(0.0), 0.0, 1e-15);
  EXPECT_NEAR(swing_progress(0.5), 0.5, 1e-15);
  EXPECT_NEAR(swing_progress(1.0), 1.0, 1e-15);
}

}  // namespace
}  // namespace surefoot::gait
