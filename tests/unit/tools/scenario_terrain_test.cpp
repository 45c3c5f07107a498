#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/tools/scenario_testing.hpp"
#include "tools/sweep/key_kind.hpp"

namespace surefoot::scenario {
namespace {

using testing::HasSubstr;

TEST(ScenarioTerrain, EveryKeyArrives) {
  const Scenario scenario = load_text(
      "walk.toml",
      "[floor]\ntile_height_m = 0.004\ntile_edge_m = 0.04\ntile_seed = 7\nplates_per_m2 = 3\nplate_height_m = 0.005\n"
      "plate_edge_m = 0.1\n"
      "[drive]\nrotor_share = [1, 0.125, 0.25, 0.25, 0.125, 0.125]\nservo_stiffness_nm_per_rad = [1, 2, 3, 4, 5, 6]\n"
      "servo_damping_nm_s_per_rad = [6, 5, 4, 3, 2, 1]\nhip_roll_stiffness_nm_per_rad = 1500\n"
      "hip_roll_damping_nm_s_per_rad = 3\n"
      "[sensor]\nhas_inertial_legs = false\nhip_gyro_range_rad_s = 2\ninclinometer_range_rad = 0.3\n"
      "foot_accelerometer_range_m_s2 = 30\n"
      "[[patch]]\nkind = \"ramp\"\ncentre_m = [2, -1]\nsize_m = [1, 0.5]\nheight_m = 0.05\nfriction = 0.2\n"
      "[[patch]]\nkind = \"friction\"\n");
  const sim_hw::TerrainConfig& terrain = scenario.sim.terrain;
  EXPECT_EQ(terrain.tile_height_m, 0.004);
  EXPECT_EQ(terrain.tile_edge_m, 0.04);
  EXPECT_EQ(terrain.tile_seed, 7U);
  EXPECT_EQ(terrain.plates_per_m2, 3.0);
  EXPECT_EQ(terrain.plate_height_m, 0.005);
  EXPECT_EQ(terrain.plate_edge_m, 0.1);
  const sim_hw::DriveConfig& drive = scenario.sim.drive;
  EXPECT_EQ(drive.rotor_share[2], 0.25);
  EXPECT_EQ(drive.servo_stiffness_nm_per_rad[4], 5.0);
  EXPECT_EQ(drive.servo_damping_nm_s_per_rad[0], 6.0);
  EXPECT_EQ(drive.hip_roll_stiffness_nm_per_rad, 1500.0);
  EXPECT_EQ(drive.hip_roll_damping_nm_s_per_rad, 3.0);
  EXPECT_EQ(scenario.sim.sensor.hip_gyro_range_rad_s, 2.0);
  EXPECT_EQ(scenario.sim.sensor.inclinometer_range_rad, 0.3);
  EXPECT_EQ(scenario.sim.sensor.foot_accelerometer_range_m_s2, 30.0);
  ASSERT_EQ(terrain.patches.size(), 2U);
  const sim_hw::PatchConfig& ramp = terrain.patches[0];
  EXPECT_EQ(ramp.kind, sim_hw::PatchKind::kRamp);
  EXPECT_EQ(ramp.centre_m, (std::array{2.0, -1.0}));
  EXPECT_EQ(ramp.size_m, (std::array{1.0, 0.5}));
  EXPECT_EQ(ramp.height_m, 0.05);
  EXPECT_EQ(ramp.friction, 0.2);
  EXPECT_EQ(terrain.patches[1].kind, sim_hw::PatchKind::kFriction);
}

TEST(ScenarioTerrain, WithoutItsKeysTheFloorIsAPlaneTheHipsAreRigidAndEveryRotorIsWhole) {
  const Scenario scenario = load_default();
  EXPECT_EQ(scenario.sim.terrain.tile_height_m, 0.0);
  EXPECT_EQ(scenario.sim.terrain.plates_per_m2, 0.0);
  EXPECT_TRUE(scenario.sim.terrain.patches.empty());
  EXPECT_EQ(scenario.sim.drive.hip_roll_stiffness_nm_per_rad, 0.0);
  EXPECT_EQ(scenario.sim.drive.rotor_share, (LegVector{1, 1, 1, 1, 1, 1}));
  EXPECT_THAT(to_toml(scenario), HasSubstr("\npatch = []\n"));
}

TEST(ScenarioTerrain, PatchesKeepTheOrderOfTheFileAndAreSetFromTheCommandLine) {
  const std::vector<std::string> set{"patch.1.kind=ramp", "patch.2.height_m=0.02"};
  const Scenario scenario = load_text("w", "[[patch]]\nheight_m = 0.03\n[[patch]]\nheight_m = 0.01\n", set);
  ASSERT_EQ(scenario.sim.terrain.patches.size(), 3U);
  EXPECT_EQ(scenario.sim.terrain.patches[0].height_m, 0.03);
  EXPECT_EQ(scenario.sim.terrain.patches[1].kind, sim_hw::PatchKind::kRamp);
  EXPECT_EQ(scenario.sim.terrain.patches[2].height_m, 0.02);
  EXPECT_TRUE(load_text("w", "[[patch]]", std::vector<std::string>{"patch=[]"}).sim.terrain.patches.empty());
}

TEST(ScenarioTerrain, PatchesMayBeSwept) {
  EXPECT_EQ(sweep::kind_of("patch.3.height_m"), sweep::KeyKind::kNumber);
  EXPECT_EQ(sweep::kind_of("patch.0.kind"), sweep::KeyKind::kChoice);
  EXPECT_EQ(sweep::kind_of("patch"), sweep::KeyKind::kArray);
  EXPECT_EQ(sweep::kind_of("floor.tile_seed"), sweep::KeyKind::kInteger);
}

TEST(ScenarioTerrain, TheLongestEffectiveScenarioCanBeReadBack) {
  Scenario scenario = load_default();
  scenario.sim.payloads.resize(kMaxPayloads);
  scenario.sim.pushes.resize(sim_hw::kMaxPushes);
  scenario.sim.terrain.patches.resize(sim_hw::kMaxPatches);
  scenario.sim.faults.resize(sim_hw::kMaxFaults);
  const std::filesystem::path file = write_file(to_toml(scenario));
  EXPECT_EQ(load(file).sim.terrain.patches.size(), sim_hw::kMaxPatches);
}

TEST(ScenarioTerrain, TooManyPatchesAreRefused) {
  std::string text;
  for (std::size_t i = 0; i < sim_hw::kMaxPatches; ++i) text += "[[patch]]\n";
  EXPECT_EQ(load_text("w", text).sim.terrain.patches.size(), sim_hw::kMaxPatches);
  EXPECT_THAT(refusal_of(text + "[[patch]]\n"), HasSubstr("patch has 65 tables; expected at most 64"));
}

struct BadTerrain {
  const char* text;
  const char* message;  ///< begins with the place
};

void PrintTo(const BadTerrain& bad, std::ostream* stream) { *stream << on_one_line(bad.text); }

class RefusedTerrain : public testing::TestWithParam<BadTerrain> {};

TEST_P(RefusedTerrain, NamesFileLineColumnKeyExpectationAndRemedy) {
  const std::string message = refusal_of(GetParam().text);
  EXPECT_THAT(message, testing::StartsWith(GetParam().message));
  EXPECT_THAT(message, HasSubstr("\n  remedy: "));
}

INSTANTIATE_TEST_SUITE_P(
    Table, RefusedTerrain,
    testing::Values(
        BadTerrain{"[floor]\ntile_height_m = 0.06",
                   "walk.toml:2:17: floor.tile_height_m is 0.06; expected 0 to 0.05 m"},
        BadTerrain{"[floor]\ntile_seed = -1", "walk.toml:2:13: floor.tile_seed is -1; expected 0 to"},
        BadTerrain{"[floor]\nplates_per_m2 = 70",
                   "walk.toml:2:17: floor.plates_per_m2 is 70; expected at most 69.44, one on each square"},
        BadTerrain{"[[patch]]\nkind = \"hole\"",
                   "walk.toml:2:8: patch[0].kind is \"hole\"; expected one of \"plate\", \"ramp\", \"friction\""},
        BadTerrain{"[[patch]]\nheight_m = -0.1", "walk.toml:2:12: patch[0].height_m is -0.1; expected 0 to 0.3 m"},
        BadTerrain{"[[patch]]\nsize_m = [0.1, 0]", "walk.toml:2:16: patch[0].size_m[1] is 0; expected 0.005 to 1000 m"},
        BadTerrain{"[[patch]]\nhight_m = 0.1",
                   "walk.toml:2:1: patch[0].hight_m is unknown; did you mean patch[0].height_m?"},
        BadTerrain{"[patch]\nheight_m = 0.1", "walk.toml:1:1: patch is a table; expected an array of tables"},
        BadTerrain{"[drive]\nrotor_share = [1, 1]", "walk.toml:2:15: drive.rotor_share is an array of 2; expected"},
        BadTerrain{"[drive]\nrotor_inertia_kg_m2 = 0\nhip_roll_stiffness_nm_per_rad = 1500",
                   "walk.toml: drive.hip_roll_stiffness_nm_per_rad is 1500; expected at most 0"}));

}  // namespace
}  // namespace surefoot::scenario
