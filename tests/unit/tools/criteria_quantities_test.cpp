#include "tools/floor/criteria_quantities.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace surefoot::floor {
namespace {

using decision::WalkStage;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr double kRadian_deg = 180.0 / std::numbers::pi;

/// Adds ticks of 1 ms that look like `tick`.
void add(ObservedWalk& walk, std::size_t count, ObservedTick tick) {
  for (std::size_t i = 0; i < count; ++i) {
    tick.time_s = 1e-3 * static_cast<double>(walk.ticks.size());
    walk.ticks.push_back(tick);
    tick.walk.begins_step = false;
  }
}

ObservedTick swinging(Side foot, double share) {
  ObservedTick tick;
  tick.walk.stage = foot == Side::kLeft ? WalkStage::kLowerLeft : WalkStage::kLowerRight;
  tick.walk.is_double_support = false;
  tick.walk.moving = foot;
  tick.walk.swing_share = share;
  tick.ankle[index(opposite(foot))].normal_force_n = 550.0;
  return tick;
}

ObservedTick landed(ObservedTick tick, double force_n) {
  tick.walk.has_landed = true;
  tick.ankle[index(tick.walk.moving)].normal_force_n = force_n;
  tick.force_n[index(tick.walk.moving)] = force_n;
  return tick;
}

ObservedTick in_double_support(ObservedTick tick) {
  tick.walk.is_double_support = true;
  tick.walk.begins_step = true;
  return tick;
}

/// 100 ticks in the air, 30 with the foot down too early, 40 of double support, and the lift of the other foot.
ObservedWalk early_landing(Side foot, double share, double rate_at_contact_rad_s = 0.0,
                           double rate_at_end_rad_s = 0.0) {
  ObservedWalk walk;
  ObservedTick tick = swinging(foot, share);
  tick.hip_roll_rate_rad_s[index(opposite(foot))] = rate_at_contact_rad_s;
  add(walk, 100, tick);
  add(walk, 10, landed(tick, 120.0));
  tick.hip_roll_rate_rad_s[index(opposite(foot))] = rate_at_end_rad_s;
  add(walk, 20, landed(tick, 300.0));
  add(walk, 40, in_double_support(landed(tick, 600.0)));
  ObservedTick next = swinging(opposite(foot), 0.01);
  next.hip_roll_rate_rad_s[index(opposite(foot))] = rate_at_end_rad_s;
  add(walk, 100, next);
  return walk;
}

/// The step ends without contact; the foot carries 20 ms later.
ObservedWalk late_landing() {
  ObservedWalk walk;
  add(walk, 100, swinging(Side::kLeft, 0.99));
  add(walk, 20, in_double_support(landed(swinging(Side::kLeft, 1.0), 0.0)));
  ObservedTick carrying = in_double_support(landed(swinging(Side::kLeft, 1.0), 500.0));
  carrying.walk.begins_step = false;
  add(walk, 30, carrying);
  add(walk, 10, swinging(Side::kRight, 0.01));
  return walk;
}

TEST(Landings, TellContactEndOfLoweringAndNextLift) {
  const std::vector<Landing> early = landings_of(early_landing(Side::kRight, 0.8));
  ASSERT_EQ(early.size(), 1U);
  EXPECT_EQ(early[0].foot, Side::kRight);
  EXPECT_EQ(early[0].contact, 100U);
  EXPECT_EQ(early[0].step_end, 130U);
  EXPECT_EQ(early[0].lift, 170U);
  EXPECT_EQ(early[0].swing_share, 0.8);
  const std::vector<Landing> late = landings_of(late_landing());
  ASSERT_EQ(late.size(), 1U);
  EXPECT_EQ(late[0].contact, 120U);
  EXPECT_EQ(late[0].step_end, 100U);
  EXPECT_EQ(late[0].swing_share, 1.0);
}

TEST(Landings, DoNotCountWhenTheWalkEndsBeforeTheNextLift) {
  ObservedWalk walk = early_landing(Side::kLeft, 0.8);
  walk.ticks.resize(165);
  EXPECT_THAT(landings_of(walk), IsEmpty());
}

TEST(CriteriaQuantities, TakeThePeakForceOfEarlyLandingsUpToThePlannedOne) {
  EXPECT_THAT(early_landing_peak_n(early_landing(Side::kLeft, 0.8)), ElementsAre(300.0));
  EXPECT_THAT(early_landing_peak_n(early_landing(Side::kLeft, 0.93)), IsEmpty()) << "in time: nothing is absorbed";
}

TEST(CriteriaQuantities, MeasureTheLandingAgainstTheEndOfTheLoweringEitherWay) {
  EXPECT_NEAR(landing_error_ms(early_landing(Side::kLeft, 0.8)).at(0), 30.0, 1e-9);
  EXPECT_NEAR(landing_error_ms(late_landing()).at(0), 20.0, 1e-9);
  EXPECT_THAT(landed_late_percent(early_landing(Side::kLeft, 0.8)), ElementsAre(0.0));
  EXPECT_THAT(landed_late_percent(late_landing()), ElementsAre(100.0));
}

// Eq. (10) with I = 45.4 kg m2 and nothing desired, flat walking's rate being zero here: 0.1 rad/s at the contact is
// out of range, 0.05 at the next lift, 70 ms later, leaves 2.27 N m s. To the left is a negative roll.
TEST(CriteriaQuantities, TakeTheMomentumThatIsLeftWhenTheOtherFootIsLifted) {
  EXPECT_NEAR(landed_momentum_error_nms(early_landing(Side::kLeft, 0.9, -0.1, -0.05)).at(0), 2.27, 1e-9);
  EXPECT_NEAR(landed_momentum_error_nms(early_landing(Side::kRight, 0.9, 0.1, 0.05)).at(0), 2.27, 1e-9);
  EXPECT_THAT(landed_momentum_error_nms(early_landing(Side::kLeft, 0.9, 0.03, 0.1)), IsEmpty()) << "within 1.5 N m s";
  ObservedWalk printed = early_landing(Side::kLeft, 0.9, -0.1, -0.05);
  printed.config.landing_momentum.uses_nominal = false;
  EXPECT_NEAR(landed_momentum_error_nms(printed).at(0), 11.0 - 2.27, 1e-9);
}

// Eqs. (14), (15): 0.1 rad/s more than flat walking call for kp 45.4 0.1 / (0.1 56 9.81) = 8.264 mm with kp = 0.1.
TEST(CriteriaQuantities, CompareTheLandingPointWithTheClosedForm) {
  for (const Side foot : kSides) {
    ObservedWalk walk = early_landing(foot, 0.9);
    for (ObservedTick& tick : walk.ticks) {
      tick.measured.support_roll_rate_rad_s = -lateral_sign(foot) * 0.1;
      tick.foot_body_m[index(foot)].y() = lateral_sign(foot) * (0.071 + 5e-3);
      tick.foot_body_m[index(opposite(foot))].y() = -lateral_sign(foot) * 0.071;
    }
    EXPECT_NEAR(landing_position_error_mm(walk).at(0), 3.264, 1e-3);
  }
}

TEST(CriteriaQuantities, TakeTheLargestMomentOnTheLandingFootAloneUntilTheNextLift) {
  ObservedWalk walk = early_landing(Side::kLeft, 0.9);
  for (ObservedTick& tick : walk.ticks) tick.ankle[index(Side::kRight)].roll_moment_nm = 50.0;
  walk.ticks[99].ankle[index(Side::kLeft)].roll_moment_nm = 40.0;   // before the contact
  walk.ticks[170].ankle[index(Side::kLeft)].roll_moment_nm = 40.0;  // after the lift
  walk.ticks[140].ankle[index(Side::kLeft)] = {600.0, -6.0, 8.0};
  EXPECT_NEAR(landing_moment_peak_nm(walk).at(0), 10.0, 1e-12);
}

/// A leg lifted at 1 s that leaves the floor 0.2 s later and swings at 27.3 rad/s, beside the body's slow 1.05 Hz.
ObservedWalk vibrating(double damping_ratio, double body_rad_s) {
  ObservedWalk walk;
  ObservedTick tick;
  add(walk, 1000, tick);
  tick.walk.stage = WalkStage::kLiftLeft;
  tick.walk.is_double_support = false;
  tick.walk.moving = Side::kLeft;
  tick.force_n[index(Side::kLeft)] = 50.0;
  add(walk, 200, tick);
  tick.force_n[index(Side::kLeft)] = 0.0;
  add(walk, 1800, tick);
  for (ObservedTick& one : walk.ticks) {
    const double free_s = one.time_s - 1.2;
    double& rate_rad_s = one.hip_joint_rate_rad_s[index(Side::kLeft)];
    rate_rad_s = body_rad_s * std::sin(6.6 * one.time_s);
    if (free_s >= 0.0) rate_rad_s += std::exp(-damping_ratio * 27.3 * free_s) * std::sin(27.3 * free_s);
  }
  return walk;
}

// exp(-zeta w 1 s). Half of the first means' windows lies before the release, where nothing swings: the first peak
// comes out less by up to a fifth, what is left more. The body's share of a fifth must not show.
TEST(CriteriaQuantities, TellWhatIsLeftOfAVibrationAfterASecondBesideTheBodysSlowSwing) {
  for (const double damping_ratio : {0.01, 0.03, 0.05}) {
    const double left_percent = 100.0 * std::exp(-damping_ratio * 27.3);
    const double alone_percent = vibration_left_percent(vibrating(damping_ratio, 0.0)).at(0);
    EXPECT_GE(alone_percent, left_percent) << damping_ratio;
    EXPECT_LE(alone_percent, 1.2 * left_percent) << damping_ratio;
    EXPECT_NEAR(vibration_left_percent(vibrating(damping_ratio, 0.2)).at(0), alone_percent, 0.3) << damping_ratio;
  }
  EXPECT_LT(vibration_left_percent(vibrating(0.5, 0.0)).at(0), 0.1);
  ObservedWalk brief = vibrating(0.05, 0.0);
  brief.ticks.resize(2200);
  EXPECT_THAT(vibration_left_percent(brief), IsEmpty());
}

// Kim, Park, Oh 2007, eq. (9): 3 degrees over 142 mm are 7.44 mm between the legs, 3.72 mm each.
TEST(CriteriaQuantities, TakeCorrectionsInTheHalfSecondBeforeFifteen) {
  ObservedWalk walk;
  ObservedTick tick;
  add(walk, 14500, tick);
  const double slope_rad = 3.0 / kRadian_deg;
  const double half_m = 0.5 * 0.142 * std::tan(slope_rad);
  for (const Side side : kSides) {
    tick.total.leg_length_m[index(side)] = -lateral_sign(side) * half_m;
    tick.total.ankle_roll_rad[index(side)] = slope_rad;
    tick.foot_body_m[index(side)].z() = -0.65 + lateral_sign(side) * half_m;
    tick.ankle_roll_rad[index(side)] = 0.5 * slope_rad;
  }
  tick.torso.roll_rad = -0.1 / kRadian_deg;
  add(walk, 500, tick);
  add(walk, 100, ObservedTick{});
  EXPECT_NEAR(commanded_leg_correction_mm(walk).at(0), 3.72, 0.005);
  EXPECT_NEAR(true_leg_correction_mm(walk).at(0), 3.72, 0.005);
  EXPECT_NEAR(commanded_ankle_roll_deg(walk).at(0), 3.0, 1e-9);
  EXPECT_NEAR(true_ankle_roll_deg(walk).at(0), 1.5, 1e-9);
  EXPECT_NEAR(torso_lean_deg(walk).at(0), 0.1, 1e-9);
  walk.ticks.resize(14999);
  EXPECT_THAT(torso_lean_deg(walk), IsEmpty());
}

TEST(CriteriaQuantities, TakeTheZmpAgainstFlatWalkingInSingleSupport) {
  ObservedWalk walk;
  ObservedTick tick = swinging(Side::kLeft, 0.5);
  tick.nominal.zmp_y_foot_m = -0.05;
  tick.measured.zmp_y_foot_m = -0.047;
  tick.measured.zmp_x_foot_m = 0.004;
  add(walk, 100, tick);
  ObservedTick both = in_double_support(tick);
  both.measured.zmp_x_foot_m = 1.0;
  add(walk, 50, both);
  EXPECT_NEAR(zmp_error_mm(walk).at(0), 5.0, 1e-9);
}

// Outwards is to the right of the right foot, to the left of the left one.
TEST(CriteriaQuantities, CompareTheOutermostZmpOfEachStepInTheWalksSecondHalf) {
  ObservedWalk walk;
  for (const Side foot : {Side::kLeft, Side::kRight, Side::kLeft, Side::kRight}) {
    ObservedTick tick = swinging(foot, 0.5);
    const double outwards = lateral_sign(opposite(foot));
    tick.measured.zmp_y_foot_m = outwards * 0.05;
    tick.nominal.zmp_y_foot_m = outwards * 0.06;
    add(walk, 50, tick);
    tick.measured.zmp_y_foot_m = outwards * 0.054;
    add(walk, 50, tick);
    tick.walk.swing_share = 0.9;  // the landing's own push does not count
    tick.measured.zmp_y_foot_m = outwards * 0.07;
    add(walk, 50, tick);
    add(walk, 50, in_double_support(tick));
  }
  const Samples errors_mm = zmp_peak_error_mm(walk);
  ASSERT_EQ(errors_mm.size(), 2U);
  EXPECT_NEAR(errors_mm[0], 6.0, 1e-9);
  EXPECT_NEAR(errors_mm[1], 6.0, 1e-9);
}

TEST(CriteriaQuantities, TakeTheMeanTiltOfTheLastTwoGaitCycles) {
  ObservedWalk walk;
  ObservedTick tick;
  tick.torso.roll_rad = 1.0;
  add(walk, 1000, tick);
  tick.torso = {3.0 / kRadian_deg, -4.0 / kRadian_deg};
  add(walk, 3801, tick);
  EXPECT_NEAR(mean_tilt_deg(walk).at(0), 5.0, 1e-6);
  walk.has_fallen = true;
  EXPECT_THAT(mean_tilt_deg(walk), IsEmpty());
}

TEST(CriteriaQuantities, LookAtTwoSecondsFromThePushOn) {
  ObservedWalk walk;
  walk.push_s = 1.0;
  ObservedTick tick;
  tick.torso.roll_rad = 0.5;
  tick.measured.torso_roll_rate_rad_s = 9.0;
  add(walk, 1000, tick);
  tick.nominal.torso_roll_rad = 1.0 / kRadian_deg;
  tick.nominal.torso_roll_rate_rad_s = 2.0 / kRadian_deg;
  tick.torso.roll_rad = -2.0 / kRadian_deg;
  tick.measured.torso_roll_rate_rad_s = -2.0 / kRadian_deg;
  add(walk, 2000, tick);
  tick.torso.roll_rad = 0.5;
  tick.measured.torso_roll_rate_rad_s = 9.0;
  add(walk, 500, tick);
  EXPECT_NEAR(roll_after_push_deg(walk).at(0), 3.0, 1e-9);
  EXPECT_NEAR(rate_after_push_deg_s(walk).at(0), 4.0, 1e-9);
  walk.ticks.resize(2500);
  walk.has_fallen = true;
  EXPECT_THAT(roll_after_push_deg(walk), IsEmpty()) << "it fell within the two seconds";
}

}  // namespace
}  // namespace surefoot::floor
