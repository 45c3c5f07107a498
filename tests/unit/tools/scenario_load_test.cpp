#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/tools/scenario_testing.hpp"

namespace surefoot::scenario {
namespace {

using testing::HasSubstr;

TEST(ScenarioLoad, MainJobWithoutAFileIsMainToml) {
  EXPECT_EQ(to_toml(load_default()), to_toml(load(scenario_folder() / "main.toml")));
}

TEST(ScenarioLoad, MainJobHangsFiveKilogramsOnTheThesisPlantAtOnePointTwoSeconds) {
  const Scenario scenario = load_default();
  EXPECT_EQ(scenario.robot, "elkahlout");
  EXPECT_EQ(scenario.plant, "thesis");
  EXPECT_EQ(scenario.duration_s, 20.0);
  EXPECT_EQ(scenario.firmware.reflex.method, decision::ReflexMethod::kOriginal);
  ASSERT_EQ(scenario.sim.payloads.size(), 1U);
  EXPECT_EQ(scenario.sim.payloads[0].mass_kg, 5.0);
  EXPECT_EQ(scenario.sim.payloads[0].at_s, 1.2);
}

TEST(ScenarioLoad, EveryShippedScenarioLoadsAndSaysFirstWhatItShows) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(scenario_folder())) {
    SCOPED_TRACE(entry.path());
    EXPECT_NO_THROW((void)load(entry.path()));
    std::string first_line;
    std::getline(std::ifstream(entry.path()) >> std::ws, first_line);
    EXPECT_THAT(first_line, testing::StartsWith("# "));
    ++count;
  }
  EXPECT_GE(count, 7U);
}

TEST(ScenarioLoad, FileWithoutPayloadHasNone) { EXPECT_TRUE(load_text("walk.toml", "seed = 3").sim.payloads.empty()); }

TEST(ScenarioLoad, PlantThesisIsTheDefaultAndHasAShortSoleAndASlipperyFloor) {
  const Scenario scenario = load_text("walk.toml", "seed = 3");
  EXPECT_EQ(scenario.plant, "thesis");
  EXPECT_EQ(scenario.firmware.geometry.sole_heel_m, 0.0923);
  EXPECT_EQ(scenario.firmware.geometry.sole_toe_m, 0.1228);
  EXPECT_EQ(scenario.firmware.geometry.sole_width_m, 0.138);
  EXPECT_EQ(scenario.sim.contact.friction, 0.11);
}

TEST(ScenarioLoad, PlantNominalHasTheLongSoleAndNormalFriction) {
  const Scenario scenario = load_text("walk.toml", "plant = \"nominal\"");
  EXPECT_EQ(scenario.firmware.geometry.sole_heel_m, 0.08);
  EXPECT_EQ(scenario.firmware.geometry.sole_toe_m, 0.17);
  EXPECT_EQ(scenario.firmware.geometry.sole_width_m, 0.138);
  EXPECT_EQ(scenario.sim.contact.friction, 0.7);
}

TEST(ScenarioLoad, KeysOfTheFileWinOverThePlant) {
  const Scenario scenario = load_text("walk.toml", "plant = \"thesis\"\n[floor]\nfriction = 0.3");
  EXPECT_EQ(scenario.sim.contact.friction, 0.3);
  EXPECT_EQ(scenario.firmware.geometry.sole_toe_m, 0.1228);
}

TEST(ScenarioLoad, PlantOfAnOverrideIsThePreset) {
  const std::vector<std::string> overrides{"plant=nominal"};
  EXPECT_EQ(load_default(overrides).sim.contact.friction, 0.7);
}

// El-Kahlout 2003, section 4.3: the modified method waits 4 s instead of 2.
TEST(ScenarioLoad, ModifiedReflexSettlesTwiceAsLongUnlessToldOtherwise) {
  EXPECT_EQ(load_text("w", "[reflex]\nmethod = \"original\"").firmware.reflex.settling_s, 2.0);
  EXPECT_EQ(load_text("w", "[reflex]\nmethod = \"modified\"").firmware.reflex.settling_s, 4.0);
  EXPECT_EQ(load_text("w", "[reflex]\nmethod = \"modified\"\nsettling_s = 3.0").firmware.reflex.settling_s, 3.0);
  const std::vector<std::string> overrides{"reflex.method=modified"};
  EXPECT_EQ(load_default(overrides).firmware.reflex.settling_s, 4.0);
}

TEST(ScenarioLoad, NumbersThatStandOnceReachFirmwareAndSimulator) {
  const Scenario scenario = load_text("w",
                                      "control_period_s = 0.002\n[geometry]\nthigh_m = 0.28\n"
                                      "[gate]\ntorque_limit_nm = 150");
  EXPECT_EQ(scenario.firmware.period_s, 0.002);
  EXPECT_EQ(scenario.sim.control_period_s, 0.002);
  EXPECT_EQ(scenario.firmware.geometry.thigh_m, 0.28);
  EXPECT_EQ(scenario.sim.geometry.thigh_m, 0.28);
  EXPECT_EQ(scenario.firmware.servo.torque_limit_nm, 150.0);
  EXPECT_EQ(scenario.firmware.gate.torque_limit_nm, 150.0);
  EXPECT_EQ(scenario.sim.drive.torque_limit_nm, 150.0);
}

TEST(ScenarioLoad, MotorsMayHaveALimitOfTheirOwn) {
  const Scenario scenario = load_text("w", "[gate]\ntorque_limit_nm = 150\n[drive]\ntorque_limit_nm = 100");
  EXPECT_EQ(scenario.firmware.gate.torque_limit_nm, 150.0);
  EXPECT_EQ(scenario.sim.drive.torque_limit_nm, 100.0);
}

TEST(ScenarioLoad, PayloadsComeSortedByTime) {
  const Scenario scenario =
      load_text("w", "[[payload]]\nat_s = 9\nmass_kg = 1\n[[payload]]\nat_s = 3\nmass_kg = 2\n[[payload]]\nat_s = 5");
  ASSERT_EQ(scenario.sim.payloads.size(), 3U);
  EXPECT_EQ(scenario.sim.payloads[0].mass_kg, 2.0);
  EXPECT_EQ(scenario.sim.payloads[1].mass_kg, 5.0);
  EXPECT_EQ(scenario.sim.payloads[2].mass_kg, 1.0);
}

TEST(ScenarioLoad, IntegersStandForNumbers) { EXPECT_EQ(load_text("w", "duration_s = 7").duration_s, 7.0); }

TEST(ScenarioLoad, SixteenPayloadsAreTaken) {
  std::string text;
  for (std::size_t i = 0; i < kMaxPayloads; ++i) text += "[[payload]]\n";
  EXPECT_EQ(load_text("w", text).sim.payloads.size(), kMaxPayloads);
  EXPECT_THAT(refusal_of(text + "[[payload]]\n"), HasSubstr("payload has 17 tables; expected at most 16"));
}

TEST(ScenarioLoad, ValidateAcceptsEveryPresetAndAPlainScenario) {
  EXPECT_NO_THROW(validate(Scenario{}));
  EXPECT_NO_THROW(validate(load_default()));
}

TEST(ScenarioLoad, ValidateRefusesAScenarioWhoseRoomsDisagree) {
  Scenario scenario;
  scenario.firmware.geometry.thigh_m = 0.3;
  EXPECT_THROW(validate(scenario), ScenarioError);
  share_numbers(scenario);
  EXPECT_NO_THROW(validate(scenario));
}

TEST(ScenarioLoad, ValidateRefusesWhatNoFileCanSay) {
  Scenario scenario;
  scenario.robot = "asimo";
  scenario.sim.payloads.push_back({.mass_kg = -1.0});
  try {
    validate(scenario);
    FAIL() << "accepted";
  } catch (const ScenarioError& error) {
    ASSERT_EQ(error.problems().size(), 2U);
    EXPECT_EQ(error.problems()[1].statement, "payload[0].mass_kg is -1.0; expected 0 to 60 kg");
  }
}

}  // namespace
}  // namespace surefoot::scenario
