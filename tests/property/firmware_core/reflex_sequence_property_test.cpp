#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>

#include "tests/unit/firmware_core/sequence_run.hpp"

namespace surefoot::decision {
namespace {

constexpr std::size_t kRight = index(Side::kRight);
constexpr std::size_t kLeft = index(Side::kLeft);

ReflexConfig any_reflex() {
  ReflexConfig reflex;
  reflex.method = *rc::gen::element(ReflexMethod::kOriginal, ReflexMethod::kModified, ReflexMethod::kCapture);
  reflex.mirrored = *rc::gen::arbitrary<bool>();
  reflex.profile = *rc::gen::element(gait::MotionProfile::kRamp, gait::MotionProfile::kQuintic);
  reflex.timing = *rc::gen::element(gait::RestorationTiming::kAcosFactor, gait::RestorationTiming::kNominalCosine);
  reflex.reflex_s = *rc::gen::element(0.1, 0.2, 0.0837);
  reflex.settling_s = *rc::gen::element(2.0, 4.0, 0.3331);
  return reflex;
}

/// A whole sequence, from power-up to the first cycles after the recovery, with one trigger.
struct WholeRun {
  SequenceRun run{};
  double load_s = 0.0;
  SequenceRun::Sensed sensed{};

  WholeRun(const ReflexConfig& reflex, double period_s, double trigger_s, double zmp_m) {
    run.reflex = reflex;
    run.reflex.standing_s = 0.2;
    run.detector = {.warm_up_s = 0.0, .learning_s = 1.0, .margin_n = 3.0};
    run.period_s = period_s;
    load_s = std::ceil(time_zero_s(run.walk, run.reflex, run.detector) / period_s) * period_s + trigger_s;
    sensed = with_load(load_s, 49.0, zmp_m);
  }

  /// Calls `visit(before, now)` for each pair of neighbouring ticks.
  template <typename Visit>
  void each(Visit visit) {
    SequenceTick before = run.next(sensed);
    while (before.time_s < load_s + 11.0) {
      const SequenceTick now = run.next(sensed);
      visit(before, now);
      before = now;
    }
  }

  /// How long the motion of `before` had run at the exact instant at which that of `now` began.
  [[nodiscard]] double end_of_motion_s(const SequenceTick& before, const SequenceTick& now) const {
    return before.decision.time_in_phase_s + run.period_s - now.decision.time_in_phase_s;
  }
};

WholeRun any_run() {
  const double period_s = *rc::gen::element(1.0e-3, 0.5e-3);
  const double trigger_s = 1.0e-3 * *rc::gen::inRange(0, 4800);
  const double zmp_m = 1.0e-4 * *rc::gen::inRange(-500, 500);
  return {any_reflex(), period_s, trigger_s, zmp_m};
}

TEST(ReflexSequenceProperty, PositionsAreContinuousAcrossEveryPhaseBoundary) {
  RC_ASSERT(rc::check("position", [] {
    WholeRun whole = any_run();
    int boundaries = 0;
    whole.each([&](const SequenceTick& before, const SequenceTick& now) {
      if (!now.decision.event) return;
      ++boundaries;
      const FootReference old_end =
          gait::foot_reference(whole.run.walk, before.decision.motion, whole.end_of_motion_s(before, now));
      const FootReference new_begin = gait::foot_reference(whole.run.walk, now.decision.motion, 0.0);
      for (const std::size_t s : {kRight, kLeft}) {
        RC_ASSERT((old_end[s].position_body_m - new_begin[s].position_body_m).norm() < 1.0e-9);
      }
    });
    RC_ASSERT(boundaries == 9);  // three of the start-up, six of the reflex
  }));
}

TEST(ReflexSequenceProperty, PositionsFollowTheVelocitiesFromTickToTick) {
  RC_ASSERT(rc::check("tick to tick", [] {
    WholeRun whole = any_run();
    whole.each([&](const SequenceTick& before, const SequenceTick& now) {
      for (const std::size_t s : {kRight, kLeft}) {
        const auto& v0 = before.feet[s].velocity_body_m_s;
        const auto& v1 = now.feet[s].velocity_body_m_s;
        const geometry::Vector3 moved_m = now.feet[s].position_body_m - before.feet[s].position_body_m;
        RC_ASSERT(moved_m.allFinite());
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
          const double fastest = std::max(std::abs(v0[axis]), std::abs(v1[axis]));
          RC_ASSERT(std::abs(moved_m[axis]) <= fastest * whole.run.period_s + 1.0e-4);
        }
      }
    });
  }));
}

// Appendices A.7 and A.8: the ramp steps at the trigger, at the reflex' end and at both ends of the shift;
// the quintic nowhere. Everything else begins and ends at rest.
TEST(ReflexSequenceProperty, VelocitiesJumpOnlyWhereTheRampMust) {
  RC_ASSERT(rc::check("velocity", [] {
    WholeRun whole = any_run();
    whole.each([&](const SequenceTick& before, const SequenceTick& now) {
      const std::optional<ReflexEvent> event = now.decision.event;
      if (!event) return;
      const bool may_jump = whole.run.reflex.profile == gait::MotionProfile::kRamp &&
                            whole.run.reflex.method != ReflexMethod::kCapture &&
                            (event == ReflexEvent::kPayloadDetected || event == ReflexEvent::kReflexDone ||
                             event == ReflexEvent::kSettled || event == ReflexEvent::kShifted);
      if (may_jump) return;
      const double end_s = whole.end_of_motion_s(before, now);
      const FootReference old_end = gait::foot_reference(whole.run.walk, before.decision.motion, end_s - 1.0e-9);
      const FootReference new_begin = gait::foot_reference(whole.run.walk, now.decision.motion, 1.0e-9);
      for (const std::size_t s : {kRight, kLeft}) {
        RC_ASSERT((old_end[s].velocity_body_m_s - new_begin[s].velocity_body_m_s).norm() < 1.0e-5);
      }
    });
  }));
}

TEST(ReflexSequenceProperty, FeetStayOnOrAboveTheFloorAndOneOfThemOnIt) {
  RC_ASSERT(rc::check("floor", [] {
    WholeRun whole = any_run();
    const double floor_m = -whole.run.walk.body_height_m;
    whole.each([&](const SequenceTick&, const SequenceTick& now) {
      const double right_m = now.feet[kRight].position_body_m.z() - floor_m;
      const double left_m = now.feet[kLeft].position_body_m.z() - floor_m;
      RC_ASSERT(std::min(right_m, left_m) > -1.0e-12);
      RC_ASSERT(std::min(right_m, left_m) < 1.0e-12);
    });
  }));
}

TEST(ReflexSequenceProperty, EveryPhaseBeginsWithTheFirstTickNotBeforeItsInstant) {
  RC_ASSERT(rc::check("instants", [] {
    WholeRun whole = any_run();
    std::map<ReflexEvent, double> since_trigger_s;
    double step_s = 0.0;
    double shift_s = whole.run.reflex.shift_s;
    whole.each([&](const SequenceTick&, const SequenceTick& now) {
      if (now.decision.phase == ReflexPhase::kShifting) shift_s = now.decision.motion.duration_s;
      if (!now.decision.event || !now.decision.trigger_time_s) return;
      since_trigger_s[*now.decision.event] = now.time_s - *now.decision.trigger_time_s;
      step_s = now.decision.restoration.duration_s();
    });
    const ReflexConfig& reflex = whole.run.reflex;
    const double t1 = reflex.reflex_s, t2 = t1 + reflex.settling_s, t3 = t2 + shift_s;
    const double t6 = t3 + step_s, t7 = t6 + 0.5 * reflex.settling_s;
    const auto is_on_time = [&](ReflexEvent event, double instant_s) {
      const double late_s = since_trigger_s.at(event) - instant_s;
      return late_s > -1.0e-8 && late_s < whole.run.period_s;
    };
    RC_ASSERT(since_trigger_s.at(ReflexEvent::kPayloadDetected) == 0.0);
    RC_ASSERT(is_on_time(ReflexEvent::kReflexDone, t1));
    RC_ASSERT(is_on_time(ReflexEvent::kSettled, t2));
    RC_ASSERT(is_on_time(ReflexEvent::kShifted, t3));
    RC_ASSERT(step_s == 0.0 || is_on_time(ReflexEvent::kRestored, t6));
    RC_ASSERT(is_on_time(ReflexEvent::kRested, t7));
  }));
}

// The thesis' own symmetry: a load half a cycle later gives the mirrored motion, unless (3.17) is literal.
TEST(ReflexSequenceProperty, ATriggerHalfACycleLaterGivesTheMirroredFeet) {
  RC_ASSERT(rc::check("mirror", [] {
    ReflexConfig reflex = any_reflex();
    reflex.mirrored = true;
    const int trigger_ms = *rc::gen::inRange(0, 2400);
    // Beside the lift at 0.5 s and the landing at 1.9 s rounding decides in which tick the foot is in the air.
    RC_PRE(std::abs(trigger_ms - 500) > 5 && std::abs(trigger_ms - 1900) > 5);
    const double trigger_s = 1.0e-3 * trigger_ms;
    WholeRun first(reflex, 1.0e-3, trigger_s, -0.02);
    WholeRun second(reflex, 1.0e-3, trigger_s + 2.4, -0.02);
    while (first.run.next(first.sensed).decision.phase != ReflexPhase::kReflex) continue;
    while (second.run.next(second.sensed).decision.phase != ReflexPhase::kReflex) continue;
    for (int k = 0; k < 11000; ++k) {
      const SequenceTick a = first.run.next(first.sensed);
      const SequenceTick b = second.run.next(second.sensed);
      RC_ASSERT(a.decision.phase == b.decision.phase);
      for (const Side side : kSides) {
        const geometry::Vector3 mine = a.feet[index(side)].position_body_m;
        const geometry::Vector3 theirs = b.feet[index(opposite(side))].position_body_m;
        RC_ASSERT((mine - geometry::Vector3(theirs.x(), -theirs.y(), theirs.z())).norm() < 1.0e-6);
      }
    }
  }));
}

}  // namespace
}  // namespace surefoot::decision
