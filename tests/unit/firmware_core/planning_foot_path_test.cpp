#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "firmware/core/planning/foot_path.hpp"

namespace surefoot::planning {
namespace {

using gait::ScalarMotion;

constexpr double kDegree = M_PI / 180.0;
constexpr double kInstant_s = 1e-12;

FootStep step_of(double angle_deg, double top_z_m = 0.06) {
  FootStep step;
  step.top_z_m = top_z_m;
  step.toe_angle_rad = angle_deg * kDegree;
  step.heel_angle_rad = angle_deg * kDegree;
  return step;
}

void expect_near(const ScalarMotion& a, const ScalarMotion& b, double tolerance) {
  EXPECT_NEAR(a.position, b.position, tolerance);
  EXPECT_NEAR(a.velocity, b.velocity, tolerance);
  EXPECT_NEAR(a.acceleration, b.acceleration, tolerance);
}

TEST(FootPath, SetsAFlatFootDownAtRestInTheFirstCase) {
  const FootPath path(FootCase::kSoftFlat, {});
  ASSERT_TRUE(path.is_determined());
  expect_near(path.at(0.0).x_m, {-0.5, 0.0, 0.0}, 1e-10);
  expect_near(path.at(0.5).x_m, {0.5, 0.0, 0.0}, 1e-10);
  expect_near(path.at(0.0).z_m, {}, 1e-10);
  expect_near(path.at(0.5).z_m, {}, 1e-10);
  EXPECT_NEAR(path.at(0.25).z_m.position, 0.06, 1e-12);
  double speed_m_s = 0.0;
  double acceleration_m_s2 = 0.0;
  for (int i = 0; i <= 1000; ++i) {
    speed_m_s = std::max(speed_m_s, std::abs(path.at(0.0005 * i).x_m.velocity));
    acceleration_m_s2 = std::max(acceleration_m_s2, std::abs(path.at(0.0005 * i).x_m.acceleration));
  }
  EXPECT_NEAR(speed_m_s, 4.0, 1e-9);
  EXPECT_NEAR(acceleration_m_s2, 24.0, 1e-9);
}

// x = -S + 2 S (t / T)^3 lands at 6 S / T.
TEST(FootPath, LandsWithSpeedInTheSecondCase) {
  const FootPath path(FootCase::kHardFlat, {});
  ASSERT_TRUE(path.is_determined());
  for (const double share : {0.0, 0.2, 0.7, 1.0}) {
    EXPECT_NEAR(path.at(0.5 * share).x_m.position, -0.5 + share * share * share, 1e-12);
  }
  EXPECT_NEAR(path.at(0.5).x_m.velocity, 6.0, 1e-9);
  EXPECT_NEAR(path.at(0.5).z_m.velocity, -2.88, 1e-9);
  expect_near(path.at(0.0).z_m, {}, 1e-10);
}

TEST(FootPath, MovesOnExactArcsOverToeAndHeel) {
  for (const FootCase rolled : {FootCase::kSoftRolled, FootCase::kHardRolled}) {
    const FootStep step = step_of(30.0, 0.12);
    const FootPath path(rolled, step);
    ASSERT_TRUE(path.is_determined());
    for (int i = 0; i <= 50; ++i) {
      const FootPoint toe = path.at(0.02 * i * (step.toe_s - kInstant_s));
      const double pitch = toe.pitch_rad.position;
      EXPECT_NEAR(toe.x_m.position + step.toe_m * std::cos(pitch), -step.step_length_m + step.toe_m, 1e-12);
      EXPECT_NEAR(toe.z_m.position - step.toe_m * std::sin(pitch), 0.0, 1e-12);
      const FootPoint heel = path.at(path.landing_s() + 0.02 * i * step.heel_s);
      const double turn = heel.pitch_rad.position;
      EXPECT_NEAR(heel.x_m.position - step.heel_m * std::cos(turn), step.step_length_m - step.heel_m, 1e-12);
      EXPECT_NEAR(heel.z_m.position + step.heel_m * std::sin(turn), 0.0, 1e-12);
    }
  }
}

TEST(FootPath, HasNoStepInPositionVelocityOrAccelerationWhereItLiftsAndLands) {
  for (const FootCase rolled : {FootCase::kSoftRolled, FootCase::kHardRolled}) {
    for (const double angle_deg : {0.0, 12.0, 30.0}) {
      const FootPath path(rolled, step_of(angle_deg));
      for (const double time_s : {path.lift_s(), path.landing_s()}) {
        const FootPoint before = path.at(time_s - kInstant_s);
        const FootPoint after = path.at(time_s);
        expect_near(before.x_m, after.x_m, 1e-8);
        expect_near(before.z_m, after.z_m, 1e-8);
        expect_near(before.pitch_rad, after.pitch_rad, 1e-8);
      }
      expect_near(path.at(0.0).pitch_rad, {}, 1e-10);
      expect_near(path.at(path.duration_s()).pitch_rad, {}, 1e-10);
    }
  }
}

TEST(FootPath, StrikesWithTheHeelAtRestInTheThirdCaseAndWithTheKnownSpeedInTheFourth) {
  for (const double angle_deg : {12.0, 30.0}) {
    const FootPath soft(FootCase::kSoftRolled, step_of(angle_deg));
    expect_near(soft.at(soft.landing_s()).pitch_rad, {-angle_deg * kDegree, 0.0, 0.0}, 1e-10);
    EXPECT_NEAR(soft.at(soft.landing_s()).z_m.velocity, 0.0, 1e-10);
  }
  const FootPath slight(FootCase::kHardRolled, step_of(12.0));
  EXPECT_NEAR(slight.at(slight.landing_s()).x_m.velocity, 0.042, 5e-4);
  EXPECT_NEAR(slight.at(slight.landing_s()).z_m.velocity, -0.197, 5e-4);
  const FootPath large(FootCase::kHardRolled, step_of(30.0));
  EXPECT_NEAR(large.at(large.landing_s()).x_m.velocity, 0.251, 5e-4);
  EXPECT_NEAR(large.at(large.landing_s()).z_m.velocity, -0.435, 5e-4);
}

TEST(FootPath, KeepsToeAndHeelAboveTheFloor) {
  for (const FootCase rolled : {FootCase::kSoftRolled, FootCase::kHardRolled}) {
    for (const auto& [angle_deg, top_z_m] : {std::pair{12.0, 0.06}, std::pair{30.0, 0.12}}) {
      const FootStep step = step_of(angle_deg, top_z_m);
      const FootPath path(rolled, step);
      for (int i = 0; i <= 1000; ++i) {
        const FootPoint foot = path.at(0.001 * i * path.duration_s());
        const double sine = std::sin(foot.pitch_rad.position);
        EXPECT_GE(foot.z_m.position - step.toe_m * sine, -1e-12);
        EXPECT_GE(foot.z_m.position + step.heel_m * sine, -1e-12);
      }
    }
  }
}

TEST(FootPath, IsNotDeterminedByAnImpossibleStep) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const auto refuses = [](FootCase foot_case, auto change) {
    FootStep step;
    change(step);
    const FootPath path(foot_case, step);
    return !path.is_determined() && path.at(0.1).x_m.position == path.at(0.1).x_m.position;
  };
  for (const FootCase one : {FootCase::kSoftFlat, FootCase::kHardFlat, FootCase::kSoftRolled, FootCase::kHardRolled}) {
    EXPECT_TRUE(refuses(one, [](FootStep& step) { step.swing_s = 0.0; }));
    EXPECT_TRUE(refuses(one, [](FootStep& step) { step.swing_s = -1.0; }));
    EXPECT_TRUE(refuses(one, [](FootStep& step) { step.top_share = 1.0; }));
    EXPECT_TRUE(refuses(one, [](FootStep& step) { step.top_z_m = kNan; }));
  }
  EXPECT_TRUE(refuses(FootCase::kSoftRolled, [](FootStep& step) { step.heel_s = 0.0; }));
  EXPECT_TRUE(refuses(FootCase::kHardRolled, [](FootStep& step) { step.toe_s = 0.0; }));
}

}  // namespace
}  // namespace surefoot::planning
