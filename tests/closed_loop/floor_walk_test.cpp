#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/closed_loop/run_scenario.hpp"
#include "tools/floor/criteria_walk.hpp"
#include "tools/floor/floor_cases.hpp"
#include "tools/floor/torso_trace.hpp"
#include "tools/table/experiment.hpp"

namespace surefoot::floor {
namespace {

scenario::Scenario scenario_of(FloorCase floor, const std::string& set, std::uint64_t seed = 1,
                               const std::vector<std::string>& further = {}) {
  batch::Batch batch = base_of({}, {});
  const std::vector<std::string> overrides = overrides_of(floor, 3.0, seed, 10.0);
  batch.common.insert(batch.common.end(), overrides.begin(), overrides.end());
  batch.common.push_back("stabilizer.set=" + set);
  batch.common.insert(batch.common.end(), further.begin(), further.end());
  return table::load_common(batch);
}

// Kim, Park, Oh 2007, Fig. 23 (0.8 degrees), and Fig. 24: the controllers are silent on a flat floor.
TEST(FloorWalk, StaysUprightOnTheFlatAndHardlyDiffersWithThePapersControllers) {
  const run::Verdict bare = run::run_lockstep(scenario_of(FloorCase::kFlat, "off"), {});
  ASSERT_EQ(bare.outcome, run::Outcome::kWalked) << bare.reason;
  EXPECT_LE(bare.torso_roll_deg.largest_magnitude(), 1.5);
  EXPECT_LE(bare.torso_pitch_deg.largest_magnitude(), 1.5);
  EXPECT_GT(bare.torso_roll_deg.largest_magnitude(), 0.1) << "it sways, it does not stand";
  const run::Verdict paper = run::run_lockstep(scenario_of(FloorCase::kFlat, "paper"), {});
  ASSERT_EQ(paper.outcome, run::Outcome::kWalked) << paper.reason;
  EXPECT_NEAR(paper.torso_roll_deg.largest_magnitude(), bare.torso_roll_deg.largest_magnitude(), 0.3);
  EXPECT_NEAR(paper.torso_pitch_deg.largest_magnitude(), bare.torso_pitch_deg.largest_magnitude(), 0.3);
}

/// Largest outputs of all controllers together since the first lift.
struct LargestOutputs {
  double pelvis_m = 0.0;
  double ankle_rad = 0.0;
  double landing_m = 0.0;
};

LargestOutputs largest_outputs(const ObservedWalk& walk) {
  double pelvis_m = 0.0;
  double ankle_rad = 0.0;
  double landing_m = 0.0;
  for (const ObservedTick& tick : walk.ticks) {
    if (tick.time_s < 0.0) continue;
    const stabilizer::Adjustment& total = tick.total;
    for (const double way_m : {total.pelvis_x_m, total.pelvis_y_m, total.pelvis_z_m, total.sway_m,
                               total.sway_centre_x_m, total.sway_centre_y_m}) {
      pelvis_m = std::max(pelvis_m, std::abs(way_m));
    }
    for (const Side side : kSides) {
      ankle_rad = std::max(
          {ankle_rad, std::abs(total.ankle_roll_rad[index(side)]), std::abs(total.ankle_pitch_rad[index(side)])});
    }
    landing_m = std::max({landing_m, std::abs(total.landing_x_m), std::abs(total.landing_y_m)});
  }
  return {pelvis_m, ankle_rad, landing_m};
}

TEST(FloorWalk, HardlyNeedsThePapersControllersOnTheFlat) {
  const ObservedWalk walk = observe(scenario_of(FloorCase::kFlat, "paper"));
  ASSERT_FALSE(walk.has_fallen);
  const LargestOutputs outputs = largest_outputs(walk);
  EXPECT_LE(outputs.pelvis_m, 0.008);
  EXPECT_LE(outputs.ankle_rad, 0.007) << "0.4 degrees";
  EXPECT_LE(outputs.landing_m, 0.004);
}

// The extended set sways as a pendulum; on the flat its controllers have little to add to that.
TEST(FloorWalk, HardlyNeedsTheExtendedControllersOnTheFlat) {
  const std::vector<std::string> pendulum{"pattern.sway_profile=pendulum"};
  const run::Verdict bare = run::run_lockstep(scenario_of(FloorCase::kFlat, "off", 1, pendulum), {});
  ASSERT_EQ(bare.outcome, run::Outcome::kWalked) << bare.reason;
  EXPECT_LE(bare.torso_roll_deg.largest_magnitude(), 0.8) << "the paper's robot";
  const run::Verdict helped = run::run_lockstep(scenario_of(FloorCase::kFlat, "extended"), {});
  ASSERT_EQ(helped.outcome, run::Outcome::kWalked) << helped.reason;
  EXPECT_NEAR(helped.torso_roll_deg.largest_magnitude(), bare.torso_roll_deg.largest_magnitude(), 0.3);
  EXPECT_NEAR(helped.torso_pitch_deg.largest_magnitude(), bare.torso_pitch_deg.largest_magnitude(), 0.3);
  const LargestOutputs outputs = largest_outputs(observe(scenario_of(FloorCase::kFlat, "extended")));
  EXPECT_LE(outputs.pelvis_m, 0.008);
  EXPECT_LE(outputs.ankle_rad, 0.0088) << "half a degree";
  EXPECT_LE(outputs.landing_m, 0.004);
}

class OnTilesOnASlope : public ::testing::TestWithParam<std::uint64_t> {};

// Kim, Park, Oh 2007, Fig. 24: 2 degrees, pitch below roll.
TEST_P(OnTilesOnASlope, TheExtendedSetLeansLessThanThePapersRobot) {
  const run::Verdict verdict = run::run_lockstep(scenario_of(FloorCase::kBoth, "extended", GetParam()), {});
  EXPECT_EQ(verdict.outcome, run::Outcome::kWalked) << verdict.reason;
  EXPECT_LE(verdict.torso_roll_deg.largest_magnitude(), 2.0);
  EXPECT_LE(verdict.torso_pitch_deg.largest_magnitude(), verdict.torso_roll_deg.largest_magnitude());
}

INSTANTIATE_TEST_SUITE_P(FloorWalk, OnTilesOnASlope, ::testing::Values(1, 2, 3));

// Fig. 26. Plates under half a foot tilt it while it takes over the weight; without ground seeking a late foot topples
// the robot, without the edge limits its own ankles do.
TEST(FloorWalk, CrossesARoomWithPlatesOnItsTilesInSteps) {
  for (const std::uint64_t seed : {1U, 8U}) {
    const run::Verdict verdict =
        run::run_lockstep(scenario_of(FloorCase::kRoom, "extended", seed, {"duration_s=25"}), {});
    EXPECT_EQ(verdict.outcome, run::Outcome::kWalked) << verdict.reason;
    EXPECT_GE(verdict.distance_m, 4.5);
    EXPECT_LE(verdict.torso_roll_deg.largest_magnitude(), 2.0);
    EXPECT_LE(verdict.torso_pitch_deg.largest_magnitude(), 2.0);
  }
}

TEST(FloorWalk, GoesAheadInStepsOfTwentyCentimetres) {
  const run::Verdict verdict =
      run::run_lockstep(scenario_of(FloorCase::kFlat, "extended", 1, {"pattern.step_length_m=0.2"}), {});
  EXPECT_EQ(verdict.outcome, run::Outcome::kWalked) << verdict.reason;
  EXPECT_GE(verdict.distance_m, 1.5);
  EXPECT_LE(verdict.distance_m, 10.0 / 0.95 * 0.2);
}

TEST(FloorWalk, GivesTheSameBitsTwiceAndOthersOnOtherTiles) {
  const auto trace = [](std::uint64_t seed) {
    return trace_of(scenario_of(FloorCase::kBoth, "extended", seed, {"duration_s=3", "pattern.standing_s=4"}));
  };
  const TorsoTrace first = trace(1);
  ASSERT_EQ(first.time_s.size(), 150U);
  const TorsoTrace second = trace(1);
  EXPECT_EQ(first.roll_deg, second.roll_deg);
  EXPECT_EQ(first.pitch_deg, second.pitch_deg);
  EXPECT_NE(first.roll_deg, trace(2).roll_deg);
}

// The trace is the same walk as the one that is judged.
TEST(FloorWalk, IsTracedAsItIsJudged) {
  const scenario::Scenario scenario =
      scenario_of(FloorCase::kGlobal, "extended", 1, {"duration_s=2", "pattern.standing_s=2"});
  const run::Verdict verdict = run::run_lockstep(scenario, {});
  double largest_deg = 0.0;
  for (const double roll_deg : trace_of(scenario).roll_deg) largest_deg = std::max(largest_deg, std::abs(roll_deg));
  EXPECT_LE(largest_deg, verdict.torso_roll_deg.largest_magnitude());
  EXPECT_NEAR(largest_deg, verdict.torso_roll_deg.largest_magnitude(), 0.05) << "samples are 20 ms apart";
}

}  // namespace
}  // namespace surefoot::floor
