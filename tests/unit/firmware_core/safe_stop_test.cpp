#include "firmware/core/gait/safe_stop.hpp"

#include <gtest/gtest.h>

#include "firmware/core/gait/nominal_walk.hpp"
#include "tests/unit/firmware_core/sequence_run.hpp"

namespace surefoot::gait {
namespace {

const WalkParameters kWalk{};

TEST(SafeStop, PutsBothFeetDownSideToSideWhereTheyAre) {
  for (double phase_s = 0.0; phase_s < 4.8; phase_s += 0.1) {
    const FootReference now = nominal_walk(kWalk, phase_s, -0.07);
    const MotionPlan plan = safe_stop(kWalk, {}, now);
    for (const double time_s : {0.2, 0.5, 1000.0}) {
      const FootReference end = foot_reference(kWalk, plan, time_s);
      for (const Side side : kSides) {
        const FootPath& foot = end[index(side)];
        EXPECT_DOUBLE_EQ(foot.position_body_m.x(), now[index(side)].position_body_m.x());
        EXPECT_DOUBLE_EQ(foot.position_body_m.y(), lateral_sign(side) * 0.11);
        EXPECT_DOUBLE_EQ(foot.position_body_m.z(), -0.5);
        EXPECT_EQ(foot.velocity_body_m_s.norm(), 0.0);
      }
    }
  }
}

TEST(SafeStop, BeginsWithPositionAndVelocityOfTheGait) {
  const FootReference now = nominal_walk(kWalk, 0.9, -0.09);
  const FootReference begin = foot_reference(kWalk, safe_stop(kWalk, {}, now), 0.0);
  for (const Side side : kSides) {
    EXPECT_EQ(begin[index(side)].position_body_m, now[index(side)].position_body_m);
    EXPECT_EQ(begin[index(side)].velocity_body_m_s, now[index(side)].velocity_body_m_s);
  }
}

}  // namespace
}  // namespace surefoot::gait

namespace surefoot::decision {
namespace {

const gait::SafeStopConfig kStop{};
const auto kUnloaded = with_load(1e9, 0.0, 0.0);

Decision ordered(SequenceRun& run, double time_s, const SequenceRun::Sensed& sensed) {
  return step(run.walk, run.reflex, run.detector, run.state, sensed(time_s), run.period_s, &kStop);
}

// The load comes 12.5 s after power-up, so that every phase has its time.
TEST(SafeStop, IsReachedFromEveryPhaseInTheTickOfTheOrderAndNeverLeft) {
  const auto sensed = with_load(12.5, 60.0, -0.02);
  std::array<bool, kReflexPhases.size()> is_seen{};
  for (double stop_s = 0.05; stop_s < 20.0; stop_s += 0.25) {
    SequenceRun run;
    run.run_until(stop_s, sensed);
    const ReflexPhase before = run.ticks.back().decision.phase;
    is_seen[static_cast<std::size_t>(before)] = true;
    Decision decision = ordered(run, stop_s, sensed);
    EXPECT_EQ(decision.event, ReflexEvent::kStopOrdered) << name(before);
    EXPECT_EQ(decision.phase, ReflexPhase::kStopped);
    EXPECT_EQ(decision.time_in_phase_s, 0.0);
    for (int k = 0; k < 5000; ++k) {
      decision = ordered(run, stop_s + 10.0, sensed);
      ASSERT_FALSE(decision.event);
      ASSERT_FALSE(decision.is_payload_seen);
      ASSERT_EQ(decision.phase, ReflexPhase::kStopped);
    }
    const SequenceTick later = run.next(sensed);  // the order may end: the stop does not
    EXPECT_EQ(later.decision.phase, ReflexPhase::kStopped);
  }
  is_seen[static_cast<std::size_t>(ReflexPhase::kReflex)] = true;  // 0.1 s: the property tests fall into it
  is_seen[static_cast<std::size_t>(ReflexPhase::kStopped)] = true;
  for (const bool seen : is_seen) EXPECT_TRUE(seen);
}

TEST(SafeStop, OrderedInTheFirstTickStandsWhereTheRobotStands) {
  SequenceRun run;
  const Decision decision = ordered(run, 0.0, kUnloaded);
  const FootReference feet = gait::foot_reference(run.walk, decision.motion, 1.0);
  for (const Side side : kSides) EXPECT_DOUBLE_EQ(feet[index(side)].position_body_m.x(), -0.09);
}

// The guard of the adaptation: a ZMP outside the feet is the sensors' invention.
TEST(ReflexSequence, DoesNotShiftTheFeetByAZmpThatLiesOutsideThem) {
  for (const bool is_within : {true, false}) {
    SequenceRun run;
    const auto loaded = with_load(12.5, 60.0, -0.01);
    run.run_until(20.0, [&](double time_s) {
      estimation::Estimate estimate = loaded(time_s);
      estimate.is_zmp_within_feet = is_within;
      return estimate;
    });
    const auto settled = run.find(ReflexEvent::kSettled);
    ASSERT_NE(settled, run.ticks.end());
    EXPECT_EQ(settled->decision.refused_adaptations, is_within ? 0 : 1);
    EXPECT_EQ(settled->decision.adaptation_m != 0.0, is_within);
    EXPECT_EQ(settled->decision.reference_x_body_m == -0.09, !is_within);
    EXPECT_EQ(run.ticks.back().decision.phase, ReflexPhase::kWalking) << "the rest of the sequence goes on";
  }
}

}  // namespace
}  // namespace surefoot::decision
