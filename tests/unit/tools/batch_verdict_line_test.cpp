#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tools/batch/verdict_line.hpp"

namespace surefoot::batch {
namespace {

FinishedTrial some_trial() {
  FinishedTrial finished{7, "0123456789abcdef", {}};
  run::Verdict& verdict = finished.verdict;
  verdict.outcome = run::Outcome::kLimit;
  verdict.reason = "torso \"pitch\"\nreached 3 deg";
  verdict.ended_at_s = 0.1 + 0.2;  // no short decimal
  verdict.torso_pitch_deg.include(-0.0);
  verdict.torso_pitch_deg.include(std::nextafter(1.0, 2.0));
  verdict.events = {{"payload_attached", 1.2}, {"resumed", std::numeric_limits<double>::denorm_min()}};
  verdict.peak_torque_nm = {1e300, 2.0, 3.0, 4.0, 5.0, 1.0 / 3.0};
  verdict.frames_sent = std::numeric_limits<std::uint64_t>::max();
  verdict.false_alarms = -1;
  return finished;
}

TEST(VerdictLine, ReadsBackToTheLastBit) {
  const FinishedTrial written = some_trial();
  const auto read = read_line(line_of(written));
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->trial, 7U);
  EXPECT_EQ(read->hash, written.hash);
  EXPECT_EQ(read->verdict.outcome, run::Outcome::kLimit);
  EXPECT_EQ(read->verdict.reason, written.verdict.reason);
  EXPECT_EQ(read->verdict.ended_at_s, 0.1 + 0.2);
  EXPECT_TRUE(std::signbit(read->verdict.torso_pitch_deg.min));
  EXPECT_EQ(read->verdict.torso_pitch_deg.max, std::nextafter(1.0, 2.0));
  EXPECT_TRUE(read->verdict.torso_roll_deg.is_empty);
  ASSERT_EQ(read->verdict.events.size(), 2U);
  EXPECT_STREQ(read->verdict.events[1].name, "resumed");
  EXPECT_EQ(read->verdict.events[1].time_s, std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(read->verdict.peak_torque_nm, written.verdict.peak_torque_nm);
  EXPECT_EQ(read->verdict.frames_sent, written.verdict.frames_sent);
  EXPECT_EQ(read->verdict.false_alarms, -1);
}

TEST(VerdictLine, KeepsNumbersThatJsonDoesNotKnow) {
  FinishedTrial written = some_trial();
  written.verdict.foot_slip_mm = std::numeric_limits<double>::quiet_NaN();
  written.verdict.distance_m = -std::numeric_limits<double>::infinity();
  const auto read = read_line(line_of(written));
  ASSERT_TRUE(read.has_value());
  EXPECT_TRUE(std::isnan(read->verdict.foot_slip_mm));
  EXPECT_EQ(read->verdict.distance_m, -std::numeric_limits<double>::infinity());
}

TEST(VerdictLine, CutOffAnywhereIsNoLine) {
  const std::string line = line_of(some_trial());
  for (std::size_t length = 0; length < line.size(); ++length) {
    EXPECT_FALSE(read_line(line.substr(0, length)).has_value()) << length;
  }
}

TEST(VerdictLine, WithAMemberOfAnotherKindIsNoLine) {
  const std::string line = line_of(some_trial());
  for (const char* name : {"\"outcome\":", "\"ended_at_s\":", "\"torso_pitch_deg\":", "\"events\":", "\"reason\":",
                           "\"peak_torque_nm\":", "\"trial\":", "\"scenario\":"}) {
    std::string damaged = line;
    const std::size_t at = damaged.find(name);
    ASSERT_NE(at, std::string::npos) << name;
    damaged.insert(at + std::string(name).size(), R"({"x":1},"y":)");
    EXPECT_FALSE(read_line(damaged).has_value()) << damaged;
  }
}

TEST(VerdictLine, WithAnOutcomeThatDoesNotExistIsNoLine) {
  std::string line = line_of(some_trial());
  const std::size_t at = line.find("\"outcome\":2");
  line.replace(at, 11, "\"outcome\":9");
  EXPECT_FALSE(read_line(line).has_value());
}

}  // namespace
}  // namespace surefoot::batch
