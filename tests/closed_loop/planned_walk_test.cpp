#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/closed_loop/run_scenario.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::run {
namespace {

/// A gait of this pattern, planned for either robot: steps of 12 cm in a second.
std::string scenario_text(const std::string& robot, const std::string& pattern, const std::string& steps) {
  const std::string plant = robot == "elkahlout" ? "plant = \"nominal\"\n" : "";
  const std::string feet = pattern == "flat_feet" ? "" : "toe_angle_deg = 6.0\nheel_angle_deg = 6.0\n";
  return "robot = \"" + robot + "\"\n" + plant +
         "duration_s = 24.0\n[gait]\nbody_height_m = " + (robot == "khr2" ? "0.64" : "0.55") +
         "\n[pattern]\nstanding_s = 3.0\n[[planned_gait]]\nsteps = " + steps + "\npattern = \"" + pattern +
         "\"\nstep_length_m = 0.12\nsingle_support_share = 0.664571\n" +
         "single_support_s = 0.8\ndouble_support_s = 0.2\n" + feet;
}

scenario::Scenario scenario_of(const std::string& robot, const std::string& pattern,
                               const std::vector<std::string>& overrides = {}) {
  return scenario::load_text("planned", scenario_text(robot, pattern, "20"), overrides);
}

struct Case {
  const char* robot;
  const char* pattern;
};

class PlannedWalk : public ::testing::TestWithParam<Case> {};

INSTANTIATE_TEST_SUITE_P(OfBothRobots, PlannedWalk,
                         ::testing::Values(Case{"khr2", "flat_feet"}, Case{"khr2", "rolled_in_turn"},
                                           Case{"elkahlout", "flat_feet"}, Case{"elkahlout", "rolled_in_turn"}));

// Twenty steps, one that closes the feet, and then it stands.
TEST_P(PlannedWalk, TakesItsStepsAndStands) {
  const Verdict verdict = run_lockstep(scenario_of(GetParam().robot, GetParam().pattern), {});
  EXPECT_EQ(verdict.outcome, Outcome::kWalked) << verdict.reason;
  EXPECT_NEAR(verdict.distance_m, 20 * 0.12, 0.35) << "soles slip a little";
  EXPECT_LE(verdict.torso_roll_deg.largest_magnitude(), 2.0);
  EXPECT_LE(verdict.torso_pitch_deg.largest_magnitude(), 2.0);
}

TEST(PlannedWalkChanges, ItsSpeedAndStops) {
  std::string text = scenario_text("khr2", "flat_feet", "4");
  text +=
      "[[planned_gait]]\nsteps = 4\nstep_length_m = 0.2\nsingle_support_share = 0.664571\nsingle_support_s = 0.8\n"
      "double_support_s = 0.2\n[[planned_gait]]\nsteps = 4\n";
  const Verdict verdict = run_lockstep(scenario::load_text("planned", text, {}), {});
  EXPECT_EQ(verdict.outcome, Outcome::kWalked) << verdict.reason;
  EXPECT_NEAR(verdict.distance_m, 4 * 0.12 + 4 * 0.2 + 4 * 0.15, 0.3);
  EXPECT_LE(verdict.torso_pitch_deg.largest_magnitude(), 3.0);
}

}  // namespace
}  // namespace surefoot::run
