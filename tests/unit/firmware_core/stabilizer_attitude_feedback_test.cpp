#include <gtest/gtest.h>

#include <cmath>

#include "firmware/core/stabilizer/attitude_feedback.hpp"
#include "tests/unit/firmware_core/compliant_ankle.hpp"
#include "tests/unit/firmware_core/flat_walk.hpp"

namespace surefoot::stabilizer {
namespace {

const AttitudeFeedbackConfig kConfig{};

// A floor tilted by d leans the body by d (K/ml^2) / (K/ml^2 - g/l); ankles that answer the lean with a gain of 1.8
// leave d (K/ml^2) / ((1 + 1.8) K/ml^2 - g/l): 31 % of it. The rate's share ends the swing.
TEST(AttitudeFeedback, LeavesTheShareOfASlopeThatItsGainSaysOnBothAxes) {
  for (const bool is_pitch : {false, true}) {
    for (const double floor_rad : {0.02, -0.02}) {
      CompliantAnkle plant;
      AttitudeFeedbackState state;
      double command_rad = floor_rad;
      for (int k = 0; k < 6000; ++k) {
        StabilizerInput input = standing_on(Side::kRight, 1.0e-3);
        is_pitch ? lean_back(input, plant, command_rad) : lean_left(input, plant, command_rad);
        const Adjustment adjustment = step(kConfig, state, input, true);
        command_rad = floor_rad + (is_pitch ? adjustment.ankle_pitch_rad[0] : adjustment.ankle_roll_rad[0]);
        plant.advance(command_rad, 1.0e-3);
      }
      const double spring = plant.spring_per_s2();
      const double left = spring / (2.8 * spring - CompliantAnkle::kGravity_m_s2 / CompliantAnkle::kLength_m);
      EXPECT_NEAR(plant.lean_rad, left * floor_rad, 0.03 * std::abs(floor_rad)) << is_pitch;
    }
  }
}

TEST(AttitudeFeedback, StaysWithinFourDegrees) {
  AttitudeFeedbackState state;
  StabilizerInput input = standing_on(Side::kLeft, 1.0e-3);
  input.measured.torso_roll_rad = 1.0;
  input.measured.torso_pitch_rad = -1.0;
  Adjustment adjustment;
  for (int k = 0; k < 5000; ++k) adjustment = step(kConfig, state, input, true);
  EXPECT_NEAR(adjustment.ankle_roll_rad[1], 0.07, 1e-9);
  EXPECT_NEAR(adjustment.ankle_pitch_rad[1], -0.07, 1e-9);
  EXPECT_EQ(adjustment.ankle_roll_rad[0], 0.0);
}

// Two equal springs give one moment on the body; it must not change while the load goes over, nor a foot's angle jump.
TEST(AttitudeFeedback, HandsOverFromFootToFootWithTheLoad) {
  AttitudeFeedbackState state;
  StabilizerInput input = standing_on(Side::kRight, 1.0e-3);
  input.measured.torso_roll_rad = 0.01;
  for (int k = 0; k < 2000; ++k) (void)step(kConfig, state, input, true);
  Adjustment before = with_ankles(state.added_angle);
  for (int k = 0; k <= 100; ++k) {
    const double share = k < 50 ? 0.3 : 1.0;
    input.ankle[0].normal_force_n = (1.0 - share) * FlatWalk::kWeight_n;
    input.ankle[1].normal_force_n = share * FlatWalk::kWeight_n;
    const Adjustment now = step(kConfig, state, input, true);
    EXPECT_NEAR(now.ankle_roll_rad[0] + now.ankle_roll_rad[1], 0.018, 1e-6);
    for (const Side side : kSides) {
      EXPECT_LE(std::abs(now.ankle_roll_rad[index(side)] - before.ankle_roll_rad[index(side)]), 0.001) << k;
    }
    before = now;
  }
  EXPECT_NEAR(before.ankle_roll_rad[1], 0.018, 2e-3);
}

TEST(AttitudeFeedback, GivesNoAngleToAFootWithoutLoad) {
  AttitudeFeedbackState state;
  StabilizerInput input = standing_on(Side::kRight, 1.0e-3);
  input.measured.torso_roll_rad = 0.05;
  input.ankle[0].normal_force_n = 48.0;
  for (int k = 0; k < 500; ++k) EXPECT_EQ(step(kConfig, state, input, true).ankle_roll_rad, (PerSide<double>{}));
}

// Two feet side by side hold the roll by their legs. Their pitch is held when the robot is switched on, and goes over
// to the upright pose: after t seconds exp(-t / 3 s) of it is left.
TEST(AttitudeFeedback, HoldsThePitchAloneWhileTheRobotBeginsToStand) {
  AttitudeFeedbackState state;
  StabilizerInput input = standing_on(Side::kRight, 1.0e-3);
  input.walk.stage = decision::WalkStage::kStanding;
  for (auto& load : input.ankle) load.normal_force_n = 0.5 * FlatWalk::kWeight_n;
  input.measured.torso_roll_rad = 0.02;
  input.measured.torso_pitch_rad = 0.02;
  Adjustment adjustment;
  for (int k = 0; k < 1000; ++k) adjustment = step(kConfig, state, input, true);
  const double first_rad = adjustment.ankle_pitch_rad[0];
  EXPECT_NEAR(first_rad, 0.5 * 0.3 * 1.8 * 0.02 * std::exp(-1.0 / 3.0), 2e-5);
  for (int k = 0; k < 3000; ++k) adjustment = step(kConfig, state, input, true);
  EXPECT_NEAR(adjustment.ankle_pitch_rad[0], first_rad * std::exp(-1.0), 2e-5);
  EXPECT_EQ(adjustment.ankle_pitch_rad[0], adjustment.ankle_pitch_rad[1]);
  EXPECT_EQ(adjustment.ankle_roll_rad, (PerSide<double>{}));
}

}  // namespace
}  // namespace surefoot::stabilizer
