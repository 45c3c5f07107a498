#include "firmware/core/decision/reflex_sequence.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "firmware/core/gait/nominal_walk.hpp"
#include "tests/unit/firmware_core/sequence_run.hpp"

namespace surefoot::decision {
namespace {

constexpr std::size_t kRight = index(Side::kRight);
constexpr std::size_t kLeft = index(Side::kLeft);
constexpr double kHalf = 0.5e-3;  // the thesis' own time step, on which all its instants lie
constexpr double kTimeZero_s = 12.0;

ReflexConfig plain() { return {.balance_offset_m = 0.0}; }

/// Walks from power-up, is loaded so that the trigger falls `trigger_s` after time zero.
SequenceRun run_with_trigger(double trigger_s, const ReflexConfig& reflex, double period_s, double zmp_m = -0.0212) {
  SequenceRun run{.reflex = reflex, .period_s = period_s};
  run.run_until(kTimeZero_s + trigger_s + 8.0, with_load(kTimeZero_s + trigger_s, 49.0, zmp_m));
  return run;
}

double since_trigger_s(const SequenceRun& run, ReflexEvent event, double trigger_s) {
  const auto it = run.find(event, kTimeZero_s + trigger_s);
  return it == run.ticks.end() ? -1.0 : it->time_s - kTimeZero_s - trigger_s;
}

TEST(StartUp, StandsStepsRestsAndWalksWithTheLeftFootInFront) {
  SequenceRun run{};
  run.run_until(6.0, with_load(1.0e9, 0.0, 0.0));
  EXPECT_EQ(run.ticks.front().decision.phase, ReflexPhase::kStanding);
  EXPECT_NEAR(run.find(ReflexEvent::kStandingDone)->time_s, 3.0, 1.0e-9);
  EXPECT_NEAR(run.find(ReflexEvent::kRestored)->time_s, 3.8, 1.0e-9);
  const auto walking = run.find(ReflexEvent::kRested);
  EXPECT_NEAR(walking->time_s, 4.8, 1.0e-9);
  EXPECT_NEAR(start_up_s({}, {}), 4.8, 1.0e-12);
  EXPECT_DOUBLE_EQ(walking->decision.walk_phase_s, 2.4);
  EXPECT_NEAR(run.ticks.front().feet[kRight].position_body_m.x(), -0.09, 1.0e-12);
  EXPECT_NEAR(run.ticks.front().feet[kLeft].position_body_m.x(), -0.09, 1.0e-12);
  EXPECT_NEAR(walking->feet[kLeft].position_body_m.x(), -0.01, 1.0e-12);
  EXPECT_NEAR(walking->feet[kRight].position_body_m.x(), -0.17, 1.0e-12);
}

TEST(StartUp, MeasuresTheBalanceAtTheEndOfTheFirstStanding) {
  SequenceRun run{};
  run.run_until(6.0, [](double time_s) {
    return estimation::Estimate{.filtered_zmp_x_body_m = time_s < 2.9995 ? 0.5 : time_s < 3.0005 ? -0.035 : 0.7};
  });
  EXPECT_DOUBLE_EQ(run.ticks.back().decision.balance_zmp_x_body_m, -0.040);
}

TEST(StartUp, ReachesTimeZeroWithTheRightFootInFrontAndTheDetectorJustArmed) {
  EXPECT_NEAR(time_zero_s({}, {}, {}), kTimeZero_s, 1.0e-9);
  SequenceRun run{};
  run.run_until(kTimeZero_s + 0.1, with_load(1.0e9, 0.0, 0.0));
  const SequenceTick& zero = run.ticks[12000];
  EXPECT_NEAR(zero.decision.walk_phase_s, 0.0, 1.0e-12);
  EXPECT_TRUE(zero.decision.is_detector_armed);
  EXPECT_FALSE(run.ticks[11999].decision.is_detector_armed);
  EXPECT_DOUBLE_EQ(zero.decision.threshold_n, 784.8 + 3.0);
}

TEST(StartUp, CountsTimeZeroInWholeCyclesForOtherSettings) {
  const ReflexConfig modified{.timing = gait::RestorationTiming::kNominalCosine, .settling_s = 4.0};
  EXPECT_NEAR(start_up_s({}, modified), 3.0 + 1.2 + 2.0, 1.0e-12);
  EXPECT_NEAR(time_zero_s({}, modified, {.warm_up_s = 2.4, .learning_s = 4.9}), 6.2 + 2.4 + 9.6, 1.0e-9);
  EXPECT_NEAR(time_zero_s({}, modified, {.warm_up_s = 0.0, .learning_s = 1.0}), 6.2 + 2.4, 1.0e-9);
}

// El-Kahlout 2003, section 4.1.2, and the appendix: 5 kg at 1.2 s, trigger at 1.2625 s. Printed instants:
// 1.3625, 3.3625, 3.8625; the restoration from the formulas (printed 0.9230).
TEST(ReflexSequence, KeepsTheTimeLineOfTheThesisExample) {
  const SequenceRun run = run_with_trigger(1.2625, plain(), kHalf);
  const auto trigger = run.find(ReflexEvent::kPayloadDetected);
  ASSERT_NE(trigger, run.ticks.end());
  EXPECT_NEAR(trigger->time_s, kTimeZero_s + 1.2625, 1.0e-9);
  EXPECT_NEAR(*trigger->decision.trigger_time_s, kTimeZero_s + 1.2625, 1.0e-9);
  EXPECT_NEAR(since_trigger_s(run, ReflexEvent::kReflexDone, 1.2625), 0.1, 1.0e-9);
  EXPECT_NEAR(since_trigger_s(run, ReflexEvent::kSettled, 1.2625), 2.1, 1.0e-9);
  EXPECT_NEAR(since_trigger_s(run, ReflexEvent::kShifted, 1.2625), 2.6, 1.0e-9);
  const double restored_s = since_trigger_s(run, ReflexEvent::kRestored, 1.2625);
  EXPECT_GE(restored_s, 2.6 + 0.91243 - 1.0e-9);
  EXPECT_LT(restored_s, 2.6 + 0.91244 + kHalf);
  const double resumed_s = since_trigger_s(run, ReflexEvent::kRested, 1.2625);
  EXPECT_GE(resumed_s, 3.6 + 0.91243 - 1.0e-9);
  EXPECT_LT(resumed_s, 3.6 + 0.91244 + kHalf);
}

// Figs 3.7 and 3.8: trigger 1.2305 s, t_refl 0.2 s; the restoring step from 3.9305 to 4.8134 s.
TEST(ReflexSequence, KeepsTheTimeLineOfTheThesisFigure) {
  ReflexConfig reflex = plain();
  reflex.reflex_s = 0.2;
  const SequenceRun run = run_with_trigger(1.2305, reflex, kHalf);
  EXPECT_NEAR(since_trigger_s(run, ReflexEvent::kShifted, 1.2305) + 1.2305, 3.9305, 1.0e-9);
  EXPECT_NEAR(since_trigger_s(run, ReflexEvent::kRestored, 1.2305) + 1.2305, 4.8134, kHalf);
}

TEST(ReflexSequence, MovesReferenceAndBothFeetByTheWholeZmpError) {
  const SequenceRun run = run_with_trigger(1.2625, plain(), kHalf);
  const auto settled = run.find(ReflexEvent::kSettled);
  const auto shifted = run.find(ReflexEvent::kShifted);
  EXPECT_NEAR(settled->decision.adaptation_m, 0.0138, 1.0e-12);  // appendix A.9, 5 kg
  EXPECT_NEAR(settled->decision.reference_x_body_m, -0.09 + 0.0138, 1.0e-12);
  EXPECT_NEAR(settled->feet[kRight].position_body_m.x(), -0.11118, 5.0e-6);
  EXPECT_NEAR(shifted->feet[kRight].position_body_m.x(), -0.11118 + 0.0138, 5.0e-6);
  EXPECT_NEAR(shifted->feet[kLeft].position_body_m.x(), -0.06882 + 0.0138, 5.0e-6);
}

TEST(ReflexSequence, SteersToTheBalanceLessItsOffset) {
  const SequenceRun run = run_with_trigger(1.2625, ReflexConfig{}, kHalf);
  EXPECT_NEAR(run.ticks.back().decision.adaptation_m, 0.0138 + 0.005, 1.0e-12);
}

TEST(ReflexSequence, BoundsTheAdaptationAgainstABrokenZmp) {
  for (const double zmp_m : {5.0, -5.0}) {
    const SequenceRun run = run_with_trigger(1.2625, plain(), kHalf, zmp_m);
    EXPECT_DOUBLE_EQ(run.ticks.back().decision.adaptation_m, std::copysign(0.12, zmp_m));
  }
}

TEST(ReflexSequence, ResumesTheWalkWithTheNewReferenceAndTheFootInFrontThatSwung) {
  for (const auto& [trigger_s, phase_s] : {std::pair{1.2625, 2.4}, std::pair{3.6625, 0.0}}) {
    const SequenceRun run = run_with_trigger(trigger_s, plain(), kHalf);
    const auto walking = run.find(ReflexEvent::kRested, kTimeZero_s + 1.0);
    ASSERT_NE(walking, run.ticks.end());
    EXPECT_DOUBLE_EQ(walking->decision.walk_phase_s, phase_s);
    EXPECT_EQ(walking->decision.time_in_phase_s, 0.0);
    const FootReference walk = gait::nominal_walk({}, phase_s, -0.09 + 0.0138);
    for (const std::size_t s : {kRight, kLeft}) {
      EXPECT_LT((walking->feet[s].position_body_m - walk[s].position_body_m).norm(), 1.0e-9);
    }
  }
}

TEST(ReflexSequence, HoldsStillWhileSettling) {
  const SequenceRun run = run_with_trigger(1.2625, plain(), kHalf);
  const auto reflex_done = run.find(ReflexEvent::kReflexDone);
  for (auto it = reflex_done; it->decision.phase == ReflexPhase::kSettling; ++it) {
    for (const std::size_t s : {kRight, kLeft}) {
      EXPECT_EQ(it->feet[s].position_body_m, reflex_done->feet[s].position_body_m);
      EXPECT_EQ(it->feet[s].velocity_body_m_s.norm(), 0.0);
    }
  }
}

TEST(ReflexSequence, ShowsASkippedStepAsOneTickAndKeepsTheTimeLine) {
  ReflexConfig reflex = plain();
  reflex.method = ReflexMethod::kModified;
  const SequenceRun run = run_with_trigger(0.25, reflex, kHalf);  // double support: nothing to restore
  EXPECT_NEAR(since_trigger_s(run, ReflexEvent::kShifted, 0.25), 2.6, 1.0e-9);
  EXPECT_NEAR(since_trigger_s(run, ReflexEvent::kRestored, 0.25), 2.6 + kHalf, 1.0e-9);
  EXPECT_NEAR(since_trigger_s(run, ReflexEvent::kRested, 0.25), 3.6, 1.0e-9);
  EXPECT_DOUBLE_EQ(run.find(ReflexEvent::kRested, kTimeZero_s)->decision.walk_phase_s, 0.0);
}

TEST(ReflexSequence, MeetsASecondPayloadFromTheFirstStepOn) {
  SequenceRun run{};
  run.run_until(kTimeZero_s + 30.0, [](double time_s) {
    const double added_n = (time_s >= 13.2 ? 49.0 : 0.0) + (time_s >= 23.2 ? 49.0 : 0.0);
    return estimation::Estimate{.filtered_force_n = 784.8 + added_n, .filtered_zmp_x_body_m = -0.04 + 2e-4 * added_n};
  });
  const auto first = run.find(ReflexEvent::kPayloadDetected);
  const auto resumed = run.find(ReflexEvent::kRested, first->time_s);
  const auto second = run.find(ReflexEvent::kPayloadDetected, resumed->time_s);
  ASSERT_NE(second, run.ticks.end());
  EXPECT_TRUE(resumed->decision.is_detector_armed);
  EXPECT_DOUBLE_EQ(resumed->decision.threshold_n, 787.8 + 49.0 + 12.0);
  EXPECT_NEAR(second->time_s, 23.2, 1.5e-3);
  EXPECT_DOUBLE_EQ(run.ticks.back().decision.threshold_n, 787.8 + 98.0);
  EXPECT_EQ(run.ticks.back().decision.phase, ReflexPhase::kWalking);
  EXPECT_NEAR(run.ticks.back().decision.reference_x_body_m, -0.09 + 0.005 + 2e-4 * 98.0, 1.0e-12);
}

TEST(ReflexSequence, OnlyReportsThePayloadWhenTheReflexIsOff) {
  ReflexConfig off = plain();
  off.method = ReflexMethod::kOff;
  const SequenceRun run = run_with_trigger(1.2625, off, kHalf);
  int seen = 0;
  for (const SequenceTick& tick : run.ticks) {
    seen += tick.decision.is_payload_seen ? 1 : 0;
    if (tick.time_s >= kTimeZero_s) {
      EXPECT_EQ(tick.decision.phase, ReflexPhase::kWalking);
      const FootReference walk = gait::nominal_walk({}, tick.time_s - kTimeZero_s, -0.09);
      EXPECT_LT((tick.feet[kLeft].position_body_m - walk[kLeft].position_body_m).norm(), 1.0e-9);
    }
  }
  EXPECT_EQ(seen, 1);
  EXPECT_NEAR(*run.ticks.back().decision.trigger_time_s, kTimeZero_s + 1.2625, 1.0e-9);
}

TEST(ReflexSequence, NeverReactsWhileItLearns) {
  SequenceRun run{};
  run.run_until(kTimeZero_s - 0.01, with_load(6.0, 400.0, 0.1));
  for (const SequenceTick& tick : run.ticks) EXPECT_FALSE(tick.decision.is_payload_seen);
  EXPECT_EQ(run.find(ReflexEvent::kPayloadDetected), run.ticks.end());
}

}  // namespace
}  // namespace surefoot::decision
