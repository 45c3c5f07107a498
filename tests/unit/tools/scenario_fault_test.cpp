#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/tools/scenario_testing.hpp"

namespace surefoot::scenario {
namespace {

using sim_hw::FaultElement;
using sim_hw::FaultKind;
using sim_hw::FaultSignal;
using sim_hw::FaultTarget;
using testing::HasSubstr;

sim_hw::FaultConfig only_fault(const std::string& text, const std::vector<std::string>& overrides = {}) {
  const Scenario scenario = load_text("walk.toml", text, overrides);
  EXPECT_EQ(scenario.sim.faults.size(), 1U);
  return scenario.sim.faults.at(0);
}

TEST(ScenarioFault, ScenarioWithoutFaultsHasNone) { EXPECT_TRUE(load_default().sim.faults.empty()); }

TEST(ScenarioFault, EveryKeyArrives) {
  const sim_hw::FaultConfig fault = only_fault(
      "[[fault]]\nkind = \"noise\"\ntarget = \"leg_left\"\nsignal = \"rate\"\nelement = \"knee_pitch\"\n"
      "at_s = -2.5\nfor_s = 0.25\nvalue = 0.05\n");
  EXPECT_EQ(fault.kind, FaultKind::kNoise);
  EXPECT_EQ(fault.target, FaultTarget::kLegLeft);
  EXPECT_EQ(fault.signal, FaultSignal::kRate);
  EXPECT_EQ(fault.element, FaultElement::kKneePitch);
  EXPECT_EQ(fault.at_s, -2.5);
  EXPECT_EQ(fault.for_s, 0.25);
  EXPECT_EQ(fault.value, 0.05);
  EXPECT_EQ(only_fault("[[fault]]\nprobability = 0.01").probability, 0.01);
}

// Names in the order of the enumerators: the last of each would be off by one.
TEST(ScenarioFault, NamesMeanTheirEnumerators) {
  EXPECT_EQ(only_fault("[[fault]]\nkind = \"link_down\"").kind, FaultKind::kLinkDown);
  EXPECT_EQ(only_fault("[[fault]]\nkind = \"bus_off\"\ntarget = \"torso\"").target, FaultTarget::kTorso);
  EXPECT_EQ(only_fault("[[fault]]\nkind = \"dead_node\"\ntarget = \"foot_left\"").kind, FaultKind::kDeadNode);
  EXPECT_EQ(only_fault("[[fault]]\ntarget = \"controller\"").target, FaultTarget::kController);
  const sim_hw::FaultConfig stuck =
      only_fault("[[fault]]\nkind = \"stuck\"\ntarget = \"torso\"\nsignal = \"accelerometer\"\nelement = \"z\"");
  EXPECT_EQ(stuck.kind, FaultKind::kStuck);
  EXPECT_EQ(stuck.signal, FaultSignal::kAccelerometer);
  EXPECT_EQ(stuck.element, FaultElement::kZ);
}

TEST(ScenarioFault, FaultsKeepTheOrderOfTheFile) {
  const Scenario scenario = load_text("w", "[[fault]]\nat_s = 9\n[[fault]]\nat_s = 3\n");
  ASSERT_EQ(scenario.sim.faults.size(), 2U);
  EXPECT_EQ(scenario.sim.faults[0].at_s, 9.0);
}

TEST(ScenarioFault, IsSetChangedAndRemovedFromTheCommandLine) {
  EXPECT_EQ(load_default(std::vector<std::string>{"fault.0.kind=corrupt"}).sim.faults.at(0).kind, FaultKind::kCorrupt);
  EXPECT_EQ(only_fault("[[fault]]\nat_s = 9", {"fault.0.at_s=4"}).at_s, 4.0);
  const std::vector<std::string> none{"fault=[]"};
  EXPECT_TRUE(load_text("w", "[[fault]]\nat_s = 9", none).sim.faults.empty());
}

TEST(ScenarioFault, TooManyAreRefused) {
  std::string text;
  for (std::size_t i = 0; i < sim_hw::kMaxFaults; ++i) text += "[[fault]]\n";
  EXPECT_EQ(load_text("w", text).sim.faults.size(), sim_hw::kMaxFaults);
  EXPECT_THAT(refusal_of(text + "[[fault]]\n"), HasSubstr("fault has 17 tables; expected at most 16"));
}

struct BadFault {
  const char* text;
  const char* message;  ///< begins with the place
};

void PrintTo(const BadFault& bad, std::ostream* stream) { *stream << on_one_line(bad.text); }

class RefusedFault : public testing::TestWithParam<BadFault> {};

TEST_P(RefusedFault, NamesFileLineColumnKeyExpectationAndRemedy) {
  const std::string message = refusal_of(GetParam().text);
  EXPECT_THAT(message, testing::StartsWith(GetParam().message));
  EXPECT_THAT(message, HasSubstr("\n  remedy: "));
}

INSTANTIATE_TEST_SUITE_P(
    Table, RefusedFault,
    testing::Values(
        BadFault{"[[fault]]\nkind = \"drip\"", "walk.toml:2:8: fault[0].kind is \"drip\"; expected one of \"drop\""},
        BadFault{"[[fault]]\nkidn = \"drop\"", "walk.toml:2:1: fault[0].kidn is unknown; did you mean fault[0].kind?"},
        BadFault{"[[faults]]\nkind = \"drop\"", "walk.toml:1:3: faults is unknown; did you mean fault?"},
        BadFault{"fault = 5", "walk.toml:1:9: fault is the integer 5; expected an array of tables"},
        BadFault{"[[fault]]\nprobability = 2", "walk.toml:2:15: fault[0].probability is 2; expected 0 to 1"},
        BadFault{"[[fault]]\nfor_s = 0", "walk.toml:2:9: fault[0].for_s is 0; expected more than 0, up to 3600 s"},
        BadFault{"[[fault]]\n[[fault]]\nkind = \"drift\"\ntarget = \"bus\"",
                 "walk.toml:4:10: fault[1].target has no sensors; expected a leg, a foot or the torso"},
        BadFault{"[[fault]]\nkind = \"drift\"", "walk.toml:2:8: fault[0].target has no sensors"},
        BadFault{"[[fault]]\nkind = \"babble\"\ntarget = \"leg_left\"\nsignal = \"angle\"",
                 "walk.toml:4:10: fault[0].signal picks a measurement"},
        BadFault{"[[fault]]\nkind = \"delay\"\nvalue = 0.5",
                 "walk.toml:3:9: fault[0].value is 0.5; expected a whole number, 1 to 100 ticks"}));

}  // namespace
}  // namespace surefoot::scenario
