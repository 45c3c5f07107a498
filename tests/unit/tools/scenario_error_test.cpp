#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/tools/scenario_testing.hpp"

namespace surefoot::scenario {
namespace {

using testing::HasSubstr;

struct BadInput {
  const char* text;
  const char* message;  ///< begins with the place
};

void PrintTo(const BadInput& bad, std::ostream* stream) { *stream << on_one_line(bad.text); }

class RefusedScenario : public testing::TestWithParam<BadInput> {};

TEST_P(RefusedScenario, NamesFileLineColumnKeyExpectationAndRemedy) {
  const std::string message = refusal_of(GetParam().text);
  EXPECT_THAT(message, testing::StartsWith(GetParam().message));
  EXPECT_THAT(message, HasSubstr("\n  remedy: "));
}

INSTANTIATE_TEST_SUITE_P(
    NotToml, RefusedScenario,
    testing::Values(
        BadInput{"", "walk.toml: is empty; expected a scenario\n  remedy: start from tools/scenarios/main.toml"},
        BadInput{" \n# only a comment\n", "walk.toml: is empty"},
        BadInput{"seed = \"\xff\"", "walk.toml:1:8: is not TOML: Encountered invalid utf-8 sequence"},
        BadInput{"\xff\xfes\0e\0", "walk.toml:1:1: is not TOML: "},
        BadInput{"[gait]\nhalf_step_m = ", "walk.toml:2:15: is not TOML: "},
        BadInput{"[gait\n", "walk.toml:1:6: is not TOML: "},
        BadInput{"seed = 1\nseed = 2", "walk.toml:2:8: is not TOML: "}, BadInput{"seed = 0x", "walk.toml:1:"},
        BadInput{"{\"seed\": 1}", "walk.toml:1:1: is not TOML: "}));

INSTANTIATE_TEST_SUITE_P(
    WrongType, RefusedScenario,
    testing::Values(
        BadInput{
            "[gait]\nhalf_step_m = \"long\"",
            "walk.toml:2:15: gait.half_step_m is the string \"long\"; expected a number, more than 0, up to 0.5 m\n"
            "  remedy: give the half travel of a foot about the reference, b_s, or remove the key to use 0.08"},
        BadInput{"seed = 1.5", "walk.toml:1:8: seed is the float 1.5; expected an integer, 0 to "},
        BadInput{"seed = -1", "walk.toml:1:8: seed is -1; expected 0 to "},
        BadInput{"seed = 9223372036854775807", "walk.toml:1:8: seed is 9223372036854775807; expected 0 to "},
        BadInput{"[reflex]\nmirrored = 1", "walk.toml:2:12: reflex.mirrored is the integer 1; expected true or false"},
        BadInput{"[reflex]\nmethod = false", "walk.toml:2:10: reflex.method is the boolean false; expected one of"},
        BadInput{"duration_s = 2003-01-01",
                 "walk.toml:1:14: duration_s is the date or time 2003-01-01; expected a number"},
        BadInput{"duration_s = [20]", "walk.toml:1:14: duration_s is an array of 1; expected a number"},
        BadInput{"duration_s = {}", "walk.toml:1:14: duration_s is a table; expected a number"},
        BadInput{"gait = 5", "walk.toml:1:8: gait is the integer 5; expected a table\n  remedy: write [gait] on"},
        BadInput{"payload = 5", "walk.toml:1:11: payload is the integer 5; expected an array of tables"},
        BadInput{"[payload]\nmass_kg = 5",
                 "walk.toml:1:1: payload is a table; expected an array of tables\n"
                 "  remedy: write [[payload]]"},
        BadInput{"payload = [5]", "walk.toml:1:12: payload[0] is the integer 5; expected a table"},
        BadInput{"[servo]\nkp_nm_per_rad = 5",
                 "walk.toml:2:17: servo.kp_nm_per_rad is the integer 5; expected an array of 6"},
        BadInput{"[servo]\nkp_nm_per_rad = [1, 2]",
                 "walk.toml:2:17: servo.kp_nm_per_rad is an array of 2; expected an array of 6"},
        BadInput{"[servo]\nkp_nm_per_rad = [1, 2, 3, 4, 5, true]",
                 "walk.toml:2:33: servo.kp_nm_per_rad[5] is the boolean true; expected a number, 0 to 1000000 N m/rad"},
        BadInput{"[gate]\nride_through_ticks = 4294967296",
                 "walk.toml:2:22: gate.ride_through_ticks is 4294967296; expected 0 to 1000 ticks"}));

INSTANTIATE_TEST_SUITE_P(
    Impossible, RefusedScenario,
    testing::Values(
        BadInput{"[[payload]]\nmass_kg = -5",
                 "walk.toml:2:11: payload[0].mass_kg is -5; expected 0 to 60 kg\n"
                 "  remedy: give the mass of the load, or remove the key to use 5.0"},
        BadInput{"[[payload]]\n[[payload]]\nat_s = -0.1",
                 "walk.toml:3:8: payload[1].at_s is -0.1; expected 0 to 3600 s"},
        BadInput{"[[payload]]\nposition_m = [0, 0, 9]",
                 "walk.toml:2:21: payload[0].position_m[2] is 9; expected -1 to 1 m"},
        BadInput{"[mass]\ntrunk_kg = -50.0", "walk.toml:2:12: mass.trunk_kg is -50.0; expected 0.1 to 500 kg"},
        BadInput{"[gait]\nsway_m = nan", "walk.toml:2:10: gait.sway_m is nan; expected 0 to 0.5 m"},
        BadInput{"[gait]\nsway_m = -nan", "walk.toml:2:10: gait.sway_m is "},
        BadInput{"[gait]\nsway_m = inf", "walk.toml:2:10: gait.sway_m is inf; expected 0 to 0.5 m"},
        BadInput{"[gait]\nsingle_support_s = 0", "walk.toml:2:20: gait.single_support_s is 0; expected 0.05 to 10 s"},
        BadInput{"duration_s = 0", "walk.toml:1:14: duration_s is 0; expected more than 0, up to 3600 s"},
        BadInput{"duration_s = 1e300", "walk.toml:1:14: duration_s is 1e+300; expected more than 0, up to 3600 s"},
        BadInput{"duration_s = -20", "walk.toml:1:14: duration_s is -20; expected"},
        BadInput{"robot = \"asimo\"",
                 "walk.toml:1:9: robot is \"asimo\"; expected one of \"elkahlout\", \"khr2\"\n"
                 "  remedy: choose a name that exists, or remove the key to use \"elkahlout\""},
        BadInput{"plant = \"mars\"", "walk.toml:1:9: plant is \"mars\"; expected one of \"thesis\", \"nominal\""},
        BadInput{"[gate]\ntorque_limit_nm = 301",
                 "walk.toml:2:19: gate.torque_limit_nm is 301; expected more than 0, up to 300 N m"},
        BadInput{
            "[physics]\nstep_s = 0.0003",
            "walk.toml:2:10: physics.step_s is 0.0003; expected control_period_s = 0.001 s divided by a whole number\n"
            "  remedy: take half the control period, or a quarter"},
        BadInput{"[physics]\nstep_s = 0.002", "walk.toml:2:10: physics.step_s is 0.002; expected control_period_s"},
        BadInput{"control_period_s = 0.0007",
                 "walk.toml:1:20: physics.step_s is 0.0005; expected control_period_s = 0.0007 s"},
        BadInput{
            "[gait]\nbody_height_m = 0.6",
            "walk.toml:2:17: the walk needs a leg of 0.5367 m; expected less than thigh and calf together, 0.49 m\n"
            "  remedy: lower gait.body_height_m"},
        BadInput{
            "[geometry]\ncalf_m = 0.17",
            "walk.toml:2:10: the walk needs a leg of 0.4451 m; expected less than thigh and calf together, 0.44 m"},
        BadInput{
            "[gait]\nbody_height_m = 0.15",
            "walk.toml:2:17: the swing foot comes within 0.02 m of the hip; expected more than the folded leg, 0.05 m"},
        BadInput{"[gait]\nfoot_offset_y_m = 0.06",
                 "walk.toml:2:19: the soles overlap: they are 0.138 m wide and 0.12 m apart"},
        BadInput{"[gate]\nangle_min_rad = [0, 0, 0, 2.6, 0, 0]",
                 "walk.toml:2:17: gate.angle_max_rad[3] is 2.6; expected more than gate.angle_min_rad[3] = 2.6 rad"},
        BadInput{"[detector]\nlearning_s = 4.7",
                 "walk.toml:2:14: detector.learning_s is 4.7; expected at least one gait cycle, 4.8 s"},
        BadInput{"[gait]\nsingle_support_s = 2",
                 "walk.toml:2:20: detector.learning_s is 4.8; expected at least one gait cycle, 6 s"},
        BadInput{"robot = \"khr2\"\n[payload_shift]\nmeasuring_s = 1.8",
                 "walk.toml:3:15: payload_shift.measuring_s is 1.8; expected at least one gait cycle, 1.9 s"},
        BadInput{"[bus]\nwatchdog_s = 0.001",
                 "walk.toml:2:14: bus.watchdog_s is 0.001; expected more than one control period, 0.001 s"},
        BadInput{
            "[bus]\ncommand_latency_s = 0.012",
            "walk.toml:2:21: gate.ride_through_ticks is 10; expected at least 13, the command latency and one tick"},
        BadInput{"[reflex]\nfoot_offset_m = 0.09",
                 "walk.toml:2:17: reflex.foot_offset_m is 0.09; expected at most gait.half_step_m = 0.08 m"},
        BadInput{"[gate]\nride_through_ticks = 200\n[bus]\nwatchdog_s = 1\ncommand_latency_s = 0.1",
                 "walk.toml:5:21: bus.command_latency_s is 0.1; expected less than 0.063 s, 63 control periods"}));

INSTANTIATE_TEST_SUITE_P(
    Unknown, RefusedScenario,
    testing::Values(
        BadInput{"duraton_s = 20",
                 "walk.toml:1:1: duraton_s is unknown; did you mean duration_s?\n  remedy: correct or remove it; "
                 "surefoot keys"},
        BadInput{"[gait]\n  half_stpe_m = 0.1",
                 "walk.toml:2:3: gait.half_stpe_m is unknown; did you mean gait.half_step_m?"},
        BadInput{"half_step_m = 0.1", "walk.toml:1:1: half_step_m is unknown; did you mean gait.half_step_m?"},
        BadInput{"[gaits]\nhalf_step_m = 0.1", "walk.toml:1:2: gaits is unknown; did you mean gait?"},
        BadInput{"[[payload]]\nmas_kg = 5",
                 "walk.toml:2:1: payload[0].mas_kg is unknown; did you mean payload[0].mass_kg?"},
        BadInput{"[[payloads]]\nmass_kg = 5", "walk.toml:1:3: payloads is unknown; did you mean payload?"},
        BadInput{"[servo]\nkp = 5", "walk.toml:2:1: servo.kp is unknown; did you mean servo.kp_nm_per_rad?"},
        BadInput{"[gait.inner]\nx = 5", "walk.toml:1:7: gait.inner is unknown\n"},
        BadInput{"chocolate = true", "walk.toml:1:1: chocolate is unknown\n"}));

TEST(ScenarioError, ReportsEveryProblemOfAFileInTheOrderOfItsLines) {
  const std::string message = refusal_of(
      "speed = 3\nduration_s = -1\n[reflex]\nmethod = \"magic\"\n[gait]\nsway_m = nan\nbody_height_m = 0.6\n"
      "[[payload]]\nmass_kg = 61\n[detector]\nlearning_s = 1\n");
  std::vector<std::size_t> at;
  for (const char* part :
       {"toml:1:1: speed", "toml:2:14: duration_s", "toml:4:10: reflex.method", "toml:6:10: gait.sway_m",
        "toml:9:11: payload[0].mass_kg", "toml:11:14: detector.learning_s"}) {
    at.push_back(message.find(part));
    EXPECT_NE(at.back(), std::string::npos) << part << " not in\n" << message;
  }
  EXPECT_TRUE(std::is_sorted(at.begin(), at.end())) << message;
  EXPECT_THAT(message, testing::Not(HasSubstr("needs a leg"))) << "sway is wrong already: no follow-up errors";
}

TEST(ScenarioError, ProblemsAreAlsoAtHandOneByOne) {
  try {
    (void)load_text("walk.toml", "[[payload]]\nmass_kg = -5");
    FAIL() << "accepted";
  } catch (const ScenarioError& error) {
    ASSERT_EQ(error.problems().size(), 1U);
    EXPECT_EQ(error.problems()[0].place, "walk.toml:2:11");
    EXPECT_EQ(error.problems()[0].statement, "payload[0].mass_kg is -5; expected 0 to 60 kg");
    EXPECT_EQ(error.problems()[0].remedy, "give the mass of the load, or remove the key to use 5.0");
  }
}

std::string refusal_of_file(const std::filesystem::path& file) {
  try {
    (void)load(file);
  } catch (const ScenarioError& error) {
    return error.what();
  }
  return {};
}

TEST(ScenarioError, FileThatIsNotThereIsNamed) {
  EXPECT_EQ(refusal_of_file("/nowhere/walk.toml"),
            "/nowhere/walk.toml: there is no such file\n"
            "  remedy: check the path; scenarios to start from are in tools/scenarios");
}

TEST(ScenarioError, DirectoryIsNotAScenario) {
  EXPECT_THAT(refusal_of_file(testing::TempDir()), HasSubstr("is a directory; expected a scenario file"));
}

// Opens for everybody and fails at the first byte, root or not: nothing is mapped at address 0.
TEST(ScenarioError, UnreadableFileSaysWhy) {
  EXPECT_THAT(refusal_of_file("/proc/self/mem"), HasSubstr("cannot be read: Input/output error"));
}

TEST(ScenarioError, EndlessFileIsRefused) {
  EXPECT_THAT(refusal_of_file("/dev/zero"), HasSubstr("is larger than 128 KiB; expected a scenario file"));
}

TEST(ScenarioError, FileOnDiskIsNamedAsItWasGiven) {
  const std::filesystem::path file = write_file("seed = -1");
  EXPECT_THAT(refusal_of_file(file), testing::StartsWith(file.string() + ":1:8: seed is -1"));
}

TEST(ScenarioError, DeepNestingIsRefusedNotFollowed) {
  EXPECT_THAT(refusal_of("seed = " + std::string(60000, '[')), HasSubstr("walk.toml:1:"));
  std::string deep = "a";
  while (deep.size() < 2000) deep += ".a";
  EXPECT_THAT(refusal_of(deep + " = 1"), HasSubstr("walk.toml:1:1: a is unknown"));
  while (deep.size() < 120000) deep += ".a";
  EXPECT_THAT(refusal_of("seed = 1\n" + deep + " = 1"), HasSubstr("walk.toml:2: has more than 1000 dots on a line"));
}

}  // namespace
}  // namespace surefoot::scenario
