#include <gtest/gtest.h>

#include <cmath>

#include "firmware/core/stabilizer/upright_pose.hpp"
#include "tests/unit/firmware_core/stabilizer_moments.hpp"

namespace surefoot::stabilizer {
namespace {

using testing::kDegree;

constexpr double kSlope_rad = 3.0 * kDegree;

/// A robot whose torso leans as the floor does, less what the legs and ankles make up for.
Adjustment stood_on_slope(const UprightPoseConfig& config, double roll_rad, double pitch_rad, double time_s,
                          double period_s, double* least_error_rad = nullptr) {
  UprightPoseState state;
  Adjustment made;
  const auto ticks = static_cast<int>(std::lround(time_s / period_s));
  for (int tick = 0; tick < ticks; ++tick) {
    StabilizerInput input = testing::standing(period_s);
    const double made_roll_rad =
        std::atan((made.leg_length_m[index(Side::kRight)] - made.leg_length_m[index(Side::kLeft)]) / 0.142);
    input.measured.torso_roll_rad = roll_rad - made_roll_rad;
    input.measured.torso_pitch_rad = pitch_rad - made.ankle_pitch_rad[0];
    if (least_error_rad != nullptr) *least_error_rad = std::min(*least_error_rad, input.measured.torso_roll_rad);
    made = step(config, state, input, true);
  }
  return made;
}

// Kim, Park, Oh 2007, Fig. 25a: 3 degrees over 142 mm are 7.44 mm, half on each leg.
TEST(UprightPose, StandsUprightOnAThreeDegreeSlopeWithinFifteenSecondsWithoutOvershoot) {
  for (const double period_s : {0.25e-3, 1e-3, 10e-3}) {
    double least_error_rad = 1.0;
    const Adjustment made = stood_on_slope({}, kSlope_rad, 0.0, 15.0, period_s, &least_error_rad);
    EXPECT_NEAR(made.leg_length_m[index(Side::kRight)], 3.72e-3, 0.1e-3);
    EXPECT_NEAR(made.leg_length_m[index(Side::kLeft)], -3.72e-3, 0.1e-3);
    for (const Side side : kSides) EXPECT_NEAR(made.ankle_roll_rad[index(side)], kSlope_rad, 0.1 * kDegree);
    EXPECT_GE(least_error_rad, 0.0);
  }
}

TEST(UprightPose, TurnsBothAnklesForwardOnASlopeThatFallsForward) {
  const Adjustment made = stood_on_slope({}, 0.0, -kSlope_rad, 15.0, 1e-3);
  for (const Side side : kSides) {
    EXPECT_NEAR(made.ankle_pitch_rad[index(side)], -kSlope_rad, 0.1 * kDegree);
    EXPECT_EQ(made.ankle_roll_rad[index(side)], 0.0);
    EXPECT_EQ(made.leg_length_m[index(side)], 0.0);
  }
}

// Kp 0.5, Ki 3/16, filter 3 s: both poles at -1/4, torso angle phi (1 + t/12) exp(-t/4).
TEST(UprightPose, FollowsTheClosedFormOfItsLoop) {
  UprightPoseConfig config;
  config.kp = 0.5;
  config.ki_per_s = 0.1875;
  config.filter_s = 3.0;
  for (const double time_s : {0.5, 2.0, 5.0, 12.0}) {
    const Adjustment made = stood_on_slope(config, 0.0, kSlope_rad, time_s, 1e-3);
    const double left_rad = kSlope_rad * (1.0 + time_s / 12.0) * std::exp(-time_s / 4.0);
    EXPECT_NEAR(made.ankle_pitch_rad[0], kSlope_rad - left_rad, 1e-3 * kSlope_rad) << time_s;
  }
}

TEST(UprightPose, IsSilentWhileTheTorsoMovesAsOnTheFlat) {
  UprightPoseState state;
  StabilizerInput input = testing::lifting(Side::kLeft, 0.3);
  input.measured.torso_roll_rad = input.nominal.torso_roll_rad = 0.02;
  input.measured.torso_pitch_rad = input.nominal.torso_pitch_rad = -0.01;
  for (int tick = 0; tick < 1000; ++tick) {
    const Adjustment made = step(UprightPoseConfig{}, state, input, true);
    EXPECT_EQ(made.ankle_roll_rad[0], 0.0);
    EXPECT_EQ(made.ankle_pitch_rad[0], 0.0);
  }
}

TEST(UprightPose, StopsAtItsLimitAndComesBackFromThereWithoutDelay) {
  UprightPoseState state;
  StabilizerInput input = testing::standing(10e-3);
  input.measured.torso_roll_rad = 0.4;
  Adjustment made;
  for (int tick = 0; tick < 6000; ++tick) made = step(UprightPoseConfig{}, state, input, true);
  EXPECT_DOUBLE_EQ(made.ankle_roll_rad[0], 0.15);
  input.measured.torso_roll_rad = -0.4;
  for (int tick = 0; tick < 400; ++tick) made = step(UprightPoseConfig{}, state, input, true);
  EXPECT_LT(made.ankle_roll_rad[0], 0.1);
}

TEST(UprightPose, FadesWithoutAJumpWhenItMayNotAct) {
  UprightPoseState state;
  StabilizerInput input = testing::standing();
  input.measured.torso_roll_rad = 0.05;
  double before_rad = 0.0;
  for (int tick = 0; tick < 5000; ++tick) before_rad = step(UprightPoseConfig{}, state, input, true).ankle_roll_rad[0];
  const double first_rad = step(UprightPoseConfig{}, state, input, false).ankle_roll_rad[0];
  EXPECT_NEAR(first_rad, before_rad, 0.005 * before_rad);
  double last_rad = first_rad;
  for (int tick = 0; tick < 3000; ++tick) last_rad = step(UprightPoseConfig{}, state, input, false).ankle_roll_rad[0];
  EXPECT_LT(last_rad, 0.01 * before_rad);
}

}  // namespace
}  // namespace surefoot::stabilizer
