#include "tools/run/verdict.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "tools/run/judge.hpp"

namespace surefoot::run {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

std::set<std::string> keys_of(const json& object) {
  std::set<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.insert(key);
  return keys;
}

bool holds_null(const json& value) {
  if (!value.is_structured()) return value.is_null();
  return std::any_of(value.begin(), value.end(), holds_null);
}

Verdict full_verdict() {
  Verdict verdict;
  verdict.reason = "walks until the end at 20.000 s";
  verdict.torso_pitch_deg.include(-0.5);
  verdict.torso_pitch_deg.include(1.25);
  verdict.torso_roll_deg.include(-1.5);
  verdict.torso_roll_deg.include(6.5);
  verdict.cycles_after_recovery = 2.955;
  verdict.events = {{"payload_attached", 1.2}, {"payload_detected", 1.251}};
  verdict.bus_log_sha256 = std::string(64, 'a');
  verdict.allocations_were_counted = true;
  verdict.tick_us_mean = 3.75;
  verdict.tick_us_p50 = 3.5;
  verdict.tick_us_p999 = 7.25;
  verdict.tick_us_max = 90.5;
  verdict.tick_bins[4] = 3;
  verdict.real_time_factor = 64.0;
  verdict.peak_torque_nm = {1.0, 2.0, 3.0, 4.0, 5.0, 6.0};
  verdict.foot_slip_mm = 18.5;
  verdict.frames_sent = 160'320;
  verdict.frames_lost = 7;
  verdict.bus_load_percent = 42.5;
  verdict.bus = {
      {.load_percent = 42.5,
       .frames = 10,
       .nominal_bits = 300,
       .data_bits = 4000,
       .busy_ns = 1'100'000,
       .elapsed_ns = 5'000'000,
       .streams = {{.identifier = 0x80, .name = "SYNC", .frames = 10, .worst_case_us = 190.25, .observed_us = 51.75},
                   {.identifier = 0x185, .name = "IMU", .worst_case_us = {}}}}};
  return verdict;
}

TEST(ExitCodes, AreWhatScriptsRelyOn) {
  EXPECT_EQ(static_cast<int>(exit_code(Outcome::kWalked)), 0);
  EXPECT_EQ(static_cast<int>(exit_code(Outcome::kFell)), 2);
  EXPECT_EQ(static_cast<int>(exit_code(Outcome::kLimit)), 2);
  EXPECT_EQ(static_cast<int>(exit_code(Outcome::kFault)), 3);
  EXPECT_EQ(static_cast<int>(exit_code(Outcome::kInterrupted)), 130);
}

TEST(OutcomeNames, AreWhatVerdictJsonHolds) {
  EXPECT_STREQ(name(Outcome::kWalked), "walked");
  EXPECT_STREQ(name(Outcome::kFell), "fell");
  EXPECT_STREQ(name(Outcome::kLimit), "limit");
  EXPECT_STREQ(name(Outcome::kFault), "fault");
  EXPECT_STREQ(name(Outcome::kInterrupted), "interrupted");
}

// A range that began at zero would show a pitch of 0 that never was.
TEST(RangeOfValues, HoldsOnlyWhatWasSeenAndKnowsItsLargestMagnitude) {
  Range range;
  EXPECT_TRUE(range.is_empty);
  EXPECT_EQ(range.largest_magnitude(), 0.0);
  range.include(-2.0);
  EXPECT_EQ(range.min, -2.0);
  EXPECT_EQ(range.max, -2.0);
  EXPECT_EQ(range.largest_magnitude(), 2.0);
  range.include(1.5);
  EXPECT_EQ(range.max, 1.5);
  EXPECT_EQ(range.largest_magnitude(), 2.0);
  range.include(3.0);
  EXPECT_EQ(range.largest_magnitude(), 3.0);
}

TEST(VerdictJson, HoldsTheNamesAndValuesThatScriptsRead) {
  const json verdict = json::parse(to_json(full_verdict()));
  EXPECT_EQ(verdict.at("verdict"), "walked");
  EXPECT_EQ(verdict.at("reason"), "walks until the end at 20.000 s");
  EXPECT_EQ(verdict.at("torso_pitch_deg"), json({{"min", -0.5}, {"max", 1.25}}));
  EXPECT_EQ(verdict.at("torso_roll_deg"), json({{"min", -1.5}, {"max", 6.5}}));
  EXPECT_NEAR(verdict.at("cycles_after_recovery").get<double>(), 2.955, 1e-9);
  EXPECT_EQ(verdict.at("bus_log_sha256"), std::string(64, 'a'));
  EXPECT_EQ(verdict.at("allocations_in_loop"), 0);
  EXPECT_EQ(verdict.at("tick_us"), json({{"mean", 3.75}, {"p50", 3.5}, {"p999", 7.25}, {"max", 90.5}, {"histogram", {{0.128, 0.16, 3}}}}));
  EXPECT_EQ(verdict.at("real_time_factor"), 64.0);
  EXPECT_EQ(verdict.at("foot_slip_mm"), 18.5);
  EXPECT_EQ(verdict.at("frames_sent"), 160'320);
  EXPECT_EQ(verdict.at("frames_lost"), 7);
  EXPECT_EQ(verdict.at("bus_load_percent"), 42.5);
}

TEST(VerdictJson, HoldsTheBitsAndTheResponseTimesOfEachBus) {
  const json buses = json::parse(to_json(full_verdict())).at("bus");
  ASSERT_EQ(buses.size(), 1U);
  const json& bus = buses[0];
  EXPECT_EQ(bus.at("frames"), 10);
  EXPECT_EQ(bus.at("nominal_bits"), 300);
  EXPECT_EQ(bus.at("data_bits"), 4000);
  EXPECT_EQ(bus.at("busy_ns"), 1'100'000);
  EXPECT_EQ(bus.at("elapsed_ns"), 5'000'000);
  EXPECT_EQ(bus.at("load_percent"), 42.5);
  EXPECT_EQ(bus.at("identifiers")[0], json({{"identifier", "0x080"},
                                            {"name", "SYNC"},
                                            {"frames", 10},
                                            {"worst_case_us", 190.25},
                                            {"observed_us", 51.75}}));
  EXPECT_TRUE(bus.at("identifiers")[1].at("worst_case_us").is_null());
}

TEST(VerdictJson, NamesEveryJointWithItsPeakTorque) {
  const json peaks = json::parse(to_json(full_verdict())).at("peak_torque_nm");
  EXPECT_EQ(peaks.size(), kJointsPerLeg);
  for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
    EXPECT_DOUBLE_EQ(peaks.at(kLegJointNames[joint]).get<double>(), 1.0 + static_cast<double>(joint));
  }
}

TEST(VerdictJson, ListsTheEventsInOrderWithNameAndTime) {
  const json events = json::parse(to_json(full_verdict())).at("events");
  ASSERT_EQ(events.size(), 2U);
  for (const json& event : events) EXPECT_EQ(keys_of(event), (std::set<std::string>{"name", "time_s"}));
  EXPECT_EQ(events[0].at("name"), "payload_attached");
  EXPECT_NEAR(events[0].at("time_s").get<double>(), 1.2, 1e-9);
  EXPECT_EQ(events[1].at("name"), "payload_detected");
  EXPECT_NEAR(events[1].at("time_s").get<double>(), 1.251, 1e-9);
}

TEST(VerdictJson, HoldsAnEmptyListWhenNothingHappened) {
  const json events = json::parse(to_json(Verdict{})).at("events");
  EXPECT_TRUE(events.is_array());
  EXPECT_TRUE(events.empty());
}

// A zero that nobody counted would be a lie.
TEST(VerdictJson, SaysNullForAllocationsThatNobodyCounted) {
  Verdict verdict = full_verdict();
  verdict.allocations_were_counted = false;
  EXPECT_TRUE(json::parse(to_json(verdict)).at("allocations_in_loop").is_null());
}

// A reason is free text: quotes and line ends in it must not break the file.
TEST(VerdictJson, IsValidWhateverTheReasonSays) {
  Verdict verdict = full_verdict();
  verdict.reason = "a \"quoted\"\n\\reason";
  EXPECT_EQ(json::parse(to_json(verdict)).at("reason"), verdict.reason);
}

// Means and shares over nothing: JSON has no NaN, nlohmann would write null.
TEST(VerdictJson, HoldsOnlyNumbersForARunThatEndedBeforeItsFirstTickOrBeforeTimeZero) {
  scenario::Scenario scenario;
  scenario.sim.time_zero_s = 12.0;
  Judge judge(scenario);
  for (const bool has_ticked : {false, true}) {
    TickOutput output;
    if (has_ticked) judge.observe(output, {}, {});
    Verdict verdict = judge.verdict(true);
    verdict.allocations_were_counted = true;
    const json parsed = json::parse(to_json(verdict));
    EXPECT_FALSE(holds_null(parsed)) << parsed.dump(2);
    EXPECT_EQ(parsed.at("verdict"), "interrupted");
    EXPECT_EQ(parsed.at("torso_pitch_deg"), json({{"min", 0.0}, {"max", 0.0}}));
  }
}

TEST(VerdictText, ShowsTheSameFiguresToAPerson) {
  const std::string text = to_text(full_verdict());
  EXPECT_THAT(text, HasSubstr("walked: walks until the end at 20.000 s"));
  EXPECT_THAT(text, HasSubstr("pitch -0.50 to +1.25 deg, roll -1.50 to +6.50 deg"));
  EXPECT_THAT(text, HasSubstr("2.96 cycles"));
  EXPECT_THAT(text, HasSubstr("1.2510 s    +0.0510  payload_detected"));
  EXPECT_THAT(text, HasSubstr("hip_yaw 1, hip_roll 2, hip_pitch 3, knee_pitch 4, ankle_pitch 5, ankle_roll 6 N m"));
  EXPECT_THAT(text, HasSubstr("160320 frames, 7 lost"));
  EXPECT_THAT(text, HasSubstr("0 allocations"));
  EXPECT_THAT(text, Not(HasSubstr("start-up")));
}

TEST(VerdictText, FallsBackOnTheStartUpWhenTimeZeroWasNeverReached) {
  Verdict verdict;
  verdict.start_up_pitch_deg.include(-3.0);
  verdict.start_up_roll_deg.include(4.0);
  const std::string text = to_text(verdict);
  EXPECT_THAT(text, HasSubstr("pitch -3.00 to -3.00 deg, roll +4.00 to +4.00 deg (start-up"));
  EXPECT_THAT(text, HasSubstr("uncounted allocations"));
}

}  // namespace
}  // namespace surefoot::run
