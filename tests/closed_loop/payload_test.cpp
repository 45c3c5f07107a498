#include <gtest/gtest.h>

#include <cmath>

#include "tests/closed_loop/run_scenario.hpp"

namespace surefoot::run {
namespace {

using testing::run_main_job;
using testing::time_of;

constexpr double kTick_s = 1e-3;

// El-Kahlout 2003, section 4.1.1, Fig 4.2: unaided, the robot falls forward under 5 kg.
TEST(Payload, TopplesTheUnaidedRobotForward) {
  const Verdict verdict = run_main_job({"reflex.method=off"});
  EXPECT_EQ(verdict.outcome, Outcome::kFell) << verdict.reason;
  EXPECT_EQ(exit_code(verdict.outcome), ExitCode::kFellOrLimit);
  EXPECT_GT(verdict.torso_pitch_deg.max, 30.0);
  EXPECT_GT(verdict.torso_pitch_deg.min, -10.0);
}

// El-Kahlout 2003, section 4.1.2, Figs 4.3 and 4.4.
TEST(Payload, IsSurvivedWithTheOriginalReflex) {
  const Verdict verdict = run_main_job({});
  ASSERT_EQ(verdict.outcome, Outcome::kWalked) << verdict.reason;
  EXPECT_LE(verdict.torso_pitch_deg.largest_magnitude(), 2.5);
  EXPECT_GE(verdict.cycles_after_recovery, 2.0);
  EXPECT_LT(verdict.time_at_torque_limit_percent, 0.1);
}

// Appendix of the thesis as restored: +0.1, +2.0, +0.5, the restoring step, +1.0, each to one tick.
TEST(Payload, ReflexKeepsTheTimeLineOfTheThesis) {
  const Verdict verdict = run_main_job({});
  const std::optional<double> trigger_s = time_of(verdict, "payload_detected");
  ASSERT_TRUE(trigger_s);
  EXPECT_GE(*trigger_s, 1.2);
  EXPECT_LE(*trigger_s, 1.35) << "5 kg must be seen within 0.15 s";
  const auto after = [&](const char* event_name) { return time_of(verdict, event_name, *trigger_s).value_or(NAN); };
  EXPECT_NEAR(after("reflex_done"), *trigger_s + 0.1, kTick_s * 1.001);
  EXPECT_NEAR(after("settled"), after("reflex_done") + 2.0, kTick_s * 1.001);
  EXPECT_NEAR(after("shifted"), after("settled") + 0.5, kTick_s * 1.001);
  EXPECT_NEAR(after("rested"), after("restored") + 1.0, kTick_s * 1.001);

  const gait::WalkParameters walk;
  const FootReference feet = gait::nominal_walk(walk, *trigger_s, walk.reference_x_body_m);
  const gait::StepRestoration plan = gait::plan_restoration(
      walk, decision::RestorationTiming::kAcosFactor, walk.reference_x_body_m,
      feet[index(Side::kRight)].position_body_m.x() - 0.01, feet[index(Side::kLeft)].position_body_m.x() + 0.01);
  EXPECT_NEAR(after("restored"), after("shifted") + plan.duration_s(), kTick_s * 1.001);
}

TEST(Payload, OfTenKilogramsIsSurvivedWithTheModifiedReflex) {
  const Verdict verdict = run_main_job({"payload.0.mass_kg=10", "reflex.method=modified", "duration_s=25"});
  EXPECT_EQ(verdict.outcome, Outcome::kWalked) << verdict.reason;
}

TEST(Payload, CanComeTwice) {
  const Verdict verdict = run_main_job({"payload.1.mass_kg=5", "payload.1.at_s=11.2", "duration_s=32"});
  ASSERT_EQ(verdict.outcome, Outcome::kWalked) << verdict.reason;
  const std::optional<double> second = time_of(verdict, "payload_detected", 11.2);
  ASSERT_TRUE(second);
  EXPECT_LE(*second, 11.35);
  EXPECT_GE(verdict.cycles_after_recovery, 2.0);
}

}  // namespace
}  // namespace surefoot::run
