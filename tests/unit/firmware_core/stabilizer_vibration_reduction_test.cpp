#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "firmware/core/stabilizer/vibration_reduction.hpp"
#include "tests/unit/firmware_core/stabilizer_moments.hpp"

namespace surefoot::stabilizer {
namespace {

constexpr double kStiffness = 746.2;  // k / (m l^2) in 1/s^2, Kim, Park, Oh 2007, eq. (17)
constexpr double kLeg_m = 0.57;

/// The leg swings free from 0.17 degrees: th'' = -746.2 (th - u), u a cycle late.
/// @return largest lateral acceleration of the sole after `from_s`, over the first
double left_over(const VibrationReductionConfig& config, double period_s, double from_s, Side foot = Side::kLeft) {
  const double frequency = std::sqrt(kStiffness);
  const double c = std::cos(frequency * period_s);
  const double s = std::sin(frequency * period_s);
  VibrationReductionState state;
  double angle_rad = 0.003;
  double rate_rad_s = 0.0;
  double ordered_rad = 0.0;
  double largest = 0.0;
  const double first = kStiffness * angle_rad;
  for (double time_s = 0.0; time_s < from_s + 0.5; time_s += period_s) {
    const double acting_rad = ordered_rad;
    StabilizerInput input = testing::lifting(foot, 0.2, period_s);
    const double acceleration_rad_s2 = -kStiffness * (angle_rad - acting_rad);
    input.foot_roll_rad[index(foot)] = 0.03;
    input.foot_lateral_force_m_s2[index(foot)] = kLeg_m * acceleration_rad_s2 + 9.81 * std::sin(0.03);
    ordered_rad = step(config, state, input, true).hip_roll_rad[index(foot)];
    if (time_s >= from_s) largest = std::max(largest, std::abs(acceleration_rad_s2));
    const double from_rest_rad = angle_rad - acting_rad;
    angle_rad = acting_rad + from_rest_rad * c + rate_rad_s / frequency * s;
    rate_rad_s = rate_rad_s * c - from_rest_rad * frequency * s;
  }
  return largest / first;
}

TEST(VibrationReduction, LeavesOnePercentAfterASecondAtEitherControlPeriod) {
  for (const double period_s : {0.25e-3, 1e-3, 10e-3}) {
    EXPECT_LE(left_over({}, period_s, 1.0), 0.01) << period_s;
    EXPECT_LE(left_over({}, period_s, 1.0, Side::kRight), 0.01) << period_s;
  }
  VibrationReductionConfig off;
  off.gain_s = 0.0;
  EXPECT_NEAR(left_over(off, 1e-3, 1.0), 1.0, 0.01) << "the plant itself damps nothing";
}

TEST(VibrationReduction, HearsNeitherTheTiltOfTheSoleNorMuchOfTheWalksSway) {
  VibrationReductionState state;
  double largest_rad = 0.0;
  for (int tick = 0; tick < 10000; ++tick) {
    StabilizerInput input = testing::lifting(Side::kLeft, 0.2);
    input.foot_roll_rad[index(Side::kLeft)] = 0.05;
    const double sway_m_s2 = 0.06 * 3.3 * 3.3 * std::sin(3.3 * tick * 1e-3);
    input.foot_lateral_force_m_s2[index(Side::kLeft)] = sway_m_s2 + 9.81 * std::sin(0.05);
    largest_rad = std::max(largest_rad, std::abs(step(VibrationReductionConfig{}, state, input, true).hip_roll_rad[1]));
  }
  EXPECT_LE(largest_rad, 0.1 * testing::kDegree);
}

TEST(VibrationReduction, MovesOnlyTheHipOfTheLegInTheAirAndFadesWhenItLands) {
  VibrationReductionState state;
  StabilizerInput input = testing::lifting(Side::kLeft, 0.2);
  Adjustment made;
  for (int tick = 0; tick < 60; ++tick) {
    input.foot_lateral_force_m_s2 = {3.0 * std::sin(0.027 * tick), 3.0 * std::sin(0.027 * tick)};
    made = step(VibrationReductionConfig{}, state, input, true);
    EXPECT_EQ(made.hip_roll_rad[index(Side::kRight)], 0.0);
  }
  const double held_rad = made.hip_roll_rad[index(Side::kLeft)];
  EXPECT_LT(held_rad, -1e-3);
  input.ankle[index(Side::kLeft)].normal_force_n = 60.0;
  made = step(VibrationReductionConfig{}, state, input, true);
  EXPECT_NEAR(made.hip_roll_rad[index(Side::kLeft)], held_rad * std::exp(-1e-3 / 0.05), 1e-12);
}

TEST(VibrationReduction, StaysWithinFourTenthsOfADegree) {
  VibrationReductionState state;
  for (int tick = 0; tick < 2000; ++tick) {
    StabilizerInput input = testing::lifting(Side::kRight, 0.2);
    input.foot_lateral_force_m_s2[index(Side::kRight)] = tick / 50 % 2 == 0 ? 19.0 : -19.0;
    ASSERT_LE(std::abs(step(VibrationReductionConfig{}, state, input, true).hip_roll_rad[0]),
              0.4 * testing::kDegree + 5e-5);
  }
}

}  // namespace
}  // namespace surefoot::stabilizer
