#include <gtest/gtest.h>

#include <cmath>

#include "firmware/core/stabilizer/ground_seeking.hpp"
#include "tests/unit/firmware_core/flat_walk.hpp"

namespace surefoot::stabilizer {
namespace {

constexpr GroundSeekingConfig kConfig{};
constexpr double kPeriod_s = 1.0e-3;

/// The first tick of a step whose foot was to land on this side.
StabilizerInput step_begins(Side landing, double force_n) {
  StabilizerInput input;
  input.period_s = kPeriod_s;
  input.walk.begins_step = true;
  input.walk.is_double_support = true;
  input.walk.moving = landing;
  input.walk.stage = landing == Side::kLeft ? decision::WalkStage::kLowerLeft : decision::WalkStage::kLowerRight;
  input.walk.has_landed = true;  // by the plan
  input.ankle[index(landing)].normal_force_n = force_n;
  input.ankle[index(opposite(landing))].normal_force_n = FlatWalk::kWeight_n - force_n;
  return input;
}

TEST(GroundSeeking, ReachesDownAtItsSpeedUntilTheSoleCarriesThenComesBack) {
  for (const Side late : kSides) {
    GroundSeekingState state;
    StabilizerInput input = step_begins(late, 0.0);
    double length_m = 0.0;
    for (int k = 1; k <= 40; ++k) {
      length_m = step(kConfig, state, input, true).leg_length_m[index(late)];
      EXPECT_NEAR(length_m, 0.1 * k * kPeriod_s, 1e-12);
      input.walk.begins_step = false;
    }
    input.ankle[index(late)].normal_force_n = 60.0;
    for (int k = 0; k < 300; ++k) static_cast<void>(step(kConfig, state, input, true));
    input.ankle[index(late)].normal_force_n = 0.0;  // it has met the floor: a bounce starts no second search
    const Adjustment later = step(kConfig, state, input, true);
    EXPECT_NEAR(later.leg_length_m[index(late)], 0.004 * std::exp(-0.301 / 0.3), 1e-9);
    EXPECT_EQ(later.leg_length_m[index(opposite(late))], 0.0);
  }
}

TEST(GroundSeeking, FindsNoFloorBeyondItsBound) {
  GroundSeekingState state;
  StabilizerInput input = step_begins(Side::kLeft, 0.0);
  Adjustment adjustment;
  for (int k = 0; k < 1000; ++k) {
    adjustment = step(kConfig, state, input, true);
    input.walk.begins_step = false;
  }
  EXPECT_DOUBLE_EQ(adjustment.leg_length_m[index(Side::kLeft)], kConfig.max_length_m);
}

TEST(GroundSeeking, LeavesAFootAloneThatLandedInTime) {
  FlatWalk walk(kPeriod_s);
  GroundSeekingState state;
  for (int k = 0; k < 4000; ++k) {
    const Adjustment adjustment = step(kConfig, state, walk.next(), true);
    ASSERT_EQ(adjustment.leg_length_m[0], 0.0);
    ASSERT_EQ(adjustment.leg_length_m[1], 0.0);
  }
}

TEST(GroundSeeking, GivesUpWhereItMayNotActAndWhenTheFootIsLiftedAgain) {
  GroundSeekingState state;
  StabilizerInput input = step_begins(Side::kRight, 0.0);
  static_cast<void>(step(kConfig, state, input, true));
  input.walk.begins_step = false;
  static_cast<void>(step(kConfig, state, input, false));
  EXPECT_LT(step(kConfig, state, input, true).leg_length_m[0], 1.0e-4);
  state = {};
  input.walk.begins_step = true;
  static_cast<void>(step(kConfig, state, input, true));
  EXPECT_LT(step(kConfig, state, standing_on(Side::kLeft, kPeriod_s), true).leg_length_m[0], 1.0e-4);
}

}  // namespace
}  // namespace surefoot::stabilizer
