#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "sim_hw/faults/fault_check.hpp"
#include "tests/unit/tools/scenario_testing.hpp"
#include "tools/scenario/checks.hpp"
#include "tools/scenario/field_table.hpp"
#include "tools/scenario/preset.hpp"

namespace surefoot::scenario {
namespace {

/// Half of the time anywhere in the range, half of the time near `present`.
double number_in(const Range& range, double present) {
  const double share = static_cast<double>(*rc::gen::arbitrary<std::uint32_t>()) / 4294967295.0;
  const bool is_near = *rc::gen::arbitrary<bool>();
  const double value = is_near ? present * (0.9 + 0.2 * share) : range.min + share * (range.max - range.min);
  return range.is_open_below && value <= range.min ? range.max : std::clamp(value, range.min, range.max);
}

template <typename Integer>
Integer integer_in(const Range& range, Integer present) {
  return static_cast<Integer>(std::round(number_in(range, static_cast<double>(present))));
}

void set_at_random(const Field& field) {
  if (auto* const* number = std::get_if<double*>(&field.target)) {
    const bool stays_never = field.range.may_be_never && *rc::gen::arbitrary<bool>();
    if (!stays_never) **number = number_in(field.range, **number);
  }
  if (auto* const* flag = std::get_if<bool*>(&field.target)) **flag = *rc::gen::arbitrary<bool>();
  if (auto* const* small = std::get_if<std::uint32_t*>(&field.target)) **small = integer_in(field.range, **small);
  if (auto* const* large = std::get_if<std::uint64_t*>(&field.target)) **large = integer_in(field.range, **large);
  if (const auto* choice = std::get_if<Choice>(&field.target)) {
    choice->set(*rc::gen::inRange<std::size_t>(0, choice->names.size()));
  }
  if (const auto* numbers = std::get_if<Numbers>(&field.target)) {
    for (double* number : *numbers) *number = number_in(field.range, *number);
  }
}

/// Every key at random, where that leaves the scenario possible. Each is drawn from its range, so that only its
/// relations to others can be broken.
Scenario random_scenario(const std::string& robot) {
  Scenario scenario = preset({.robot = robot, .plant = "nominal"});
  for (const Field& field : fields(scenario)) {
    if (field.key == "robot") continue;  // it decides which keys there are
    const Scenario before = scenario;
    set_at_random(field);
    share_numbers(scenario);
    if (!check_relations(scenario).empty()) scenario = before;
  }
  scenario.sim.payloads.resize(*rc::gen::inRange<std::size_t>(0, kMaxPayloads + 1));
  for (sim_hw::PayloadConfig& payload : scenario.sim.payloads) {
    for (const Field& field : fields(payload)) set_at_random(field);
    if (payload.removed_at_s <= payload.at_s) payload.removed_at_s = sim_hw::kNever_s;
  }
  std::stable_sort(scenario.sim.payloads.begin(), scenario.sim.payloads.end(),
                   [](const auto& a, const auto& b) { return a.at_s < b.at_s; });
  scenario.sim.pushes.resize(*rc::gen::inRange<std::size_t>(0, sim_hw::kMaxPushes + 1));
  for (sim_hw::PushConfig& push : scenario.sim.pushes) {
    for (const Field& field : fields(push)) set_at_random(field);
  }
  scenario.sim.terrain.patches.resize(*rc::gen::inRange<std::size_t>(0, 9));
  for (sim_hw::PatchConfig& patch : scenario.sim.terrain.patches) {
    for (const Field& field : fields(patch)) set_at_random(field);
  }
  const std::size_t faults = *rc::gen::inRange<std::size_t>(0, sim_hw::kMaxFaults + 1);
  while (scenario.sim.faults.size() < faults) {
    sim_hw::FaultConfig fault;
    for (const Field& field : fields(fault)) {
      const sim_hw::FaultConfig before = fault;
      set_at_random(field);
      if (sim_hw::find_problem(fault)) fault = before;
    }
    scenario.sim.faults.push_back(fault);
  }
  return scenario;
}

/// The key of every element of `bits`.
std::vector<std::string> keys(const std::vector<Field>& table) {
  std::vector<std::string> all;
  for (const Field& field : table) {
    const auto* numbers = std::get_if<Numbers>(&field.target);
    all.insert(all.end(), numbers != nullptr ? numbers->size() : 1, field.key);
  }
  return all;
}

/// The bits of every value, text for names; an array's elements one by one.
std::vector<std::string> bits(const std::vector<Field>& table) {
  std::vector<std::string> all;
  const auto add = [&](double number) { all.push_back(std::to_string(std::bit_cast<std::uint64_t>(number))); };
  for (const Field& field : table) {
    if (const auto* number = std::get_if<double*>(&field.target)) {
      add(**number);
    } else if (const auto* numbers = std::get_if<Numbers>(&field.target)) {
      for (const double* element : *numbers) add(*element);
    } else {
      all.push_back(value_text(field));
    }
  }
  return all;
}

TEST(ScenarioRoundTrip, EffectiveScenarioReadsBackToTheSameBits) {
  EXPECT_TRUE(rc::check([] {
    Scenario written = random_scenario(*rc::gen::element<std::string>("elkahlout", "khr2"));
    const std::string text = to_toml(written);
    Scenario read = load_text("effective.toml", text);
    RC_ASSERT(bits(fields(read)) == bits(fields(written)));
    RC_ASSERT(read.sim.payloads.size() == written.sim.payloads.size());
    for (std::size_t i = 0; i < read.sim.payloads.size(); ++i) {
      RC_ASSERT(bits(fields(read.sim.payloads[i])) == bits(fields(written.sim.payloads[i])));
    }
    RC_ASSERT(read.sim.pushes.size() == written.sim.pushes.size());
    for (std::size_t i = 0; i < read.sim.pushes.size(); ++i) {
      RC_ASSERT(bits(fields(read.sim.pushes[i])) == bits(fields(written.sim.pushes[i])));
    }
    RC_ASSERT(read.sim.terrain.patches.size() == written.sim.terrain.patches.size());
    for (std::size_t i = 0; i < read.sim.terrain.patches.size(); ++i) {
      RC_ASSERT(bits(fields(read.sim.terrain.patches[i])) == bits(fields(written.sim.terrain.patches[i])));
    }
    RC_ASSERT(read.sim.faults.size() == written.sim.faults.size());
    for (std::size_t i = 0; i < read.sim.faults.size(); ++i) {
      RC_ASSERT(bits(fields(read.sim.faults[i])) == bits(fields(written.sim.faults[i])));
    }
    RC_ASSERT(to_toml(read) == text);
  }));
}

TEST(ScenarioRoundTrip, RandomScenariosMoveMostKeysAwayFromTheirDefaults) {
  Scenario defaults = preset({.robot = "khr2"});
  const std::vector<std::string> unchanged = bits(fields(defaults));
  std::vector<bool> has_moved(unchanged.size());
  rc::check([&] {
    Scenario scenario = random_scenario("khr2");
    const std::vector<std::string> values = bits(fields(scenario));
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (values[i] != unchanged[i]) has_moved[i] = true;
    }
  });
  // All but the robot, and the few whose range leaves them little room: bit rates of which a bit must last a whole
  // number of nanoseconds, and lengths that reach or bus must allow.
  std::string unmoved;
  const std::vector<std::string> key = keys(fields(defaults));
  ASSERT_EQ(key.size(), has_moved.size());
  for (std::size_t i = 0; i < key.size(); ++i) {
    if (!has_moved[i]) unmoved += key[i] + " ";
  }
  EXPECT_LE(std::count(has_moved.begin(), has_moved.end(), false), 9) << unmoved;
}

TEST(ScenarioRoundTrip, ScenarioOfAnySeedHasThatSeed) {
  EXPECT_TRUE(rc::check([](std::uint32_t seed) {
    const std::vector<std::string> overrides{"seed=" + std::to_string(seed)};
    RC_ASSERT(load_default(overrides).sim.seed == seed);
  }));
}

TEST(ScenarioHostileText, IsReadOrRefusedWithAPlaceAndARemedyAndNothingElse) {
  std::ifstream stream(scenario_folder() / "second_payload.toml", std::ios::binary);
  const std::string shipped{std::istreambuf_iterator<char>(stream), {}};
  ASSERT_FALSE(shipped.empty());
  EXPECT_TRUE(rc::check([&] {
    std::string text = shipped;
    const int changes = *rc::gen::inRange(1, 6);
    for (int i = 0; i < changes && !text.empty(); ++i) {
      const std::size_t at = *rc::gen::inRange<std::size_t>(0, text.size());
      const std::size_t length = *rc::gen::inRange<std::size_t>(0, 8);
      text.replace(at, length, *rc::gen::arbitrary<std::string>());
    }
    try {
      const Scenario scenario = load_text("hostile.toml", text);
      validate(scenario);
    } catch (const ScenarioError& error) {
      const std::string message = error.what();
      RC_ASSERT(message.starts_with("hostile.toml"));
      RC_ASSERT(message.find("\n  remedy: ") != std::string::npos);
    }
  }));
}

TEST(ScenarioHostileText, OverridesAreAppliedOrRefusedUnderTheirOwnName) {
  EXPECT_TRUE(rc::check([](const std::string& key, const std::string& value) {
    const std::vector<std::string> overrides{key + "=" + value};
    try {
      validate(load_default(overrides));
    } catch (const ScenarioError& error) {
      RC_ASSERT(std::string(error.what()).starts_with("--set "));
    }
  }));
}

}  // namespace
}  // namespace surefoot::scenario
