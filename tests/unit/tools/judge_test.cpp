#include "tools/run/judge.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/unit/tools/judge_fixture.hpp"

namespace surefoot::run {
namespace {

using testing::expect_outcome;
using ::testing::HasSubstr;
using testing::kAttached;
using testing::kDetected;
using testing::kPeriod_s;
using testing::kSeen;
using testing::kTimeZero_s;

class JudgeTest : public testing::JudgeFixture {};

TEST_F(JudgeTest, SaysWalkedWhenTheRobotStandsAtTheEnd) {
  see_from_to(-kTimeZero_s, 20.0);
  EXPECT_FALSE(judge().is_over());
  expect_outcome(verdict(), Outcome::kWalked, 0, "20.000 s");
}

TEST_F(JudgeTest, SaysFellWithTheInstantAndNeedsNoMoreTicks) {
  see(0.0);
  truth_.has_fallen = true;
  see(2.5);
  EXPECT_TRUE(judge().is_over());
  expect_outcome(verdict(), Outcome::kFell, 2, "2.500 s");
}

TEST_F(JudgeTest, SaysFaultWithItsNumberAndName) {
  output_.fault = safety::Fault::kBoardDamping;
  see(1.25);
  EXPECT_TRUE(judge().is_over());
  expect_outcome(verdict(), Outcome::kFault, 3, "fault 5 (board_damping) latched at 1.250 s");
}

TEST_F(JudgeTest, SaysInterruptedWithTheInstant) {
  see(1.25);
  expect_outcome(verdict(true), Outcome::kInterrupted, 130, "1.250 s");
}

TEST_F(JudgeTest, HoldsThePitchToItsLimitInBothDirections) {
  scenario_.limits.max_abs_pitch_deg = 2.5;
  lean(2.49, 30.0);
  see(0.0);
  EXPECT_EQ(verdict().outcome, Outcome::kWalked) << "a roll limit of 0 means none";
  lean(-2.75, 0.0);
  see(1.0);
  expect_outcome(verdict(), Outcome::kLimit, 2, "pitch reached 2.750 deg, limits.max_abs_pitch_deg is 2.5");
}

TEST_F(JudgeTest, HoldsTheRollToItsLimit) {
  scenario_.limits.max_abs_roll_deg = 4.0;
  lean(30.0, -4.25);
  see(0.0);
  expect_outcome(verdict(), Outcome::kLimit, 2, "roll reached 4.250 deg, limits.max_abs_roll_deg is 4");
}

TEST_F(JudgeTest, DoesNotHoldTheStartUpToTheLimitsButShowsIt) {
  scenario_.limits.max_abs_pitch_deg = 2.5;
  lean(9.0, -8.0);
  see(-0.125);
  lean(-1.0, 2.0);
  see(0.0);
  const Verdict seen = verdict();
  EXPECT_EQ(seen.outcome, Outcome::kWalked) << seen.reason;
  EXPECT_NEAR(seen.start_up_pitch_deg.max, 9.0, 1e-12);
  EXPECT_NEAR(seen.start_up_roll_deg.min, -8.0, 1e-12);
  EXPECT_NEAR(seen.torso_pitch_deg.max, -1.0, 1e-12);
  EXPECT_NEAR(seen.torso_roll_deg.min, 2.0, 1e-12);
}

TEST_F(JudgeTest, MissesAPayloadThatWasNeverHungOn) {
  scenario_.sim.payloads.resize(2);
  see(1.0, {kAttached});
  expect_outcome(verdict(), Outcome::kLimit, 2, "only 1 of 2 payloads");
}

TEST_F(JudgeTest, CallsADetectionBeforeTheFirstPayloadAFalseAlarm) {
  for (const RunEvent& alarm : {kDetected, kSeen}) {
    Judge alarmed(scenario_);
    alarmed.observe(output_, truth_, {&alarm, 1});
    expect_outcome(alarmed.verdict(false), Outcome::kLimit, 2, "without a payload");
    EXPECT_EQ(alarmed.verdict(false).false_alarms, 1);
    EXPECT_EQ(alarmed.verdict(false).payloads_detected, 0);
  }
}

// 5.0 s to 9.75 s is 4.75 s of the cycle of 4.8 s.
TEST_F(JudgeTest, WantsCyclesAfterTheRecoveryAndSaysHowManyThereWere) {
  scenario_.sim.payloads.resize(1);
  scenario_.limits.min_cycles_after_recovery = 1.0;
  survive_a_payload(9.75);
  EXPECT_NEAR(verdict().cycles_after_recovery, 4.75 / 4.8, 1e-12);
  expect_outcome(verdict(), Outcome::kLimit, 2, "0.9896 cycles walked after recovery");
  see(9.75);
  expect_outcome(verdict(), Outcome::kWalked, 0, "1 of 1 payloads noticed");
}

// 4.8 s from 5.0 s on are walked after the tick at 9.75 s, whose period is 0.125 s.
TEST_F(JudgeTest, EndsAtTheLastCycleAskedForWhereTheScenarioSaysSo) {
  scenario_.sim.payloads.resize(1);
  scenario_.limits.min_cycles_after_recovery = 1.0;
  scenario_.limits.ends_when_recovered = true;
  survive_a_payload(9.75);
  EXPECT_FALSE(judge().is_over());
  see(9.75);
  EXPECT_TRUE(judge().is_over());
  expect_outcome(verdict(), Outcome::kWalked, 0, "1 of 1 payloads noticed");
}

TEST_F(JudgeTest, EndsEarlyForNoLoadThatIsUnnoticedUnansweredOrStillToCome) {
  scenario_.limits.ends_when_recovered = true;
  scenario_.limits.min_cycles_after_recovery = 1.0;
  const auto ends = [&](std::size_t payloads, decision::ReflexMethod method, const RunEvent& noticed) {
    scenario_.sim.payloads.resize(payloads);
    scenario_.firmware.reflex.method = method;
    Judge fresh(scenario_);
    sim_hw::GroundTruth truth;
    for (double time_s = 0.0; time_s < 30.0; time_s += kPeriod_s) {
      output_.tick = static_cast<std::uint32_t>(std::lround((time_s + kTimeZero_s) / kPeriod_s));
      std::vector<RunEvent> events;
      if (time_s == 1.0) events = {kAttached, noticed};
      if (time_s == 1.0) truth.payloads_hung = 1;
      fresh.observe(output_, truth, events);
    }
    return fresh.is_over();
  };
  const RunEvent nothing{event_t::RESTED, "rested", 0.0};
  EXPECT_TRUE(ends(1, decision::ReflexMethod::kOriginal, kDetected));
  EXPECT_FALSE(ends(1, decision::ReflexMethod::kOriginal, nothing));
  EXPECT_FALSE(ends(1, decision::ReflexMethod::kOff, kSeen));
  EXPECT_FALSE(ends(2, decision::ReflexMethod::kOriginal, kDetected));
  scenario_.sim.faults.resize(1);
  EXPECT_FALSE(ends(1, decision::ReflexMethod::kOriginal, kDetected));
}

TEST_F(JudgeTest, CountsNoCyclesWhileTheRobotStillRecovers) {
  scenario_.sim.payloads.resize(1);
  survive_a_payload(9.75);
  output_.decision.phase = decision::ReflexPhase::kResting;
  see(9.75);
  EXPECT_EQ(verdict().cycles_after_recovery, 0.0);
  EXPECT_EQ(verdict().outcome, Outcome::kLimit);
}

TEST_F(JudgeTest, WantsNoRecoveryWhereNoReflexAnswersOrNothingWasNoticed) {
  scenario_.sim.payloads.resize(1);
  see(0.0);
  see(1.0, {kAttached});
  expect_outcome(verdict(), Outcome::kWalked, 0, "0 of 1 payloads noticed");
  scenario_.firmware.reflex.method = decision::ReflexMethod::kOff;
  Judge off(scenario_);
  const std::vector<RunEvent> events{kAttached, kSeen};
  off.observe(output_, truth_, events);
  EXPECT_EQ(off.verdict(false).outcome, Outcome::kWalked) << off.verdict(false).reason;
}

// Each cause is added to those that rank below it.
TEST_F(JudgeTest, NamesTheWorstOfManyCauses) {
  scenario_.limits = {.max_abs_pitch_deg = 2.0, .max_abs_roll_deg = 2.0, .min_cycles_after_recovery = 5.0};
  scenario_.sim.payloads.resize(2);
  see(-0.125, {kDetected});
  see(0.0, {kAttached, kDetected});
  EXPECT_THAT(verdict().reason, HasSubstr("only 1 of 2"));
  see(0.125, {kAttached});
  EXPECT_THAT(verdict().reason, HasSubstr("without a payload"));
  lean(0.0, 3.0);
  see(0.25);
  EXPECT_THAT(verdict().reason, HasSubstr("roll"));
  lean(3.0, 3.0);
  see(0.375);
  EXPECT_THAT(verdict().reason, HasSubstr("pitch"));
  EXPECT_EQ(verdict(true).outcome, Outcome::kInterrupted);
  output_.fault = safety::Fault::kSensorSilent;
  see(0.5);
  EXPECT_EQ(verdict(true).outcome, Outcome::kFault);
  truth_.has_fallen = true;
  see(0.625);
  EXPECT_EQ(verdict(true).outcome, Outcome::kFell);
}

TEST_F(JudgeTest, TakesThePeakTorqueOfEachJointOverBothLegsFromTimeZeroOn) {
  truth_.torque_nm[0].fill(190.0);
  see(-0.125);
  truth_.torque_nm = {LegVector{1.0, -20.0, 3.0, 4.0, -5.0, 0.0}, LegVector{-10.0, 2.0, -3.5, 0.0, 5.0, 0.5}};
  see(0.0);
  truth_.torque_nm = {};
  see(0.125);
  EXPECT_EQ(verdict().peak_torque_nm, (LegVector{10.0, 20.0, 3.5, 4.0, 5.0, 0.5}));
}

// Root mean square of the change: +-a in turn changes by 2a every tick.
TEST_F(JudgeTest, MeasuresRippleAsTheChangeFromTickToTick) {
  constexpr double kAmplitude_nm = 3.0;
  for (int i = 0; i < 4'000; ++i) {
    for (LegVector& leg : truth_.torque_nm) leg.fill(i % 2 == 0 ? kAmplitude_nm : -kAmplitude_nm);
    see(i * kPeriod_s);
  }
  EXPECT_NEAR(verdict().torque_ripple_nm, 2.0 * kAmplitude_nm, 1e-3 * kAmplitude_nm);
}

TEST_F(JudgeTest, FindsNoRippleInAConstantTorqueNorInTheStepFromTheStartUp) {
  for (LegVector& leg : truth_.torque_nm) leg.fill(-100.0);
  see(-0.125);
  for (LegVector& leg : truth_.torque_nm) leg.fill(100.0);
  see_from_to(0.0, 2.0);
  EXPECT_EQ(verdict().torque_ripple_nm, 0.0);
}

// One of twelve joints, for a quarter of the ticks.
TEST_F(JudgeTest, CountsTimeAtTheSmallerOfDriveAndGateLimit) {
  for (const bool is_drive_weaker : {false, true}) {
    scenario_.sim.drive.torque_limit_nm = is_drive_weaker ? 80.0 : 200.0;
    scenario_.firmware.gate.torque_limit_nm = is_drive_weaker ? 200.0 : 80.0;
    Judge limited(scenario_);
    for (int i = 0; i < 100; ++i) {
      output_.tick = static_cast<std::uint32_t>(kTimeZero_s / kPeriod_s + i);
      truth_.torque_nm[1][3] = i % 4 == 0 ? -80.0 : 79.0;
      limited.observe(output_, truth_, {});
    }
    EXPECT_NEAR(limited.verdict(false).time_at_torque_limit_percent, 100.0 / 12.0 / 4.0, 1e-9);
  }
}

TEST_F(JudgeTest, SharesTheSlipSinceTimeZeroOutOverTheStepsSinceTimeZero) {
  truth_.slip_m = 0.5;
  see(-0.125);
  for (int step = 0; step < 2; ++step) {
    output_.decision.walk_phase_s = 1.2;  // single support
    see(1.0 + step);
    output_.decision.walk_phase_s = 2.4;  // double support
    truth_.slip_m += 0.01;
    see(1.5 + step);
  }
  EXPECT_EQ(verdict().steps_walked, 2);
  EXPECT_NEAR(verdict().foot_slip_mm, 10.0, 1e-9);
}

TEST_F(JudgeTest, CountsTouchDownsFromTimeZeroAndNoStepThatTheReflexBrokeOff) {
  output_.decision.walk_phase_s = 1.2;
  see(-0.5);
  output_.decision.walk_phase_s = 2.4;
  see(-0.25);
  EXPECT_EQ(verdict().steps_walked, 0) << "before time zero";
  output_.decision.walk_phase_s = 3.6;
  see(1.0);
  output_.decision.phase = decision::ReflexPhase::kReflex;
  see(1.125);
  output_.decision.phase = decision::ReflexPhase::kWalking;
  output_.decision.walk_phase_s = 0.0;
  see(5.0);
  EXPECT_EQ(verdict().steps_walked, 0) << "that foot came down in the reflex";
}

TEST_F(JudgeTest, CountsCyclesFromTimeZeroHoweverLongTheRobotWalkedBefore) {
  see_from_to(-kTimeZero_s, 3.0);
  EXPECT_NEAR(verdict().cycles_after_recovery, 3.0 / 4.8, 1e-12);
}

// Standing lasts 3 s; its last half second counts, and nothing beside.
TEST_F(JudgeTest, TakesTheStandingZmpFromTheLastHalfSecondOfTheStanding) {
  truth_.zmp_x_body_m = 7.0;
  see_from_to(-kTimeZero_s, -kTimeZero_s + 2.5);
  for (int i = 0; i < 4; ++i) {
    truth_.zmp_x_body_m = -0.04 + 0.01 * (i % 2);
    see(-kTimeZero_s + 2.5 + i * kPeriod_s);
  }
  truth_.zmp_x_body_m = 7.0;
  see_from_to(-kTimeZero_s + 3.0, 1.0);
  EXPECT_NEAR(verdict().standing_zmp_x_body_m, -0.035, 1e-12);
}

TEST_F(JudgeTest, MeasuresTheWayFromTimeZeroOn) {
  truth_.body_position_world_m[0] = 0.75;
  see(-0.125);
  truth_.body_position_world_m[0] = 2.0;
  see(0.0);
  EXPECT_DOUBLE_EQ(verdict().distance_m, 1.25);
}

// The list is bounded, so that the loop never allocates; what is counted goes on.
TEST_F(JudgeTest, KeepsTheFirstEventsWithTheirTimesAndGoesOnCounting) {
  scenario_.sim.payloads.resize(600);
  for (int i = 0; i < 600; ++i) see(i * kPeriod_s, {kAttached});
  const Verdict seen = verdict();
  ASSERT_EQ(seen.events.size(), 512U);
  EXPECT_STREQ(seen.events.front().name, "payload_attached");
  EXPECT_EQ(seen.events.back().time_s, 511 * kPeriod_s);
  EXPECT_EQ(seen.payloads_attached, 600);
  EXPECT_EQ(seen.outcome, Outcome::kWalked) << seen.reason;
}

TEST_F(JudgeTest, CountsTicksOutOfReachAndKeepsTheLastThreshold) {
  output_.decision.threshold_n = 40.0;
  output_.joint_reference.is_reachable = false;
  see_from_to(0.0, 0.5);
  output_.joint_reference.is_reachable = true;
  output_.decision.threshold_n = 41.5;
  see(0.5);
  EXPECT_EQ(verdict().unreachable_ticks, 4);
  EXPECT_EQ(verdict().threshold_n, 41.5);
}

// The margin of a loaded walk, or of standing in the reflex, says nothing about false alarms.
TEST_F(JudgeTest, KeepsTheMarginToTheThresholdOfTheScoredUnloadedWalk) {
  const auto see_margin = [&](double time_s, double margin_n, const std::vector<RunEvent>& events = {}) {
    output_.decision.threshold_n = 806.0;
    output_.estimate.filtered_force_n = 806.0 - margin_n;
    see(time_s, events);
  };
  see_margin(-1.0, 1.0);
  see_margin(0.0, 20.0);
  see_margin(0.5, 4.0);
  output_.decision.phase = decision::ReflexPhase::kSettling;
  see_margin(1.0, 2.0);
  output_.decision.phase = decision::ReflexPhase::kWalking;
  see_margin(1.5, -3.0, {kAttached});
  EXPECT_DOUBLE_EQ(verdict().unloaded_margin_n.min, 4.0);
  EXPECT_DOUBLE_EQ(verdict().unloaded_margin_n.max, 20.0);
}

}  // namespace
}  // namespace surefoot::run
