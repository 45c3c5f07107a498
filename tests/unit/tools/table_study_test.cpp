#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tools/scenario/scenario.hpp"
#include "tools/table/band.hpp"
#include "tools/table/false_alarms.hpp"
#include "tools/table/random_table.hpp"
#include "tools/table/trigger_delays.hpp"

namespace surefoot::table {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

const Experiment kOriginal{"original", "thesis", {}, {}};

scenario::Scenario scenario_of(const batch::Batch& batch, std::size_t trial) {
  std::vector<std::string> overrides = batch.common;
  overrides.insert(overrides.end(), batch.trials[trial].overrides.begin(), batch.trials[trial].overrides.end());
  return scenario::load_default(overrides);
}

TEST(Experiment, HangsTheLoadThatItNamesAndHasNoLimitButTheFall) {
  const batch::Batch batch = batch_of({"modified", "nominal", {}, {"seed=3"}}, {{12.5, 1.3}});
  const scenario::Scenario scenario = scenario_of(batch, 0);
  EXPECT_EQ(scenario.plant, "nominal");
  EXPECT_EQ(scenario.sim.seed, 3U);
  ASSERT_EQ(scenario.sim.payloads.size(), 1U);
  EXPECT_EQ(scenario.sim.payloads[0].mass_kg, 12.5);
  EXPECT_EQ(scenario.sim.payloads[0].at_s, 1.3);
  EXPECT_EQ(scenario.firmware.reflex.settling_s, 4.0) << "table 4.3 was made with a settling time of 4 s";
  EXPECT_EQ(scenario.limits.max_abs_pitch_deg, 0.0);
  EXPECT_EQ(scenario.limits.min_cycles_after_recovery, 2.0);
}

// El-Kahlout 2003: 0.1 + 4 + 0.5 + at most 1.2 + 2 s of recovery, and 9.6 s of two cycles, after the trigger.
TEST(Experiment, LastsUntilTwoCyclesAfterTheLongestRecovery) {
  const scenario::Scenario scenario = scenario_of(batch_of({"modified", "thesis", {}, {}}, {{5.0, 4.8}}), 0);
  EXPECT_GE(scenario.duration_s, 4.8 + 0.1 + 4.0 + 0.5 + 1.2 + 2.0 + 9.6);
}

TEST(RandomLoads, AreTheSameForASeedStayInTheirBoundsAndGoOnWhereFewerEnd) {
  const std::vector<Load> many = draw_loads(500, 7, {1.0, 20.0}, {0.1, 4.8});
  const std::vector<Load> few = draw_loads(10, 7, {1.0, 20.0}, {0.1, 4.8});
  double sum_kg = 0.0;
  for (std::size_t i = 0; i < many.size(); ++i) {
    if (i < few.size()) {
      EXPECT_EQ(many[i].mass_kg, few[i].mass_kg);
    }
    EXPECT_GE(many[i].mass_kg, 1.0);
    EXPECT_LE(many[i].mass_kg, 20.0);
    EXPECT_GE(many[i].at_s, 0.1);
    EXPECT_LE(many[i].at_s, 4.8);
    sum_kg += many[i].mass_kg;
  }
  // Mean 10.5, standard error of the mean 19 / sqrt(12 * 500) = 0.25 kg.
  EXPECT_NEAR(sum_kg / 500.0, 10.5, 4 * 0.25);
  EXPECT_NE(draw_loads(1, 8, {1.0, 20.0}, {0.1, 4.8})[0].mass_kg, few[0].mass_kg);
}

TEST(RandomText, CountsEachQuarterOfTheRange) {
  RandomTable table{"original", "thesis", 1, {{1.0, 1.0}, {20.0, 1.0}, {19.0, 1.0}}, std::vector<Cell>(3)};
  table.cells[0].survives = true;
  const std::string text = random_text(table, {1.0, 20.0});
  EXPECT_THAT(text, HasSubstr("1 of 3 random loads"));
  EXPECT_THAT(text, HasSubstr("1 to 5.75  kg: 1 of 1\n"));
  EXPECT_THAT(text, HasSubstr("15.25 to 20    kg: 0 of 2\n"));
}

TEST(Band, LiesAroundThePlantAndCountsItsGridOnEachPlant) {
  const BandAxes axes = band_around(scenario::load_default());
  EXPECT_EQ(axes.frictions, (std::vector<double>{0.088, 0.11, 0.1375}));
  EXPECT_EQ(axes.toes_m, (std::vector<double>{0.1188, 0.1228, 0.1268}));
  const Grid grid{{1.2, 2.0}, {5.0}};
  const batch::Batch batch = band_batch(kOriginal, axes, grid);
  ASSERT_EQ(batch.trials.size(), 18U);
  const scenario::Scenario last = scenario_of(batch, 17);
  EXPECT_EQ(last.sim.contact.friction, 0.1375);
  EXPECT_EQ(last.sim.geometry.sole_toe_m, 0.1268);
  EXPECT_EQ(last.sim.payloads.at(0).at_s, 2.0);

  std::vector<run::Verdict> verdicts(18);
  verdicts[2].outcome = run::Outcome::kFell;   // first friction, second toe
  verdicts[12].outcome = run::Outcome::kFell;  // third friction, first toe
  verdicts[13].outcome = run::Outcome::kFell;
  const Band band = band_of(kOriginal, axes, grid, verdicts);
  EXPECT_EQ(band.survive(0, 1), 1U);
  EXPECT_EQ(band.survive(2, 0), 0U);
  EXPECT_EQ(band.survive(1, 0), 2U);
  EXPECT_THAT(band_csv(band), HasSubstr("\n0.1375,0.1188,0,2\n"));
}

TEST(TriggerDelays, CountFromTheLoadToItsFirstDetection) {
  std::vector<run::Verdict> verdicts(2);
  verdicts[0].events = {{"payload_attached", 1.2}, {"payload_detected", 1.25}, {"payload_detected", 1.4}};
  verdicts[1].events = {{"payload_attached", 1.2}};
  const TriggerDelays study = delays_of(kOriginal, {{1.2}, {5.0, 15.0}}, verdicts);
  EXPECT_NEAR(study.delays_s[0].value(), 0.05, 1e-12);
  EXPECT_FALSE(study.delays_s[1]);
  const std::string text = delay_text(study);
  EXPECT_THAT(text, HasSubstr("5 kg at 1.2 s: thesis 62.5 ms, here 50.0 ms"));
  EXPECT_THAT(text, HasSubstr("15 kg at 1.2 s: thesis 30.5 ms, here - ms"));
}

TEST(NoiseStudy, WalksTheCyclesThatWereAskedForWithASeedForEachRun) {
  const batch::Batch batch = noise_batch(kOriginal, {.noise = {}, .cycles = 45, .cycles_per_run = 20, .first_seed = 9});
  ASSERT_EQ(batch.trials.size(), 3U);
  double walked_s = 0.0;
  for (std::size_t i = 0; i < batch.trials.size(); ++i) {
    const scenario::Scenario scenario = scenario_of(batch, i);
    EXPECT_TRUE(scenario.sim.payloads.empty());
    EXPECT_EQ(scenario.sim.sensor.force_noise_n, 2.0);
    EXPECT_EQ(scenario.sim.seed, 9U + i);
    walked_s += scenario.duration_s;
  }
  EXPECT_NEAR(walked_s, 45 * 4.8, 1e-9);
}

TEST(NoiseStudy, SumsAlarmsAndKeepsTheSmallestMargin) {
  std::vector<run::Verdict> verdicts(3);
  for (std::size_t i = 0; i < 3; ++i) verdicts[i].unloaded_margin_n.include(2.0 + static_cast<double>(i));
  verdicts[1].unloaded_margin_n.include(-0.5);
  verdicts[1].outcome = run::Outcome::kLimit;
  verdicts[1].false_alarms = 2;
  const FalseAlarms study = false_alarms_of(kOriginal, {}, verdicts);
  EXPECT_EQ(study.false_alarms, 2U);
  EXPECT_EQ(study.runs_not_walked, 1U);
  EXPECT_EQ(study.smallest_margin_n, -0.5);
}

}  // namespace
}  // namespace surefoot::table
