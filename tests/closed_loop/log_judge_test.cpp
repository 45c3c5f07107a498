// A run judged from its telemetry log must come out as it was judged beside the loop.
#include "tools/run/log_judge.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "tests/closed_loop/run_scenario.hpp"
#include "tests/unit/firmware_host/temporary_folder.hpp"
#include "tools/run/schedule.hpp"

namespace surefoot {
namespace {

using host::testing::TemporaryFolder;
using testing::run_scenario;

struct Recorded {
  run::Verdict beside_the_loop;
  run::Verdict from_the_log;
};

Recorded record(const std::string& scenario, const std::vector<std::string>& overrides) {
  const TemporaryFolder folder;
  run::RunOptions options;
  options.folder = folder / "run";
  Recorded recorded;
  recorded.beside_the_loop = run_scenario(scenario, overrides, options);
  run::TelemetryLog firmware = run::read_telemetry_log(folder / "run" / "telemetry.lcmlog");
  run::TelemetryLog robot = firmware;  // as two processes would have recorded it: each its own events
  const auto is_of_the_world = [](const event_t& event) { return event.code >= 16 && event.code < 32; };
  std::erase_if(firmware.events, is_of_the_world);
  std::erase_if(robot.events, std::not_fn(is_of_the_world));
  recorded.from_the_log =
      run::judge_logs(run::scheduled(scenario::load(SUREFOOT_SCENARIOS "/" + scenario + ".toml", overrides)), firmware,
                      robot, recorded.beside_the_loop.outcome == run::Outcome::kInterrupted);
  return recorded;
}

void expect_equal(const run::Verdict& beside, const run::Verdict& from_log) {
  EXPECT_EQ(from_log.outcome, beside.outcome);
  EXPECT_EQ(from_log.reason, beside.reason);
  EXPECT_EQ(from_log.torso_pitch_deg.min, beside.torso_pitch_deg.min);
  EXPECT_EQ(from_log.torso_pitch_deg.max, beside.torso_pitch_deg.max);
  EXPECT_EQ(from_log.torso_roll_deg.max, beside.torso_roll_deg.max);
  EXPECT_EQ(from_log.distance_m, beside.distance_m);
  EXPECT_EQ(from_log.steps_walked, beside.steps_walked);
  EXPECT_EQ(from_log.cycles_after_recovery, beside.cycles_after_recovery);
  EXPECT_EQ(from_log.peak_torque_nm, beside.peak_torque_nm);
  EXPECT_EQ(from_log.torque_ripple_nm, beside.torque_ripple_nm);
  EXPECT_EQ(from_log.foot_slip_mm, beside.foot_slip_mm);
  EXPECT_EQ(from_log.payloads_attached, beside.payloads_attached);
  EXPECT_EQ(from_log.payloads_detected, beside.payloads_detected);
  EXPECT_EQ(from_log.payloads_removed, beside.payloads_removed);
  EXPECT_EQ(from_log.pushes, beside.pushes);
  EXPECT_EQ(from_log.disturbance_triggers, beside.disturbance_triggers);
  EXPECT_EQ(from_log.false_alarms, beside.false_alarms);
  ASSERT_EQ(from_log.events.size(), beside.events.size());
  for (std::size_t i = 0; i < beside.events.size(); ++i) {
    EXPECT_STREQ(from_log.events[i].name, beside.events[i].name);
    EXPECT_EQ(from_log.events[i].time_s, beside.events[i].time_s);
  }
}

TEST(LogJudge, JudgesARunThatWalksAsTheLoopDoes) {
  const Recorded run = record("main", {});
  EXPECT_EQ(run.beside_the_loop.outcome, run::Outcome::kWalked);
  expect_equal(run.beside_the_loop, run.from_the_log);
}

TEST(LogJudge, JudgesAFallAsTheLoopDoes) {
  const Recorded run = record("main", {"reflex.method=off"});
  EXPECT_EQ(run.beside_the_loop.outcome, run::Outcome::kFell);
  expect_equal(run.beside_the_loop, run.from_the_log);
}

TEST(LogJudge, JudgesAFaultAsTheLoopDoes) {
  const Recorded run = record("main", {"fault.0.kind=dead_node", "fault.0.target=foot_left", "fault.0.at_s=0.5"});
  EXPECT_EQ(run.beside_the_loop.outcome, run::Outcome::kFault);
  expect_equal(run.beside_the_loop, run.from_the_log);
}

TEST(LogJudge, JudgesPushesAndALoadThatComesAndGoesAsTheLoopDoes) {
  const Recorded run =
      record("push", {"payload.0.mass_kg=2", "payload.0.at_s=7", "payload.0.removed_at_s=9", "duration_s=18.7"});
  EXPECT_EQ(run.beside_the_loop.outcome, run::Outcome::kWalked) << run.beside_the_loop.reason;
  EXPECT_EQ(run.beside_the_loop.payloads_removed, 1);
  EXPECT_EQ(run.beside_the_loop.pushes, 1);
  expect_equal(run.beside_the_loop, run.from_the_log);
}

TEST(LogJudge, GivesNoVerdictWhenTheRobotsRecordBreaksOff) {
  const TemporaryFolder folder;
  run::RunOptions options;
  options.folder = folder / "run";
  (void)run_scenario("no_payload", {"duration_s=4"}, options);
  const run::TelemetryLog firmware = run::read_telemetry_log(folder / "run" / "telemetry.lcmlog");
  run::TelemetryLog robot = firmware;
  robot.truths.resize(robot.truths.size() / 2);
  const auto scenario =
      run::scheduled(scenario::load(SUREFOOT_SCENARIOS "/no_payload.toml", std::vector<std::string>{"duration_s=4"}));
  EXPECT_THROW((void)run::judge_logs(scenario, firmware, robot, false), run::TelemetryLogError);
}

TEST(TelemetryLog, AMissingFileIsNamedWithTheRemedy) {
  try {
    (void)run::read_telemetry_log("/nowhere/telemetry.lcmlog");
    FAIL();
  } catch (const run::TelemetryLogError& error) {
    EXPECT_NE(std::string(error.what()).find("/nowhere/telemetry.lcmlog"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("remedy"), std::string::npos);
  }
}

TEST(TelemetryLog, ALogThatWasCutOffGivesTheMessagesBeforeTheCut) {
  const TemporaryFolder folder;
  run::RunOptions options;
  options.folder = folder / "run";
  (void)run_scenario("no_payload", {"duration_s=0.5"}, options);
  const std::filesystem::path log = folder / "run" / "telemetry.lcmlog";
  const std::size_t whole = run::read_telemetry_log(log).states.size();
  std::filesystem::resize_file(log, std::filesystem::file_size(log) / 2 + 7);
  const std::size_t cut = run::read_telemetry_log(log).states.size();
  EXPECT_GT(cut, whole / 3);
  EXPECT_LT(cut, whole * 2 / 3);
}

TEST(TelemetryLog, MergingTwoLogsKeepsEveryMessageInTheOrderOfTime) {
  const TemporaryFolder one;
  const TemporaryFolder two;
  run::RunOptions options;
  options.folder = one / "run";
  (void)run_scenario("no_payload", {"duration_s=0.2"}, options);
  options.folder = two / "run";
  (void)run_scenario("no_payload", {"duration_s=0.3"}, options);
  const auto log_of = [](const TemporaryFolder& folder) { return folder / "run" / "telemetry.lcmlog"; };
  run::merge_telemetry_logs({log_of(one), log_of(two)}, one / "merged.lcmlog");
  const run::TelemetryLog merged = run::read_telemetry_log(one / "merged.lcmlog");
  EXPECT_EQ(merged.states.size(),
            run::read_telemetry_log(log_of(one)).states.size() + run::read_telemetry_log(log_of(two)).states.size());
  EXPECT_TRUE(std::ranges::is_sorted(merged.states, {}, &controller_state_t::utime));
}

}  // namespace
}  // namespace surefoot
