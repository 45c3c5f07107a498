#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/tools/scenario_testing.hpp"

namespace surefoot::scenario {
namespace {

using testing::HasSubstr;

Scenario main_job_with(const std::vector<std::string>& overrides) { return load_default(overrides); }

TEST(ScenarioOverride, NumbersBooleansAndArraysAreTomlValues) {
  const Scenario scenario = main_job_with({"gait.half_step_m=0.05", "reflex.mirrored=false", "seed=42",
                                           "servo.kd_nm_s_per_rad=[1, 2, 3.5, 4, 5, 6]", " duration_s=7"});
  EXPECT_EQ(scenario.firmware.walk.half_step_m, 0.05);
  EXPECT_FALSE(scenario.firmware.reflex.mirrored);
  EXPECT_EQ(scenario.sim.seed, 42U);
  EXPECT_EQ(scenario.firmware.servo.gains[2].kd_nm_s_per_rad, 3.5);
  EXPECT_EQ(scenario.duration_s, 7.0);
}

TEST(ScenarioOverride, BareAndQuotedWordsAreStrings) {
  EXPECT_EQ(main_job_with({"reflex.method=off"}).firmware.reflex.method, decision::ReflexMethod::kOff);
  EXPECT_EQ(main_job_with({"reflex.method=\"off\""}).firmware.reflex.method, decision::ReflexMethod::kOff);
  EXPECT_EQ(main_job_with({"contact.model=bullet"}).sim.contact.model, sim_hw::ContactModel::kBullet);
  EXPECT_EQ(main_job_with({"reflex.timing=nominal_cosine"}).firmware.reflex.timing,
            gait::RestorationTiming::kNominalCosine);
}

TEST(ScenarioOverride, TheLaterOfTwoWins) { EXPECT_EQ(main_job_with({"seed=1", "seed=2"}).sim.seed, 2U); }

TEST(ScenarioOverride, PayloadIsChangedByItsPlace) {
  const Scenario scenario = main_job_with({"payload.0.mass_kg=10"});
  ASSERT_EQ(scenario.sim.payloads.size(), 1U);
  EXPECT_EQ(scenario.sim.payloads[0].mass_kg, 10.0);
  EXPECT_EQ(scenario.sim.payloads[0].at_s, 1.2);
}

TEST(ScenarioOverride, PayloadAtTheNextPlaceIsAppended) {
  const Scenario scenario = main_job_with({"payload.1.at_s=11.2", "payload.1.mass_kg=7"});
  ASSERT_EQ(scenario.sim.payloads.size(), 2U);
  EXPECT_EQ(scenario.sim.payloads[1].at_s, 11.2);
  EXPECT_EQ(scenario.sim.payloads[1].mass_kg, 7.0);
}

TEST(ScenarioOverride, FirstPayloadIsAppendedToAFileWithoutAny) {
  const std::vector<std::string> overrides{"payload.0.mass_kg=2.5"};
  EXPECT_EQ(load_text("w", "seed = 1", overrides).sim.payloads.at(0).mass_kg, 2.5);
}

TEST(ScenarioOverride, PlacesAreThoseOfTheFileNotOfTime) {
  const std::vector<std::string> overrides{"payload.0.mass_kg=2.5"};
  const Scenario scenario = load_text("w", "[[payload]]\nat_s = 9\n[[payload]]\nat_s = 3\n", overrides);
  EXPECT_EQ(scenario.sim.payloads.at(1).mass_kg, 2.5);
}

TEST(ScenarioOverride, EmptyArrayRemovesAllPayloads) {
  EXPECT_TRUE(main_job_with({"payload=[]"}).sim.payloads.empty());
  EXPECT_EQ(main_job_with({"payload=[]", "payload.0.at_s=4"}).sim.payloads.at(0).at_s, 4.0);
}

TEST(ScenarioOverride, InlineTableReplacesOnePayload) {
  const Scenario scenario = main_job_with({"payload.0={mass_kg = 1}", "payload.1={at_s = 7}"});
  ASSERT_EQ(scenario.sim.payloads.size(), 2U);
  EXPECT_EQ(scenario.sim.payloads[0].mass_kg, 1.0);
  EXPECT_EQ(scenario.sim.payloads[1].at_s, 7.0);
}

TEST(ScenarioOverride, InlineTablesReplaceAllPayloads) {
  const Scenario scenario = main_job_with({"payload=[{mass_kg = 1, at_s = 2}, {mass_kg = 3, at_s = 4}]"});
  EXPECT_EQ(scenario.sim.payloads.at(1).mass_kg, 3.0);
}

struct BadOverride {
  const char* text;
  const char* message;
};

void PrintTo(const BadOverride& bad, std::ostream* stream) { *stream << on_one_line(bad.text); }

class RefusedOverride : public testing::TestWithParam<BadOverride> {};

TEST_P(RefusedOverride, NamesItselfAndTheRemedy) {
  const std::string message = refusal_of("[[payload]]\n", {GetParam().text});
  EXPECT_THAT(message, testing::StartsWith(std::string("--set ") + GetParam().text + ": "));
  EXPECT_THAT(message, HasSubstr(GetParam().message));
  EXPECT_THAT(message, HasSubstr("\n  remedy: "));
}

INSTANTIATE_TEST_SUITE_P(
    Table, RefusedOverride,
    testing::Values(
        BadOverride{"seed", "expected key=value"}, BadOverride{"=5", "expected key=value"},
        BadOverride{"seed=", "has no value; expected key=value"},
        BadOverride{"gait..sway_m=1", "the key \"gait..sway_m\" has an empty part"},
        BadOverride{".seed=1", "has an empty part"}, BadOverride{"seed=1 2", "\"1 2\" is not a TOML value: "},
        BadOverride{"seed=@", "is not a TOML value: "},
        BadOverride{"payload.mass_kg=5", "payload is an array; expected a place in it, as in payload.0.mass_kg"},
        BadOverride{"payload.x.mass_kg=5", "payload is an array; expected a place in it, as in payload.0.x"},
        BadOverride{"payload.-1.mass_kg=5", "expected a place in it"},
        BadOverride{"payload.99999999999999999999.mass_kg=5", "expected a place in it"},
        BadOverride{"payload.2.mass_kg=5",
                    "payload[2] does not exist, there are 1\n  remedy: the next one is payload.1"},
        BadOverride{"payload.0.mass_kg.x=5", "payload[0].mass_kg is a table; expected a number"},
        BadOverride{"payload.0.mass_kg=-5", "payload[0].mass_kg is -5; expected 0 to 60 kg"},
        BadOverride{"payload=5", "payload is the integer 5; expected an array of tables"},
        BadOverride{"payload=[{mass_kg=99}]", "payload[0].mass_kg is 99; expected 0 to 60 kg"},
        BadOverride{"gait=3", "gait is the integer 3; expected a table"},
        BadOverride{"gait.half_stpe_m=0.1", "gait.half_stpe_m is unknown; did you mean gait.half_step_m?"},
        BadOverride{"reflex.method=origin", "expected one of \"off\", \"original\", \"modified\""},
        BadOverride{"servo.kp_nm_per_rad.2=5", "servo.kp_nm_per_rad is a table; expected an array of 6 numbers"},
        BadOverride{"physics.step_s=0.0003", "expected control_period_s = 0.001 s divided by a whole number"},
        BadOverride{"detector.margin_n=nan", "detector.margin_n is nan; expected 0 to 1000 N"},
        BadOverride{"floor.friction=-inf", "floor.friction is -inf; expected 0 to 2"}));

// What goes to a terminal is shown, not obeyed.
TEST(ScenarioOverride, ControlCharactersOfARefusedOverrideAreEscaped) {
  EXPECT_THAT(
      refusal_of("seed = 1", {"seed=1\nduration_s = 2"}),
      testing::StartsWith("--set seed=1\\x0Aduration_s = 2: \"1\\x0Aduration_s = 2\" is more than one TOML value"));
}

TEST(ScenarioOverride, AllRefusedOverridesAreReported) {
  const std::string message = refusal_of("seed = 1", {"seed", "x=", "duration_s=5"});
  EXPECT_THAT(message, HasSubstr("--set seed: "));
  EXPECT_THAT(message, HasSubstr("--set x=: "));
  EXPECT_THAT(message, testing::Not(HasSubstr("duration_s")));
}

TEST(ScenarioOverride, CannotOverflowTheParsersStack) {
  std::string deep = "a";
  for (int i = 0; i < 100000; ++i) deep += ".a";
  EXPECT_THAT(refusal_of("seed = 1", {deep + "=1"}), HasSubstr("is longer than 4096 characters"));
}

TEST(ScenarioOverride, BadValueInTheFileIsRepairedByAnOverride) {
  EXPECT_EQ(refusal_of("[[payload]]\nmass_kg = -5", {"payload.0.mass_kg=5"}), "");
}

}  // namespace
}  // namespace surefoot::scenario
