#include <gtest/gtest.h>

#include <cmath>

#include "firmware/core/gait/nominal_walk.hpp"
#include "tests/closed_loop/run_scenario.hpp"

namespace surefoot::run {
namespace {

using testing::run_scenario;
using testing::time_of;

constexpr double kTick_s = 1.001e-3;

/// Halving the physics step must change no verdict.
class PayloadAtStep : public ::testing::TestWithParam<const char*> {
 protected:
  static Verdict run(const std::string& scenario) {
    return run_scenario(scenario, {std::string("physics.step_s=") + GetParam()});
  }
};

// El-Kahlout 2003, section 4.1.1, Fig 4.2: unaided, the robot falls forward.
TEST_P(PayloadAtStep, OfFiveKilogramsTopplesTheUnaidedRobot) {
  const Verdict verdict = run("five_kg_reflex_off");
  EXPECT_EQ(verdict.outcome, Outcome::kFell) << verdict.reason;
  EXPECT_EQ(exit_code(verdict.outcome), ExitCode::kFellOrLimit);
  EXPECT_GT(verdict.torso_pitch_deg.max, 30.0);
  EXPECT_FALSE(time_of(verdict, "payload_detected")) << "the reflex is off";
  EXPECT_TRUE(time_of(verdict, "payload_seen"));
}

// El-Kahlout 2003, section 4.1.2, Figs 4.3 and 4.4.
TEST_P(PayloadAtStep, OfFiveKilogramsIsSurvivedWithTheOriginalReflex) {
  const Verdict verdict = run("main");
  ASSERT_EQ(verdict.outcome, Outcome::kWalked) << verdict.reason;
  EXPECT_LE(verdict.torso_pitch_deg.largest_magnitude(), 2.5);
  EXPECT_GE(verdict.cycles_after_recovery, 2.0);
  EXPECT_LT(verdict.time_at_torque_limit_percent, 0.1);
}

TEST_P(PayloadAtStep, OfTenKilogramsIsSurvivedWithTheModifiedReflex) {
  const Verdict verdict = run("ten_kg_modified");
  ASSERT_EQ(verdict.outcome, Outcome::kWalked) << verdict.reason;
  EXPECT_GE(verdict.cycles_after_recovery, 2.0);
}

INSTANTIATE_TEST_SUITE_P(PhysicsStep, PayloadAtStep, ::testing::Values("0.0005", "0.00025"),
                         [](const auto& step) { return std::string("us") + (step.param[5] == '5' ? "500" : "250"); });

// Appendix of the thesis as restored: +0.1, +2.0, +0.5, the restoring step, +1.0, each to one tick.
TEST(Payload, IsMetOnTheTimeLineOfTheThesis) {
  const Verdict verdict = run_scenario("main");
  const std::optional<double> trigger_s = time_of(verdict, "payload_detected");
  ASSERT_TRUE(trigger_s);
  EXPECT_GE(*trigger_s, 1.2);
  EXPECT_LE(*trigger_s, 1.35) << "5 kg must be seen within 0.15 s";
  const auto after = [&](const char* event_name) { return time_of(verdict, event_name, *trigger_s).value_or(NAN); };
  EXPECT_NEAR(after("reflex_done"), *trigger_s + 0.1, kTick_s);
  EXPECT_NEAR(after("settled"), after("reflex_done") + 2.0, kTick_s);
  EXPECT_NEAR(after("shifted"), after("settled") + 0.5, kTick_s);
  EXPECT_NEAR(after("rested"), after("restored") + 1.0, kTick_s);

  const gait::WalkParameters walk;
  const FootReference feet = gait::nominal_walk(walk, *trigger_s, walk.reference_x_body_m);
  const gait::StepRestoration plan = gait::plan_restoration(
      walk, gait::RestorationTiming::kAcosFactor, walk.reference_x_body_m,
      feet[index(Side::kRight)].position_body_m.x() - 0.01, feet[index(Side::kLeft)].position_body_m.x() + 0.01);
  EXPECT_NEAR(after("restored"), after("shifted") + plan.duration_s(), kTick_s);
}

// Standing, in the first steps after the recovery, and when all is as before: 5.816 s is the resume.
class SecondPayload : public ::testing::TestWithParam<double> {};

TEST_P(SecondPayload, IsMetToo) {
  const double at_s = GetParam();
  for (const char* method : {"original", "modified"}) {
    const Verdict verdict = run_scenario("second_payload", {"payload.1.at_s=" + std::to_string(at_s), "duration_s=36",
                                                            std::string("reflex.method=") + method});
    ASSERT_EQ(verdict.outcome, Outcome::kWalked) << method << ": " << verdict.reason;
    EXPECT_GE(verdict.cycles_after_recovery, 2.0) << method;
    if (at_s < time_of(verdict, "settled", 1.2).value_or(NAN)) continue;  // the first adaptation answers both
    const std::optional<double> second = time_of(verdict, "payload_detected", at_s);
    ASSERT_TRUE(second) << method;
    const double resumed_s = time_of(verdict, "rested", 1.2).value_or(NAN);
    EXPECT_LE(*second, std::max(at_s, resumed_s) + 0.25) << method;
  }
}

INSTANTIATE_TEST_SUITE_P(AtAnyTime, SecondPayload, ::testing::Values(4.5, 7.0, 9.0, 11.2));

// Each load is answered for itself, not again for those before it.
TEST(Payload, CanComeFourTimes) {
  for (const char* plant : {"thesis", "nominal"}) {
    const Verdict verdict = run_scenario(
        "main", {"payload.1.mass_kg=5", "payload.1.at_s=20", "payload.2.mass_kg=5", "payload.2.at_s=40",
                 "payload.3.mass_kg=5", "payload.3.at_s=60", "duration_s=80", std::string("plant=") + plant});
    EXPECT_EQ(verdict.outcome, Outcome::kWalked) << plant << ": " << verdict.reason;
    EXPECT_EQ(verdict.payloads_detected, 4) << plant;
    EXPECT_EQ(verdict.false_alarms, 0) << plant;
    EXPECT_TRUE(time_of(verdict, "payload_detected", 60.0)) << plant;
  }
}

// The thesis' robot does the same with either foot: a load half a cycle later meets the mirrored robot.
TEST(Payload, IsMetAlikeHalfACycleLater) {
  const Verdict early = run_scenario("main");
  const Verdict late = run_scenario("main", {"payload.0.at_s=3.6", "duration_s=22.4"});
  ASSERT_EQ(late.outcome, Outcome::kWalked) << late.reason;
  EXPECT_NEAR(time_of(late, "payload_detected").value_or(NAN), time_of(early, "payload_detected").value_or(NAN) + 2.4,
              2e-3);
  EXPECT_NEAR(late.torso_pitch_deg.max, early.torso_pitch_deg.max, 0.1);
  EXPECT_NEAR(late.torso_roll_deg.min, -early.torso_roll_deg.max, 0.3);
}

}  // namespace
}  // namespace surefoot::run
