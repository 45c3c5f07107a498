#include <gtest/gtest.h>

#include <string>

#include "tests/closed_loop/run_scenario.hpp"

namespace surefoot::run {
namespace {

using testing::run_scenario;
using testing::time_of;

constexpr double kTick_s = 1.001e-3;

Verdict on_slope(const char* plant, const char* pitch_deg, const char* roll_deg) {
  return run_scenario("no_payload", {std::string("plant=") + plant, std::string("floor.slope_pitch_deg=") + pitch_deg,
                                     std::string("floor.slope_roll_deg=") + roll_deg, "duration_s=10"});
}

// Uphill, downhill, to either side; a loop that took the slope for a load would trigger.
TEST(Slope, OfThreeDegreesIsWalkedOnTheLongFootInEveryDirection) {
  for (const auto& [pitch_deg, roll_deg] : {std::pair{"3", "0"}, {"-3", "0"}, {"0", "3"}, {"0", "-3"}}) {
    const Verdict verdict = on_slope("nominal", pitch_deg, roll_deg);
    EXPECT_EQ(verdict.outcome, Outcome::kWalked) << pitch_deg << ", " << roll_deg << ": " << verdict.reason;
    EXPECT_LT(verdict.torso_pitch_deg.largest_magnitude(), 1.5) << pitch_deg << ", " << roll_deg;
    EXPECT_LT(verdict.torso_roll_deg.largest_magnitude(), 1.5) << pitch_deg << ", " << roll_deg;
    EXPECT_GE(verdict.cycles_after_recovery, 2.0);
  }
}

// 0.58 m times tan 3 degrees = 30 mm towards the toes, of which the thesis' foot has too little, or towards the heel.
TEST(Slope, OfThreeDegreesDownhillTopplesTheShortFootAndUphillDoesNot) {
  const Verdict level = on_slope("thesis", "0", "0");
  const Verdict downhill = on_slope("thesis", "3", "0");
  const Verdict uphill = on_slope("thesis", "-3", "0");
  EXPECT_EQ(downhill.outcome, Outcome::kFell) << downhill.reason;
  EXPECT_EQ(uphill.outcome, Outcome::kWalked) << uphill.reason;
  EXPECT_NEAR(downhill.standing_zmp_x_body_m - level.standing_zmp_x_body_m, 0.030, 0.002);
  EXPECT_NEAR(uphill.standing_zmp_x_body_m - level.standing_zmp_x_body_m, -0.030, 0.002);
}

TEST(Push, OfTwentyNewtonSecondsToTheLeftIsSurvivedUnaided) {
  const Verdict verdict = run_scenario("push");
  ASSERT_EQ(verdict.outcome, Outcome::kWalked) << verdict.reason;
  EXPECT_EQ(verdict.pushes, 1);
  EXPECT_EQ(verdict.false_alarms, 0);
  EXPECT_GE(verdict.disturbance_triggers, 1) << "it lands harder than it ever walked";
  EXPECT_NEAR(time_of(verdict, "push_begins").value_or(0.0), 6.2, kTick_s);
  EXPECT_NEAR(time_of(verdict, "push_ends").value_or(0.0), 6.3, kTick_s);
  EXPECT_GT(verdict.torso_roll_deg.largest_magnitude(), 1.5) << "the push is felt";
}

TEST(Push, OfTwentyNewtonSecondsForwardsTopplesTheUnaidedRobot) {
  EXPECT_EQ(run_scenario("push", {"push.0.force_n=[200, 0, 0]"}).outcome, Outcome::kFell);
}

TEST(Removal, OfTenKilogramsWhileWalkingIsSurvivedAndNoFalseAlarm) {
  const Verdict verdict = run_scenario("payload_removed");
  ASSERT_EQ(verdict.outcome, Outcome::kWalked) << verdict.reason;
  EXPECT_EQ(verdict.payloads_detected, 1);
  EXPECT_EQ(verdict.payloads_removed, 1);
  EXPECT_EQ(verdict.disturbance_triggers + verdict.false_alarms, 0);
  EXPECT_NEAR(time_of(verdict, "payload_removed").value_or(0.0), 12.0, kTick_s);
  EXPECT_NEAR(verdict.cycles_after_recovery, (30.0 - 12.0) / 4.8, 1e-3) << "counted from the removal on";
}

// Off the toes: what topples the thesis' robot in front of it does not at its back.
TEST(Payload, OfTenKilogramsAtTheBackIsWalkedAwayWithUnaided) {
  const Verdict verdict =
      run_scenario("main", {"reflex.method=off", "payload.0.mass_kg=10", "payload.0.position_m=[-0.2, 0, 0.25]"});
  EXPECT_EQ(verdict.outcome, Outcome::kWalked) << verdict.reason;
  EXPECT_LT(verdict.torso_pitch_deg.largest_magnitude(), 1.5);
}

}  // namespace
}  // namespace surefoot::run
