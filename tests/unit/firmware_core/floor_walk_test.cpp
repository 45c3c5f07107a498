#include "firmware/core/gait/floor_walk.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace surefoot::gait {
namespace {

using decision::WalkStage;
using stabilizer::Adjustment;
using stabilizer::WalkView;

constexpr double kTick_s = 1e-3;

WalkParameters khr2_walk() {
  WalkParameters walk;
  walk.single_support_s = 0.9025;
  walk.double_support_s = 0.0475;
  walk.foot_offset_y_m = 0.071;
  walk.sway_m = 0.06;
  walk.body_height_m = 0.65;
  walk.swing_height_m = 0.04;
  return walk;
}

/// A walk on a floor that the plan knows: a foot carries when its reference is down.
class PlannedWalk {
 public:
  explicit PlannedWalk(double step_length_m = 0.0) {
    pattern.step_length_m = step_length_m;
    pattern.standing_s = 0.5;
  }

  WalkView tick() {
    PerSide<estimation::AnkleLoad> load{};
    for (const Side side : kSides) {
      const bool is_down = feet[index(side)].position_body_m.z() < -walk.body_height_m + 1e-4 + floor_m;
      load[index(side)].normal_force_n = is_down && carries ? 275.0 : 0.0;
    }
    const WalkView view = advance(walk, pattern, state, load, adjust, stops, kTick_s);
    feet = foot_reference(walk, pattern, state, adjust);
    return view;
  }

  /// Ticks until a stage begins; the last view. At most 10 s.
  WalkView until(WalkStage stage) {
    WalkView view = tick();
    for (int i = 0; i < 10'000 && view.stage != stage; ++i) view = tick();
    EXPECT_EQ(view.stage, stage);
    return view;
  }

  WalkParameters walk = khr2_walk();
  FourFactorParameters pattern{};
  FloorWalkState state{};
  Adjustment adjust{};
  FootReference feet = [this] {
    FootReference both;
    for (const Side side : kSides) both[index(side)].position_body_m.z() = -walk.body_height_m;
    return both;
  }();
  double floor_m = 0.0;  ///< a foot touches so much above the plan's floor
  bool carries = true;
  bool stops = false;
};

TEST(FloorWalk, GoesThroughTheFourStagesInTheirOrder) {
  PlannedWalk walk;
  std::vector<WalkStage> seen{WalkStage::kStanding};
  for (int i = 0; i < 8000; ++i) {
    const WalkStage stage = walk.tick().stage;
    if (stage != seen.back()) seen.push_back(stage);
  }
  const std::vector<WalkStage> begin{WalkStage::kStanding,  WalkStage::kShifting,  WalkStage::kLiftLeft,
                                     WalkStage::kLowerLeft, WalkStage::kLiftRight, WalkStage::kLowerRight,
                                     WalkStage::kLiftLeft,  WalkStage::kLowerLeft};
  ASSERT_GT(seen.size(), begin.size());
  EXPECT_TRUE(std::equal(begin.begin(), begin.end(), seen.begin()));
}

TEST(FloorWalk, MovesNoReferenceFasterThanItsPattern) {
  for (const double length_m : {0.0, 0.2}) {
    PlannedWalk walk(length_m);
    walk.tick();
    double fastest_m_s = 0.0;
    for (int i = 0; i < 12'000; ++i) {
      const FootReference before = walk.feet;
      walk.tick();
      for (const Side side : kSides) {
        const geometry::Vector3 way = walk.feet[index(side)].position_body_m - before[index(side)].position_body_m;
        fastest_m_s = std::max(fastest_m_s, way.norm() / kTick_s);
      }
    }
    // Swing foot: pi d / T_ssp and the pelvis below it.
    EXPECT_LT(fastest_m_s, length_m > 0.0 ? 1.0 : 0.35) << length_m;
    EXPECT_GT(fastest_m_s, 0.1);
  }
}

TEST(FloorWalk, StepsAreAsLongAsTheyShallBe) {
  PlannedWalk walk(0.2);
  walk.until(WalkStage::kLiftLeft);
  for (int step = 0; step < 6; ++step) {
    walk.until(step % 2 == 0 ? WalkStage::kLiftRight : WalkStage::kLiftLeft);
    const double ahead_m = std::abs(walk.state.foothold_m[0].x() - walk.state.foothold_m[1].x());
    EXPECT_NEAR(ahead_m, 0.2, 1e-3) << step;
  }
}

TEST(FloorWalk, ClockStandsUntilTheLandingFootCarriesWhereItIsToWait) {
  PlannedWalk walk;
  walk.adjust.waits_for_contact = true;
  walk.until(WalkStage::kLowerLeft);
  walk.carries = false;
  for (int i = 0; i < 700; ++i) walk.tick();
  WalkView view = walk.tick();
  EXPECT_TRUE(view.is_waiting);
  EXPECT_FALSE(view.has_landed);
  EXPECT_EQ(view.stage, WalkStage::kLowerLeft);
  EXPECT_DOUBLE_EQ(view.swing_share, 1.0);
  walk.carries = true;
  view = walk.tick();
  EXPECT_TRUE(view.has_landed);
  EXPECT_TRUE(view.begins_step);
}

TEST(FloorWalk, GoesOnWithoutContactWhereItIsNotToWaitAndNeverWaitsForEver) {
  for (const bool waits : {false, true}) {
    PlannedWalk walk;
    walk.adjust.waits_for_contact = waits;
    walk.until(WalkStage::kLowerLeft);
    walk.carries = false;
    int ticks = 0;
    while (walk.tick().stage == WalkStage::kLowerLeft && ticks < 10'000) ++ticks;
    EXPECT_NEAR(ticks * kTick_s, 0.5 * 0.9025 + 0.0475 + (waits ? walk.pattern.longest_wait_s : 0.0), 0.01);
  }
}

TEST(FloorWalk, AnEarlierLandingEndsTheStepSoMuchEarlier) {
  PlannedWalk walk;
  walk.until(WalkStage::kLowerLeft);
  walk.adjust.earlier_landing_s = 0.1;
  int ticks = 0;
  while (!walk.tick().begins_step && ticks < 10'000) ++ticks;
  EXPECT_NEAR(ticks * kTick_s, 0.5 * 0.9025 - 0.1, 0.004);
}

TEST(FloorWalk, AHeldFootStaysWhereItTouchedAndSinksBackSlowly) {
  PlannedWalk walk;
  walk.floor_m = 0.005;
  WalkView view = walk.until(WalkStage::kLowerLeft);
  while (!view.has_landed) view = walk.tick();
  walk.adjust.holds_lowering = true;
  walk.tick();
  const double held_m = walk.state.foothold_m[index(Side::kLeft)].z();
  EXPECT_NEAR(held_m, 0.005, 1e-3);
  while (!walk.tick().begins_step) {
    EXPECT_EQ(walk.state.foothold_m[index(Side::kLeft)].z(), held_m);
  }
  walk.adjust.holds_lowering = false;
  for (int i = 0; i < 300; ++i) walk.tick();
  EXPECT_NEAR(walk.state.foothold_m[index(Side::kLeft)].z(), held_m * std::exp(-1.0), 2e-4);
}

TEST(FloorWalk, AShiftedLandingMovesTheNextStepWithIt) {
  PlannedWalk walk;
  walk.until(WalkStage::kLowerLeft);
  walk.adjust.landing_y_m = 0.02;
  WalkView view = walk.tick();
  while (!view.begins_step) view = walk.tick();
  EXPECT_NEAR(walk.state.foothold_m[index(Side::kLeft)].y(), 0.091, 1e-4);
  walk.adjust.landing_y_m = 0.0;
  do view = walk.tick();
  while (!view.begins_step);
  EXPECT_NEAR(walk.state.foothold_m[index(Side::kRight)].y(), 0.02 - 0.071, 1e-4) << "as wide a stance as before";
  EXPECT_NEAR(walk.state.foothold_m[index(Side::kLeft)].y(), 0.091, 1e-4) << "a foot that stands is not dragged";
}

TEST(FloorWalk, StopsOnBothFeetWhateverItWasDoing) {
  for (const int after_ticks : {100, 1500, 2600, 3000, 3400, 5000}) {
    PlannedWalk walk(0.1);
    for (int i = 0; i < after_ticks; ++i) walk.tick();
    walk.stops = true;
    WalkView view;
    for (int i = 0; i < 4000; ++i) view = walk.tick();
    EXPECT_EQ(view.stage, WalkStage::kStanding) << after_ticks;
    const double right_m = walk.feet[0].position_body_m.z();
    EXPECT_NEAR(right_m, -walk.walk.body_height_m, 1e-5);
    EXPECT_NEAR(walk.feet[1].position_body_m.z(), right_m, 1e-5);
    EXPECT_NEAR(walk.feet[1].position_body_m.y() + walk.feet[0].position_body_m.y(), 0.0, 1e-3);
  }
}

TEST(FloorWalk, StartsToWalkWhenTheStartUpIsOver) {
  PlannedWalk walk;
  int ticks = 0;
  while (walk.tick().stage != WalkStage::kLiftLeft && ticks < 10'000) ++ticks;
  EXPECT_NEAR((ticks + 1) * kTick_s, start_up_s(walk.walk, walk.pattern), 2.5e-3);
}

}  // namespace
}  // namespace surefoot::gait
