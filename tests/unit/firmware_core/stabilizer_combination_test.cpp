#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "firmware/core/stabilizer/stabilizer.hpp"
#include "tests/unit/firmware_core/stabilizer_moments.hpp"

namespace surefoot::stabilizer {
namespace {

constexpr std::size_t at(Controller controller) { return static_cast<std::size_t>(controller); }

Switches only(std::initializer_list<Controller> controllers) {
  Switches switches{};
  for (const Controller controller : controllers) switches[at(controller)] = true;
  return switches;
}

/// A robot that leans and falls to the left, in every stage of a step of `foot` in turn.
std::vector<StabilizerInput> leaning_step(Side foot) {
  std::vector<StabilizerInput> step_inputs;
  for (int tick = 0; tick < 900; ++tick) {
    const double share = tick / 900.0;
    StabilizerInput input = share < 0.5 ? testing::lifting(foot, share) : testing::lowering(foot, share);
    input.measured.support_roll_rate_rad_s = share < 0.4 ? 0.2 : -0.6;
    step_inputs.push_back(input);
  }
  for (int tick = 0; tick < 50; ++tick) step_inputs.push_back(testing::landed(foot, 350.0));
  for (StabilizerInput& input : step_inputs) {
    input.measured.torso_roll_rad = -0.06;
    input.measured.torso_pitch_rad = 0.05;
    input.measured.torso_roll_rate_rad_s = -0.3;
    input.measured.torso_pitch_rate_rad_s = 0.2;
    input.measured.zmp_x_foot_m = 0.03;
    input.measured.zmp_y_foot_m = 0.02;
    input.foot_roll_rad = {0.03, -0.03};
    input.foot_lateral_force_m_s2 = {1.0, -1.0};
    for (const Side side : kSides) {
      input.ankle[index(side)].roll_moment_nm = 0.03 * input.ankle[index(side)].normal_force_n;
      input.ankle[index(side)].pitch_moment_nm = -0.02 * input.ankle[index(side)].normal_force_n;
    }
  }
  return step_inputs;
}

TEST(Stabilizer, AddsUpWhatEachControllerThatIsOnGivesWithinTheLimits) {
  StabilizerConfig config;
  config.is_on.fill(true);
  config.limits = {.ankle_rad = 10.0, .pelvis_m = 10.0, .leg_m = 10.0, .landing_m = 10.0};
  StabilizerState state;
  for (const Side foot : {Side::kLeft, Side::kRight}) {
    for (const StabilizerInput& input : leaning_step(foot)) {
      const StabilizerOutput output = step(config, state, input);
      Adjustment sum;
      for (const Adjustment& one : output.of) sum += one;
      ASSERT_EQ(output.total.ankle_roll_rad, sum.ankle_roll_rad);
      ASSERT_EQ(output.total.landing_y_m, sum.landing_y_m);
      ASSERT_EQ(output.total.pelvis_y_m, sum.pelvis_y_m);
      ASSERT_EQ(output.total.waits_for_contact, sum.waits_for_contact);
    }
  }
}

TEST(Stabilizer, ClipsTheSum) {
  StabilizerConfig config;
  config.is_on.fill(true);
  config.limits = {.ankle_rad = 0.001, .pelvis_m = 0.0001, .leg_m = 0.0002, .landing_m = 0.0003};
  StabilizerState state;
  double largest_ankle_rad = 0.0;
  for (const Side foot : {Side::kLeft, Side::kRight}) {
    for (const StabilizerInput& input : leaning_step(foot)) {
      const Adjustment total = step(config, state, input).total;
      for (const Side side : kSides) {
        ASSERT_LE(std::abs(total.ankle_roll_rad[index(side)]), 0.001);
        ASSERT_LE(std::abs(total.ankle_pitch_rad[index(side)]), 0.001);
        ASSERT_LE(std::abs(total.leg_length_m[index(side)]), 0.0002);
        largest_ankle_rad = std::max(largest_ankle_rad, std::abs(total.ankle_roll_rad[index(side)]));
      }
      for (const double pelvis_m : {total.pelvis_x_m, total.pelvis_y_m, total.pelvis_z_m}) {
        ASSERT_LE(std::abs(pelvis_m), 0.0001);
      }
      ASSERT_LE(std::abs(total.landing_x_m), 0.0003);
      ASSERT_LE(std::abs(total.landing_y_m), 0.0003);
    }
  }
  EXPECT_EQ(largest_ankle_rad, 0.001) << "the limit was reached";
  EXPECT_EQ(StabilizerConfig{}.limits.ankle_rad, 0.15);
  EXPECT_EQ(StabilizerConfig{}.limits.leg_m, 0.02);
}

TEST(Stabilizer, LeavesTheOutputOfAControllerThatIsOffAtZero) {
  StabilizerConfig config;
  StabilizerState state;
  for (const StabilizerInput& input : leaning_step(Side::kLeft)) {
    const Adjustment total = step(config, state, input).total;
    ASSERT_EQ(total.ankle_roll_rad[0], 0.0);
    ASSERT_EQ(total.landing_y_m, 0.0);
    ASSERT_FALSE(total.waits_for_contact);
  }
  config.is_on = only({Controller::kUprightPose});
  for (const StabilizerInput& input : leaning_step(Side::kLeft)) {
    const StabilizerOutput output = step(config, state, input);
    ASSERT_EQ(output.of[at(Controller::kAttitudeFeedback)].ankle_roll_rad[0], 0.0);
  }
  EXPECT_LT(state.upright_pose.roll.angle_rad, 0.0);
  EXPECT_EQ(state.landing_position.shift_y_m, 0.0);
}

TEST(Stabilizer, LetsTheNewLandingPositionSupersedeTheEarlierOneSideways) {
  const auto landing = [](std::initializer_list<Controller> on) {
    StabilizerConfig config;
    config.is_on = only(on);
    StabilizerState state;
    StabilizerOutput output;
    for (const StabilizerInput& input : leaning_step(Side::kLeft)) output = step(config, state, input);
    return output;
  };
  const StabilizerOutput earlier = landing({Controller::kTiltLandingPosition});
  const StabilizerOutput newer = landing({Controller::kLandingPosition});
  const StabilizerOutput both = landing({Controller::kTiltLandingPosition, Controller::kLandingPosition});
  EXPECT_GT(std::abs(earlier.total.landing_y_m), 1e-3);
  EXPECT_GT(std::abs(earlier.total.landing_x_m), 1e-3);
  EXPECT_EQ(both.total.landing_y_m, newer.total.landing_y_m);
  EXPECT_EQ(both.total.landing_x_m, earlier.total.landing_x_m);
  EXPECT_EQ(both.of[at(Controller::kTiltLandingPosition)].landing_y_m, 0.0);
}

TEST(Stabilizer, LeavesSoftLandingItsOrientationBesideTheNewLandingControllers) {
  for (const Controller beside : {Controller::kSoftLanding, Controller::kShockAbsorber, Controller::kLandingTiming}) {
    StabilizerConfig config;
    config.is_on = only({Controller::kSoftLanding, beside});
    StabilizerState state;
    StabilizerOutput output;
    for (const StabilizerInput& input : leaning_step(Side::kLeft)) output = step(config, state, input);
    const Adjustment& soft = output.of[at(Controller::kSoftLanding)];
    EXPECT_EQ(soft.waits_for_contact, beside == Controller::kSoftLanding);
    EXPECT_NE(soft.ankle_roll_rad[index(Side::kLeft)], 0.0);
  }
}

TEST(Stabilizer, KnowsThePapersThirteen) {
  const Switches paper = paper_set();
  EXPECT_EQ(std::ranges::count(paper, true), 13);
  EXPECT_FALSE(paper[at(Controller::kAttitudeFeedback)]);
  const Switches extended = extended_set();
  for (const Controller controller : {Controller::kUprightPose, Controller::kZmpCompensator, Controller::kShockAbsorber,
                                      Controller::kAttitudeFeedback, Controller::kFootTilt}) {
    EXPECT_TRUE(extended[at(controller)]) << name(controller);
  }
}

bool is_finite(const Adjustment& all) {
  double sum = all.pelvis_x_m + all.pelvis_y_m + all.pelvis_z_m + all.landing_x_m + all.landing_y_m +
               all.earlier_landing_s + all.sway_m + all.sway_centre_x_m + all.sway_centre_y_m;
  for (const Side side : kSides) {
    const std::size_t i = index(side);
    sum += all.leg_length_m[i] + all.ankle_roll_rad[i] + all.ankle_pitch_rad[i] + all.hip_roll_rad[i];
  }
  return std::isfinite(sum);
}

// A tick of garbage in every input, one input at a time; two steps later nothing of it is left.
TEST(Stabilizer, SurvivesValuesThatAreNoNumbers) {
  for (const double garbage : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                               -std::numeric_limits<double>::max()}) {
    for (int field = 0; field < 14; ++field) {
      StabilizerConfig config;
      config.is_on.fill(true);
      StabilizerState state;
      int tick = 0;
      for (const Side foot : {Side::kLeft, Side::kRight}) {
        for (StabilizerInput input : leaning_step(foot)) {
          const std::size_t support = index(input.walk.support());
          const std::size_t moving = index(input.walk.moving);
          double* const fields[] = {&input.measured.torso_roll_rad,
                                    &input.measured.torso_pitch_rad,
                                    &input.measured.torso_roll_rate_rad_s,
                                    &input.measured.torso_pitch_rate_rad_s,
                                    &input.measured.zmp_x_foot_m,
                                    &input.measured.zmp_y_foot_m,
                                    &input.measured.support_roll_rate_rad_s,
                                    &input.nominal.support_roll_rate_rad_s,
                                    &input.ankle[support].roll_moment_nm,
                                    &input.ankle[moving].normal_force_n,
                                    &input.foot_roll_rad[moving],
                                    &input.foot_lateral_force_m_s2[moving],
                                    &input.walk.swing_share,
                                    &input.period_s};
          if (tick++ % 90 == 45) *fields[field] = garbage;
          ASSERT_TRUE(is_finite(step(config, state, input).total)) << "field " << field;
        }
      }
    }
  }
}

}  // namespace
}  // namespace surefoot::stabilizer
