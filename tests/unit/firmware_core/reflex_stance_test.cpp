#include <gtest/gtest.h>

#include <cmath>

#include "firmware/core/decision/reflex_offset.hpp"
#include "firmware/core/gait/motion_plan.hpp"
#include "firmware/core/gait/nominal_walk.hpp"
#include "firmware/core/gait/stance.hpp"

namespace surefoot {
namespace {

using decision::ReflexConfig;
using decision::ReflexMethod;

constexpr std::size_t kRight = index(Side::kRight);
constexpr std::size_t kLeft = index(Side::kLeft);
const gait::WalkParameters kWalk{};

FootReference walk_at(double phase_s) { return gait::nominal_walk(kWalk, phase_s, kWalk.reference_x_body_m); }

PerSide<double> offset(const ReflexConfig& config, double phase_s) {
  return decision::reflex_offset_x_m(kWalk, config, walk_at(phase_s), phase_s);
}

// (3.17)
TEST(ReflexOffset, IsRightBackAndLeftForwardInTheLiteralOriginal) {
  const ReflexConfig literal{.method = ReflexMethod::kOriginal, .mirrored = false};
  for (const double phase_s : {0.0, 1.2, 2.0, 2.4, 3.6, 4.7}) {
    EXPECT_EQ(offset(literal, phase_s), (PerSide<double>{-0.01, 0.01})) << phase_s;
  }
}

TEST(ReflexOffset, IsMirroredInTheHalfInWhichTheRightFootSwings) {
  const ReflexConfig mirrored{.method = ReflexMethod::kOriginal, .mirrored = true};
  for (const double phase_s : {0.0, 0.4, 1.2, 2.3}) {
    EXPECT_EQ(offset(mirrored, phase_s), (PerSide<double>{-0.01, 0.01})) << phase_s;
    EXPECT_EQ(offset(mirrored, phase_s + 2.4), (PerSide<double>{0.01, -0.01})) << phase_s;
  }
}

// (4.5)(4.6)
TEST(ReflexOffset, MovesTheStandingFootForwardInTheModifiedMethodAndNothingInDoubleSupport) {
  const ReflexConfig modified{.method = ReflexMethod::kModified};
  EXPECT_EQ(offset(modified, 1.2), (PerSide<double>{0.01, -0.01}));
  EXPECT_EQ(offset(modified, 3.6), (PerSide<double>{-0.01, 0.01}));
  for (const double phase_s : {0.0, 0.5, 1.9, 2.4, 2.9, 4.3}) {
    EXPECT_EQ(offset(modified, phase_s), (PerSide<double>{0.0, 0.0})) << phase_s;
  }
}

TEST(ReflexStance, PutsBothFeetDownAtHipWidthAndKeepsTheirDistanceTravelled) {
  const FootReference stance = gait::reflex_stance(kWalk, walk_at(1.2625), {-0.01, 0.01});
  EXPECT_NEAR(stance[kRight].position_body_m.x(), walk_at(1.2625)[kRight].position_body_m.x() - 0.01, 1.0e-15);
  EXPECT_NEAR(stance[kLeft].position_body_m.x(), walk_at(1.2625)[kLeft].position_body_m.x() + 0.01, 1.0e-15);
  EXPECT_DOUBLE_EQ(stance[kRight].position_body_m.y(), -0.11);
  EXPECT_DOUBLE_EQ(stance[kLeft].position_body_m.y(), 0.11);
  for (const FootPath& foot : stance) {
    EXPECT_DOUBLE_EQ(foot.position_body_m.z(), -0.5);
    EXPECT_EQ(foot.velocity_body_m_s.norm(), 0.0);
  }
}

gait::MotionPlan reflex_at(double trigger_s, gait::MotionProfile profile, double duration_s) {
  const FootReference start = walk_at(trigger_s);
  return gait::move(start, gait::reflex_stance(kWalk, start, {-0.01, 0.01}), profile, duration_s);
}

// Appendix A.7: ramp speeds for the trigger at 1.2625 s. With the printed (3.16) z would jump by 0.7 m.
TEST(ReflexMotion, RunsTheRampAtTheSpeedsOfTheExample) {
  const gait::MotionPlan plan = reflex_at(1.2625, gait::MotionProfile::kRamp, 0.1);
  const FootReference start = gait::foot_reference(kWalk, plan, 0.0);
  const FootReference inside = gait::foot_reference(kWalk, plan, 0.05);
  EXPECT_NEAR(std::abs(inside[kLeft].velocity_body_m_s.y()), 1.296, 5.0e-4);
  EXPECT_NEAR(inside[kLeft].velocity_body_m_s.z(), -0.294, 5.0e-4);
  EXPECT_NEAR(inside[kRight].velocity_body_m_s.x(), -0.1, 1.0e-12);
  for (const Side side : kSides) {
    EXPECT_LT((start[index(side)].position_body_m - walk_at(1.2625)[index(side)].position_body_m).norm(), 1.0e-12);
  }
  EXPECT_LT((gait::foot_reference(kWalk, plan, 0.1)[kLeft].position_body_m - plan.end[kLeft].position_body_m).norm(),
            1.0e-9);
}

// Appendix A.7: peak lateral reference speed 2.42 m/s at 0.1 s and 1.21 m/s at 0.2 s.
TEST(ReflexMotion, PeaksAtTheSpeedsOfTheSmoothExample) {
  for (const auto& [duration_s, peak_m_s] : {std::pair{0.1, 2.42}, std::pair{0.2, 1.21}}) {
    const gait::MotionPlan plan = reflex_at(1.2625, gait::MotionProfile::kQuintic, duration_s);
    double largest_m_s = 0.0;
    for (double t = 0.0; t < duration_s; t += 1.0e-4) {
      const FootReference feet = gait::foot_reference(kWalk, plan, t);
      largest_m_s = std::max(largest_m_s, std::abs(feet[kLeft].velocity_body_m_s.y()));
    }
    EXPECT_NEAR(largest_m_s, peak_m_s, 0.02);
  }
}

TEST(ReflexMotion, StartsTheQuinticWithTheGaitsSpeedAndAcceleration) {
  for (double trigger_s = 0.013; trigger_s < 4.8; trigger_s += 0.05) {
    const gait::MotionPlan plan = reflex_at(trigger_s, gait::MotionProfile::kQuintic, 0.1);
    const FootReference first = gait::foot_reference(kWalk, plan, 1.0e-12);
    const FootReference last = gait::foot_reference(kWalk, plan, 0.1 - 1.0e-12);
    for (const Side side : kSides) {
      const FootPath walk = walk_at(trigger_s)[index(side)];
      EXPECT_LT((first[index(side)].velocity_body_m_s - walk.velocity_body_m_s).norm(), 1.0e-8);
      EXPECT_LT((first[index(side)].acceleration_body_m_s2 - walk.acceleration_body_m_s2).norm(), 1.0e-6);
      EXPECT_LT(last[index(side)].velocity_body_m_s.norm(), 1.0e-8);
    }
  }
}

TEST(ReflexMotion, NeverPushesAFootThroughTheFloor) {
  for (const auto profile : {gait::MotionProfile::kRamp, gait::MotionProfile::kQuintic}) {
    for (double trigger_s = 0.0; trigger_s < 4.8; trigger_s += 0.005) {
      for (const double duration_s : {0.1, 0.2}) {
        const gait::MotionPlan plan = reflex_at(trigger_s, profile, duration_s);
        for (double t = 0.0; t < duration_s; t += 0.001) {
          for (const FootPath& foot : gait::foot_reference(kWalk, plan, t)) {
            ASSERT_GE(foot.position_body_m.z(), -kWalk.body_height_m - 1.0e-12) << trigger_s << " " << t;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace surefoot
