#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tools/map/map_spec.hpp"
#include "tools/map/survival_map.hpp"
#include "tools/scenario/scenario.hpp"
#include "tools/table/experiment.hpp"

namespace surefoot::map {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;

constexpr const char* kSpec = R"(title = "pushes"
methods = ["off", "original"]
set = ["payload=[]"]
[columns]
title = "towards"
values = [
  {label = "front", set = ["push.0.force_n=[{row}, 0.0, 0.0]"]},
  {label = "left, ahead", set = ["push.0.force_n=[{row}, {row}, 0.0]"]},
]
[rows]
title = "push, N"
values = [50.5, 100.0, 150.0]
[repeats]
title = "at, s"
key = "push.0.at_s"
values = [5.0, 6.2]
)";

std::string refusal_of(const std::string& text) {
  try {
    static_cast<void>(parse_spec("mine.toml", text));
  } catch (const BadSpec& error) {
    return error.what();
  }
  return {};
}

/// Verdicts of all runs; those at the places named do not survive.
std::vector<run::Verdict> verdicts_but(std::size_t count, const std::vector<std::size_t>& fallen) {
  std::vector<run::Verdict> verdicts(count);
  for (const std::size_t place : fallen) verdicts.at(place).outcome = run::Outcome::kFell;
  return verdicts;
}

TEST(MapSpec, RunsEveryMethodRowColumnAndRepeatWithTheRowsNumberInTheColumnsForce) {
  const MapSpec spec = parse_spec("mine.toml", kSpec);
  const batch::Batch base = table::batch_of({"off", "nominal", {}, {}});
  const batch::Batch batch = map_batch(spec, base);
  ASSERT_EQ(batch.trials.size(), 2U * 3U * 2U * 2U);
  const std::vector<std::string>& second_repeat = batch.trials[3].overrides;
  EXPECT_THAT(second_repeat, AllOf(Contains("reflex.method=off"), Contains("payload=[]"), Contains("push.0.at_s=6.2"),
                                   Contains("push.0.force_n=[50.5, 50.5, 0.0]")));
  EXPECT_THAT(batch.trials.back().overrides,
              AllOf(Contains("reflex.method=original"), Contains("push.0.force_n=[150, 150, 0.0]")));
}

// A run that ends before two cycles after its last push would be counted as not survived.
TEST(MapSpec, LetsEveryRunLastLongEnoughToBeJudged) {
  const batch::Batch base = table::batch_of({"original", "", {}, {}});
  const batch::Batch batch = map_batch(parse_spec("mine.toml", kSpec), base);
  for (const batch::Trial& trial : batch.trials) {
    std::vector<std::string> overrides = base.common;
    overrides.insert(overrides.end(), trial.overrides.begin(), trial.overrides.end());
    const scenario::Scenario scenario = scenario::load_default(overrides);
    ASSERT_EQ(scenario.sim.pushes.size(), 1U);
    EXPECT_GE(scenario.duration_s, scenario.sim.pushes[0].at_s + 2.0 * scenario.firmware.walk.cycle_s());
  }
}

TEST(MapSpec, RefusesWithFileLineAndRemedy) {
  EXPECT_THAT(refusal_of("title = \"x\"\nmethods = 3\n"), AllOf(HasSubstr("mine.toml:2"), HasSubstr("remedy:")));
  EXPECT_THAT(refusal_of("title = \"x\"\nmethods = []\n"), HasSubstr("methods names none"));
  EXPECT_THAT(refusal_of("titel = \"x\"\n"), HasSubstr("titel is no key"));
  EXPECT_THAT(refusal_of("title = \"x\"\nmethods = [\"off\"]\n"), HasSubstr("[columns] is missing"));
  EXPECT_THAT(refusal_of("title ="), HasSubstr("remedy:"));
  EXPECT_THAT(refusal_of(""), HasSubstr("title is missing"));
  const std::string begin = "title = \"x\"\nmethods = [\"off\"]\n[columns]\ntitle = \"t\"\n";
  EXPECT_THAT(refusal_of(begin + "values = []\n"), HasSubstr("at least one value"));
  EXPECT_THAT(refusal_of(begin + "values = [[1]]\n"), HasSubstr("a value is a number"));
  EXPECT_THAT(refusal_of(begin + "values = [{label = \"a\", sets = []}]\n"), HasSubstr("sets is no key"));
}

TEST(MapSpec, RefusesAFileThatIsNotThere) { EXPECT_THROW(static_cast<void>(load_spec("/nowhere/map.toml")), BadSpec); }

TEST(MapPresets, AreReadAndSetKeysThatScenariosHave) {
  for (const Preset& preset : presets()) {
    MapSpec spec = parse_spec(preset.kind, preset.text);
    spec.methods = {"off"};
    const batch::Batch base = table::batch_of({"off", "", {}, {}});
    EXPECT_NO_THROW(static_cast<void>(map_batch(spec, base))) << preset.kind;
    EXPECT_LE(map_of(spec, "", {}).runs(), 300U) << preset.kind << " takes too long for a default";
  }
}

// Rows and columns changed over, or repeats counted as columns, give other sums.
TEST(SurvivalMap, CountsTheRepeatsOfEachCell) {
  const MapSpec spec = parse_spec("mine.toml", kSpec);
  // Places: ((method * 3 + row) * 2 + column) * 2 + repeat.
  const SurvivalMap map = map_of(spec, "thesis", verdicts_but(24, {1, 6, 7, 22}));
  EXPECT_EQ(map.at(0, 0, 0), 1U);
  EXPECT_EQ(map.at(0, 1, 1), 0U);
  EXPECT_EQ(map.at(1, 2, 1), 1U);
  EXPECT_EQ(map.at(1, 0, 0), 2U);
  EXPECT_EQ(map.total(0), 9U);
  EXPECT_EQ(map.total(1), 11U);
  EXPECT_EQ(map.runs(), 12U);
}

TEST(SurvivalMap, IsPrintedAPanelForEachMethod) {
  const SurvivalMap map = map_of(parse_spec("mine.toml", kSpec), "thesis", verdicts_but(24, {1, 6, 7, 22}));
  EXPECT_EQ(map_text(map),
            "pushes, plant thesis; survivors of 2 in each cell\n"
            "\n  reflex off: 9 of 12 survive\n"
            "  push, N   towards\n"
            "                  front  left, ahead\n"
            "     50.5             1            2\n"
            "      100             2            0\n"
            "      150             2            2\n"
            "\n  reflex original: 11 of 12 survive\n"
            "  push, N   towards\n"
            "                  front  left, ahead\n"
            "     50.5             2            2\n"
            "      100             2            2\n"
            "      150             2            1\n");
}

TEST(SurvivalMap, QuotesLabelsInCsvAndKeepsTheShapeInJson) {
  const SurvivalMap map = map_of(parse_spec("mine.toml", kSpec), "thesis", verdicts_but(24, {}));
  EXPECT_THAT(map_csv(map), HasSubstr("\noriginal,150,\"left, ahead\",2,2\n"));
  const auto json = nlohmann::json::parse(to_json(map));
  EXPECT_EQ(json.at("methods").size(), 2U);
  EXPECT_EQ(json.at("methods")[0].at("cells").size(), 3U);
  EXPECT_EQ(json.at("methods")[0].at("cells")[0].size(), 2U);
}

}  // namespace
}  // namespace surefoot::map
