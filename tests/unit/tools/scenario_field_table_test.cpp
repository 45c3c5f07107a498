#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <set>
#include <vector>

#include "tests/unit/tools/scenario_testing.hpp"
#include "tools/scenario/field_table.hpp"
#include "tools/scenario/preset.hpp"

namespace surefoot::scenario {
namespace {

/// A scenario, a load, a push, a patch and a fault, with every key of theirs.
struct Everything {
  [[nodiscard]] std::vector<Field> all_fields() {
    std::vector<Field> all = fields(scenario);
    for (const Field& field : fields(payload)) all.push_back(field);
    for (const Field& field : fields(push)) all.push_back(field);
    for (const Field& field : fields(patch)) all.push_back(field);
    for (const Field& field : fields(fault)) all.push_back(field);
    return all;
  }

  Scenario scenario = preset({.robot = "khr2"});  // it has every other robot's keys too
  sim_hw::PayloadConfig payload;
  sim_hw::PushConfig push;
  sim_hw::PatchConfig patch;
  sim_hw::FaultConfig fault;
};

bool is_number(const Field& field) {
  return !std::holds_alternative<bool*>(field.target) && !std::holds_alternative<Choice>(field.target);
}

TEST(ScenarioFields, EveryKeyIsDocumentedAndEveryNumberHasAUnitAndARange) {
  Everything everything;
  for (const Field& field : everything.all_fields()) {
    SCOPED_TRACE(field.key);
    EXPECT_GE(field.doc.size(), 10U);
    EXPECT_EQ(is_number(field), !field.unit.empty());
    EXPECT_TRUE(!is_number(field) || field.range.min < field.range.max);
  }
}

TEST(ScenarioFields, EveryKeyStandsOnceAndTablesStandTogether) {
  Scenario scenario = preset({.robot = "khr2"});
  std::set<std::string> keys;
  std::vector<std::string> tables;
  for (const Field& field : fields(scenario)) {
    EXPECT_TRUE(keys.insert(field.key).second) << field.key;
    const std::string table = field.key.substr(0, field.key.find('.') == std::string::npos ? 0 : field.key.find('.'));
    if (tables.empty() || tables.back() != table) tables.push_back(table);
  }
  EXPECT_EQ(std::set<std::string>(tables.begin(), tables.end()).size(), tables.size());
}

TEST(ScenarioFields, NamesOfNumbersEndWithTheirUnit) {
  const std::vector<std::pair<std::string, std::string>> suffixes{{"s", "_s"},     {"m", "_m"},        {"kg", "_kg"},
                                                                  {"N", "_n"},     {"N m", "_nm"},     {"rad", "_rad"},
                                                                  {"deg", "_deg"}, {"ticks", "_ticks"}};
  Everything everything;
  for (const Field& field : everything.all_fields()) {
    for (const auto& [unit, suffix] : suffixes) {
      EXPECT_TRUE(field.unit != unit || field.key.ends_with(suffix)) << field.key << " in " << unit;
    }
  }
}

TEST(ScenarioFields, DefaultsOfBothPlantsAreInRange) {
  for (const char* plant : {"thesis", "nominal"}) {
    Scenario scenario = preset({.plant = plant});
    share_numbers(scenario);
    EXPECT_NO_THROW(validate(scenario)) << plant;
  }
}

TEST(ScenarioFields, ListOfKeysAndEffectiveScenarioShowEachKey) {
  Scenario scenario = load_default();
  const std::string list = describe_keys();
  const std::string text = to_toml(scenario);
  for (const Field& field : fields(scenario)) {
    EXPECT_THAT(list, testing::HasSubstr(fmt::format("  {} ", field.key)));
    EXPECT_THAT(list, testing::HasSubstr(field.doc));
    EXPECT_THAT(text, testing::HasSubstr(fmt::format("\n{} = ", field.key.substr(field.key.find('.') + 1))));
  }
  Scenario khr2 = preset({.robot = "khr2"});
  for (const Field& field : fields(khr2)) EXPECT_THAT(list, testing::HasSubstr(fmt::format("  {} ", field.key)));
  EXPECT_THAT(list, testing::HasSubstr("  payload.N.mass_kg "));
  EXPECT_THAT(list, testing::HasSubstr("  payload.N.removed_at_s "));
  EXPECT_THAT(list, testing::HasSubstr("  push.N.force_n "));
  EXPECT_THAT(list, testing::HasSubstr("  patch.N.size_m "));
  EXPECT_THAT(list, testing::HasSubstr("  fault.N.kind "));
}

/// Bytes of an object that some key writes, or that have a reason not to.
class Coverage {
 public:
  template <typename Object>
  explicit Coverage(const Object& object)
      : begin_(reinterpret_cast<const std::byte*>(&object)), is_covered_(sizeof(Object)) {}

  void add(const void* member, std::size_t size) {
    const std::ptrdiff_t offset = static_cast<const std::byte*>(member) - begin_;
    ASSERT_GE(offset, 0);
    ASSERT_LE(static_cast<std::size_t>(offset) + size, is_covered_.size());
    std::fill_n(is_covered_.begin() + offset, size, true);
  }

  template <typename Member>
  void add(const Member& member) {
    add(&member, sizeof(Member));
  }

  void add(const Field& field) {
    if (const auto* numbers = std::get_if<Numbers>(&field.target)) {
      for (const double* number : *numbers) add(*number);
    } else if (const auto* choice = std::get_if<Choice>(&field.target)) {
      add(choice->object, 1);
    } else if (const auto* number = std::get_if<double*>(&field.target)) {
      add(**number);
    } else if (const auto* small = std::get_if<std::uint32_t*>(&field.target)) {
      add(**small);
    } else if (const auto* large = std::get_if<std::uint64_t*>(&field.target)) {
      add(**large);
    } else {
      add(*std::get<bool*>(field.target));
    }
  }

  /// Longest run of bytes that no key writes; up to 7 are padding.
  std::size_t longest_gap() const {
    std::size_t longest = 0;
    std::size_t gap = 0;
    for (const bool covered : is_covered_) {
      gap = covered ? 0 : gap + 1;
      longest = std::max(longest, gap);
    }
    return longest;
  }

 private:
  const std::byte* begin_;
  std::vector<bool> is_covered_;
};

// Catches a member that was added to a configuration and not to the table: it could neither be set
// nor would it be saved with the run.
TEST(ScenarioFields, EveryMemberOfTheConfigurationHasAKey) {
  Scenario scenario = preset({.robot = "khr2"});  // which has every key that the other robot has
  Coverage coverage(scenario);
  for (const Field& field : fields(scenario)) coverage.add(field);
  coverage.add(scenario.robot);
  coverage.add(scenario.plant);
  coverage.add(scenario.controllers);
  coverage.add(scenario.sim.payloads);
  coverage.add(scenario.sim.pushes);
  coverage.add(scenario.sim.terrain.patches);
  coverage.add(scenario.sim.faults);
  coverage.add(scenario.sim.geometry);                    // share_numbers
  coverage.add(scenario.sim.control_period_s);            // share_numbers
  coverage.add(scenario.firmware.servo.torque_limit_nm);  // share_numbers
  coverage.add(scenario.sim.time_zero_s);                 // the runner's
  coverage.add(scenario.firmware.method);                 // follows the robot
  FloorWalkerConfig& floor = scenario.firmware.floor;
  coverage.add(scenario.gaits);
  coverage.add(floor.pattern.gaits);                             // share_numbers, from [[planned_gait]]
  coverage.add(floor.nominal);                                   // share_numbers, from recorded tables
  coverage.add(floor.stabilizer.sway_amplitude.pattern_sway_m);  // share_numbers
  coverage.add(floor.stabilizer.step_adjustment.com_height_m);   // share_numbers
  coverage.add(scenario.firmware.reflex.capture.geometry);       // the controller copies its own
  EXPECT_LT(coverage.longest_gap(), 8U);

  sim_hw::PayloadConfig payload;
  Coverage payload_coverage(payload);
  for (const Field& field : fields(payload)) payload_coverage.add(field);
  EXPECT_LT(payload_coverage.longest_gap(), 8U);

  PlannedGaitConfig gait;
  Coverage gait_coverage(gait);
  for (const Field& field : fields(gait)) gait_coverage.add(field);
  EXPECT_LT(gait_coverage.longest_gap(), 8U);

  sim_hw::PushConfig push;
  Coverage push_coverage(push);
  for (const Field& field : fields(push)) push_coverage.add(field);
  EXPECT_LT(push_coverage.longest_gap(), 8U);

  sim_hw::PatchConfig patch;
  Coverage patch_coverage(patch);
  for (const Field& field : fields(patch)) patch_coverage.add(field);
  EXPECT_LT(patch_coverage.longest_gap(), 8U);

  sim_hw::FaultConfig fault;
  Coverage fault_coverage(fault);
  for (const Field& field : fields(fault)) fault_coverage.add(field);
  EXPECT_LT(fault_coverage.longest_gap(), 8U);
}

/// First byte that a key writes.
const void* address_of(const Field& field) {
  if (const auto* choice = std::get_if<Choice>(&field.target)) return choice->object;
  if (const auto* numbers = std::get_if<Numbers>(&field.target)) return numbers->front();
  if (const auto* number = std::get_if<double*>(&field.target)) return *number;
  if (const auto* small = std::get_if<std::uint32_t*>(&field.target)) return *small;
  if (const auto* large = std::get_if<std::uint64_t*>(&field.target)) return *large;
  return std::get<bool*>(field.target);
}

// Catches two keys that write each other's member: a round trip does not see it.
TEST(ScenarioFields, KeysOfATableStandInTheOrderOfTheirMembers) {
  Scenario scenario;
  const std::vector<Field> table = fields(scenario);
  for (std::size_t i = 1; i < table.size(); ++i) {
    const std::size_t dot = table[i].key.find('.');
    const bool same_table = dot != std::string::npos && table[i - 1].key.starts_with(table[i].key.substr(0, dot + 1));
    EXPECT_TRUE(!same_table || std::less<>{}(address_of(table[i - 1]), address_of(table[i]))) << table[i].key;
  }
  sim_hw::PayloadConfig payload;
  sim_hw::PushConfig push;
  sim_hw::PatchConfig patch;
  sim_hw::FaultConfig fault;
  for (const std::vector<Field>& element : {fields(payload), fields(push), fields(patch), fields(fault)}) {
    for (std::size_t i = 1; i < element.size(); ++i) {
      EXPECT_TRUE(std::less<>{}(address_of(element[i - 1]), address_of(element[i]))) << element[i].key;
    }
  }
}

TEST(ScenarioFields, NumbersAreWrittenShortAndExactly) {
  EXPECT_EQ(toml_number(0.1), "0.1");
  EXPECT_EQ(toml_number(20.0), "20.0");
  EXPECT_EQ(toml_number(-0.0), "-0.0");
  EXPECT_EQ(toml_number(1e-5), "1e-05");
  EXPECT_EQ(toml_number(0.1 + 0.2), "0.30000000000000004");
}

}  // namespace
}  // namespace surefoot::scenario
