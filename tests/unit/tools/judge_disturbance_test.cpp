#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/unit/tools/judge_fixture.hpp"

namespace surefoot::run {
namespace {

using testing::expect_outcome;
using testing::kAttached;
using testing::kBalanceLost;
using testing::kDetected;
using testing::kPeriod_s;
using testing::kPushBegins;
using testing::kPushEnds;
using testing::kRemoved;
using testing::kSeen;
using testing::kTimeZero_s;

class JudgeOfDisturbances : public testing::JudgeFixture {};

// Half the cycle of 4.8 s: what a push did to the robot shows when the swing foot lands.
TEST_F(JudgeOfDisturbances, PutsATriggerDownToAPushWhileItActsAndForAStepAfterIt) {
  scenario_.sim.pushes.resize(1);
  scenario_.limits.min_cycles_after_recovery = 0.0;
  see(1.0, {kPushBegins});
  see(1.125, {kDetected});
  see(3.0, {kPushEnds});
  see(5.375, {kDetected});
  EXPECT_EQ(verdict().disturbance_triggers, 2);
  EXPECT_EQ(verdict().false_alarms, 0);
  EXPECT_EQ(verdict().payloads_detected, 0);
  EXPECT_EQ(verdict().pushes, 1);
  EXPECT_EQ(verdict().outcome, Outcome::kWalked) << verdict().reason;
  see(5.5, {kDetected});
  EXPECT_EQ(verdict().false_alarms, 1) << "too late for the push";
  EXPECT_EQ(verdict().outcome, Outcome::kLimit);
}

TEST_F(JudgeOfDisturbances, CountsLostBalanceAsTheAnswerToALoadAndWithoutOneAsAFalseAlarm) {
  scenario_.sim.payloads.resize(1);
  see(1.0, {kAttached});
  see(1.125, {kBalanceLost});
  EXPECT_EQ(verdict().payloads_detected, 1);
  EXPECT_EQ(verdict().false_alarms, 0);
  see(9.0, {kBalanceLost});
  EXPECT_EQ(verdict().false_alarms, 1);
  EXPECT_EQ(verdict().outcome, Outcome::kLimit);
}

TEST_F(JudgeOfDisturbances, PutsATriggerDownToARemovalForAStep) {
  scenario_.sim.payloads = {{.removed_at_s = 10.0}};
  survive_a_payload(10.0);
  see(10.0, {kRemoved});
  see(12.375, {kDetected});
  EXPECT_EQ(verdict().disturbance_triggers, 1);
  EXPECT_EQ(verdict().payloads_detected, 1);
  EXPECT_EQ(verdict().payloads_removed, 1);
  EXPECT_EQ(verdict().false_alarms, 0);
  see(12.5, {kDetected});
  EXPECT_EQ(verdict().false_alarms, 1);
}

TEST_F(JudgeOfDisturbances, NoticesALoadBeforeItBlamesThePushAndNoLoadThatIsGone) {
  see(1.0, {kAttached, kPushBegins});
  see(1.125, {kPushEnds, kDetected});
  EXPECT_EQ(verdict().payloads_detected, 1);
  EXPECT_EQ(verdict().disturbance_triggers, 0);
  see(2.0, {kAttached});
  see(3.0, {kRemoved});  // that of 2 s, never noticed, or that of 1 s: one of two hangs
  see(4.0, {kRemoved});
  see(6.5, {kDetected});
  EXPECT_EQ(verdict().payloads_detected, 1) << "nothing hangs there any more";
  EXPECT_EQ(verdict().false_alarms, 1);
}

// With the reflex off a robot that was pushed rocks: its ripple is no false alarm, as after a load.
TEST_F(JudgeOfDisturbances, CallsNoRippleAfterAPushAFalseAlarmWhereNothingAnswersIt) {
  scenario_.firmware.reflex.method = decision::ReflexMethod::kOff;
  see(1.0, {kPushBegins});
  see(1.125, {kPushEnds});
  see(9.0, {kSeen});
  EXPECT_EQ(verdict().false_alarms, 0);
}

// 4.75 s and 4.875 s against the cycle of 4.8 s, from the end of the push and from the removal on, reflex or not.
TEST_F(JudgeOfDisturbances, WantsCyclesAfterTheLastPushOrRemovalWithOrWithoutAReflex) {
  scenario_.limits.min_cycles_after_recovery = 1.0;
  for (const bool is_push : {true, false}) {
    scenario_.sim.pushes.resize(is_push ? 1 : 0);
    scenario_.sim.payloads.clear();
    if (!is_push) scenario_.sim.payloads = {{.removed_at_s = 6.0}};
    for (const decision::ReflexMethod method : {decision::ReflexMethod::kOff, decision::ReflexMethod::kOriginal}) {
      scenario_.firmware.reflex.method = method;
      Judge judge(scenario_);
      truth_ = {};
      const auto show = [&](double time_s, const std::vector<RunEvent>& events) {
        output_.tick = static_cast<std::uint32_t>(std::lround((time_s + kTimeZero_s) / kPeriod_s));
        judge.observe(output_, truth_, events);
      };
      truth_.payloads_hung = is_push ? 0 : 1;
      show(1.0, is_push ? std::vector{kPushBegins} : std::vector{kAttached});
      show(5.875, {});
      EXPECT_EQ(is_push ? judge.verdict(false).cycles_after_recovery : 0.0, 0.0) << "the push acts still";
      truth_.payloads_removed = is_push ? 0 : 1;
      show(6.0, {is_push ? kPushEnds : kRemoved});
      show(10.625, {});
      expect_outcome(judge.verdict(false), Outcome::kLimit, 2, "0.9896 cycles walked after the last removal or push");
      show(10.75, {});
      expect_outcome(judge.verdict(false), Outcome::kWalked, 0, "walks");
    }
  }
}

TEST_F(JudgeOfDisturbances, MissesAPushOrARemovalThatNeverCame) {
  scenario_.limits.min_cycles_after_recovery = 0.0;
  scenario_.sim.payloads = {{.removed_at_s = 30.0}, {}};
  scenario_.sim.pushes.resize(2);
  see(1.0, {kAttached, kAttached, kPushBegins});
  expect_outcome(verdict(), Outcome::kLimit, 2, "only 0 of 1 payloads were taken off");
  see(2.0, {kRemoved});
  expect_outcome(verdict(), Outcome::kLimit, 2, "only 0 of 2 pushes were over");
  see(3.0, {kPushEnds, kPushBegins, kPushEnds});
  EXPECT_EQ(verdict().outcome, Outcome::kWalked) << verdict().reason;
}

}  // namespace
}  // namespace surefoot::run
