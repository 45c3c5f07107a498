#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "tools/floor/ablation.hpp"
#include "tools/floor/floor_maps.hpp"
#include "tools/floor/floor_table.hpp"
#include "tools/map/survival_map.hpp"
#include "tools/table/experiment.hpp"

namespace surefoot::floor {
namespace {

scenario::Scenario loaded(const batch::Batch& batch, std::size_t trial) {
  batch::Batch alone = batch;
  const std::vector<std::string>& own = batch.trials.at(trial).overrides;
  alone.common.insert(alone.common.end(), own.begin(), own.end());
  return table::load_common(alone);
}

scenario::Scenario loaded(FloorCase floor, std::uint64_t seed, const std::vector<std::string>& common = {}) {
  batch::Batch batch = base_of({}, common);
  batch.trials = {{overrides_of(floor, 3.0, seed, 10.0)}};
  return loaded(batch, 0);
}

// Kim, Park, Oh 2007, section 4: tiles of 30 x 30 x 4 mm, a slope in roll and in pitch, both; on the spot.
TEST(FloorCases, SetTilesAndSlopeAsThePaperHasThem) {
  struct Wanted {
    FloorCase floor;
    double tile_m;
    double slope_deg;
  };
  for (const Wanted& wanted : {Wanted{FloorCase::kFlat, 0.0, 0.0}, Wanted{FloorCase::kLocal, 0.004, 0.0},
                               Wanted{FloorCase::kGlobal, 0.0, 3.0}, Wanted{FloorCase::kBoth, 0.004, 3.0}}) {
    const scenario::Scenario scenario = loaded(wanted.floor, 7);
    SCOPED_TRACE(name(wanted.floor));
    EXPECT_EQ(scenario.robot, "khr2");
    EXPECT_EQ(scenario.sim.terrain.tile_height_m, wanted.tile_m);
    EXPECT_EQ(scenario.sim.terrain.tile_edge_m, 0.03);
    EXPECT_EQ(scenario.sim.terrain.tile_seed, 7U);
    EXPECT_EQ(scenario.sim.terrain.plates_per_m2, 0.0);
    EXPECT_EQ(scenario.sim.contact.slope_roll_deg, wanted.slope_deg);
    EXPECT_EQ(scenario.sim.contact.slope_pitch_deg, wanted.slope_deg);
    EXPECT_EQ(scenario.firmware.floor.pattern.step_length_m, 0.0);
    EXPECT_EQ(scenario.duration_s, 10.0);
    EXPECT_TRUE(scenario.sim.payloads.empty());
  }
}

TEST(FloorCases, CrossTheRoomOnEveryTileHeightAndSlopeWithinTwelveSeeds) {
  std::set<std::vector<double>> rooms;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const scenario::Scenario room = loaded(FloorCase::kRoom, seed);
    const sim_hw::TerrainConfig& terrain = room.sim.terrain;
    EXPECT_EQ(room.firmware.floor.pattern.step_length_m, 0.2);
    EXPECT_GT(terrain.plates_per_m2, 0.0);
    EXPECT_EQ(terrain.plate_edge_m, 0.12);
    EXPECT_EQ(terrain.plate_height_m, 0.004);
    EXPECT_EQ(std::abs(room.sim.contact.slope_roll_deg), 1.0);
    EXPECT_EQ(std::abs(room.sim.contact.slope_pitch_deg), 1.0);
    EXPECT_GE(terrain.tile_height_m, 0.002);
    EXPECT_LE(terrain.tile_height_m, 0.004);
    rooms.insert({terrain.tile_height_m, room.sim.contact.slope_roll_deg, room.sim.contact.slope_pitch_deg});
    const double steps = room.duration_s / (0.5 * room.firmware.walk.cycle_s());
    EXPECT_GT(steps * 0.2, 10.0) << "metres";
  }
  EXPECT_EQ(rooms.size(), 12U);
}

// A scenario file for a rough room must not make the flat case rough.
TEST(FloorCases, WinOverWhatTheScenarioSaysOfTheFloor) {
  const scenario::Scenario flat =
      loaded(FloorCase::kFlat, 1,
             {"floor.tile_height_m=0.01", "floor.tile_edge_m=0.1", "floor.slope_roll_deg=5", "floor.slope_pitch_deg=-5",
              "floor.plates_per_m2=3", "pattern.step_length_m=0.1", "duration_s=3"});
  EXPECT_EQ(flat.sim.terrain.tile_height_m, 0.0);
  EXPECT_EQ(flat.sim.terrain.plates_per_m2, 0.0);
  EXPECT_EQ(flat.sim.contact.slope_roll_deg, 0.0);
  EXPECT_EQ(flat.sim.contact.slope_pitch_deg, 0.0);
  EXPECT_EQ(flat.firmware.floor.pattern.step_length_m, 0.0);
  EXPECT_EQ(flat.duration_s, 10.0);
}

// Kim, Park, Oh 2007, Figs 23 and 24: +2 degrees without controllers, +3 with them.
TEST(FloorTable, WalksTheSlopeThatThePaperHasForEachSet) {
  const FloorTableSpec spec{{"off", "paper", "extended"}, {4, 9}};
  const batch::Batch batch = table_batch(spec, base_of({}, {}));
  ASSERT_EQ(batch.trials.size(), 3U * (1 + 2 + 1 + 2 + 2)) << "floors without seeds are walked once";
  const scenario::Scenario bare = loaded(batch, 5);  // off, both, second seed
  EXPECT_EQ(bare.controllers, "off");
  EXPECT_EQ(bare.sim.contact.slope_roll_deg, 2.0);
  EXPECT_EQ(bare.sim.terrain.tile_seed, 9U);
  const scenario::Scenario paper = loaded(batch, 8 + 3);  // paper, global
  EXPECT_EQ(paper.controllers, "paper");
  EXPECT_EQ(paper.sim.contact.slope_roll_deg, 3.0);
  EXPECT_EQ(paper.firmware.floor.stabilizer.is_on, stabilizer::paper_set());
}

TEST(FloorTable, ReadsSeedsAscendingAndOnce) {
  EXPECT_EQ(parse_seeds("1-4"), (std::vector<std::uint64_t>{1, 2, 3, 4}));
  EXPECT_EQ(parse_seeds("9,2-3,3,1"), (std::vector<std::uint64_t>{1, 2, 3, 9}));
  EXPECT_EQ(parse_seeds("0"), (std::vector<std::uint64_t>{0}));
  EXPECT_EQ(parse_seeds("1-1000").size(), 1000U);
}

TEST(FloorTable, RefusesTextThatNamesNoSeeds) {
  for (const char* text : {"", "x", "1-", "-3", "4-1", "1,,2", "1-2-3", "1 - 3", "1.5", "1-1001", "1-1000,2000",
                           "99999999999999999999", "9007199254740992", "1,"}) {
    EXPECT_THROW(static_cast<void>(parse_seeds(text)), BadSeeds) << text;
  }
}

TEST(FloorAblation, SwitchesEachControllerOnAloneAndOffInTheSet) {
  const Ablation plan = planned({"extended", {1, 2}});
  const batch::Batch batch = ablation_batch(plan, base_of({}, {}));
  ASSERT_EQ(batch.trials.size(), 2 * plan.rows.size());
  const stabilizer::Switches set = stabilizer::extended_set();
  const auto all = std::count(set.begin(), set.end(), true);
  std::size_t alone = 0;
  std::size_t without = 0;
  for (std::size_t row = 0; row < plan.rows.size(); ++row) {
    const scenario::Scenario scenario = loaded(batch, 2 * row + 1);
    EXPECT_EQ(scenario.sim.terrain.tile_seed, 2U);
    EXPECT_EQ(scenario.sim.terrain.tile_height_m, 0.004);
    EXPECT_EQ(scenario.sim.contact.slope_pitch_deg, 3.0);
    const stabilizer::Switches& is_on = scenario.firmware.floor.stabilizer.is_on;
    const auto count = std::count(is_on.begin(), is_on.end(), true);
    for (const stabilizer::ActivationRow& entry : stabilizer::kActivation) {
      const auto place = static_cast<std::size_t>(entry.controller);
      const std::string controller = stabilizer::name(entry.controller);
      if (plan.rows[row].what == controller + " alone") {
        ++alone;
        EXPECT_TRUE(is_on[place] && count == 1) << controller;
      }
      if (plan.rows[row].what == "extended without " + controller) {
        ++without;
        EXPECT_TRUE(!is_on[place] && count == all - 1) << controller;
      }
    }
  }
  EXPECT_EQ(alone, stabilizer::kControllers);
  EXPECT_EQ(plan.rows.size(), 1 + alone + 1 + without);
}

TEST(FloorMaps, VarySlopeAndTilesUnderBothSets) {
  const map::MapSpec spec = rough_map({5}, 10.0);
  const batch::Batch batch = map::map_batch(spec, base_of({}, {}));
  ASSERT_EQ(batch.trials.size(), 2U * 11U * 7U);
  const scenario::Scenario last = loaded(batch, batch.trials.size() - 1);
  EXPECT_EQ(last.controllers, "extended");
  EXPECT_EQ(last.sim.contact.slope_roll_deg, 10.0);
  EXPECT_EQ(last.sim.contact.slope_pitch_deg, 10.0);
  EXPECT_NEAR(last.sim.terrain.tile_height_m, 0.012, 1e-12);
  EXPECT_EQ(last.sim.terrain.tile_seed, 5U);
  EXPECT_EQ(loaded(batch, 0).controllers, "paper");
}

TEST(FloorMaps, PushWithTheImpulseOfTheRow) {
  const batch::Batch batch = map::map_batch(push_map(10.0), base_of({}, {}));
  ASSERT_EQ(batch.trials.size(), 2U * 5U * 8U * 2U);
  for (const std::size_t trial : {std::size_t{2}, batch.trials.size() - 1}) {  // 5 N s left, 25 N s right
    const scenario::Scenario scenario = loaded(batch, trial);
    ASSERT_EQ(scenario.sim.pushes.size(), 1U);
    const sim_hw::PushConfig& push = scenario.sim.pushes[0];
    EXPECT_NEAR(push.force_n[1] * push.duration_s, trial == 2 ? 5.0 : -25.0, 1e-9);
    EXPECT_EQ(push.point_body_m[2], 0.25);
    EXPECT_GE(push.at_s, kFirstPush_s);
    EXPECT_LT(push.at_s, kFirstPush_s + scenario.firmware.walk.cycle_s());
  }
}

TEST(FloorMaps, HangTheLoadOfTheRowWithAndWithoutTheReflex) {
  const batch::Batch batch = map::map_batch(payload_map(10.0), base_of({}, {}));
  ASSERT_EQ(batch.trials.size(), 2U * 8U * 8U * 2U);
  for (const std::size_t trial : {std::size_t{0}, batch.trials.size() - 1}) {
    const scenario::Scenario scenario = loaded(batch, trial);
    ASSERT_EQ(scenario.sim.payloads.size(), 1U);
    EXPECT_EQ(scenario.sim.payloads[0].mass_kg, trial == 0 ? 5.0 : 40.0);
    EXPECT_GE(scenario.sim.payloads[0].at_s, kFirstPush_s);
    EXPECT_LT(scenario.sim.payloads[0].at_s, kFirstPush_s + scenario.firmware.walk.cycle_s());
    EXPECT_EQ(scenario.firmware.reflex.method == decision::ReflexMethod::kOff, trial == 0);
    EXPECT_EQ(scenario.duration_s, 15.0);
    EXPECT_EQ(scenario.sim.contact.slope_roll_deg, 3.0);
  }
}

}  // namespace
}  // namespace surefoot::floor
