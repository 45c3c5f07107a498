#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/closed_loop/run_scenario.hpp"

namespace surefoot {
namespace {

using testing::run_scenario;
using testing::time_of;

TEST(FloorPayload, IsAnsweredWhileTheRobotWalksOnOverTilesOnTheSlope) {
  const run::Verdict verdict = run_scenario("khr2_payload");
  EXPECT_EQ(verdict.outcome, run::Outcome::kWalked) << verdict.reason;
  EXPECT_EQ(verdict.payloads_detected, 1);
  EXPECT_EQ(verdict.false_alarms, 0);
  const auto detected_s = time_of(verdict, "payload_detected");
  ASSERT_TRUE(detected_s.has_value());
  EXPECT_GE(*detected_s, 5.0);
  EXPECT_LE(*detected_s, 5.5);
  EXPECT_TRUE(time_of(verdict, "reflex_done", *detected_s).has_value());
  EXPECT_TRUE(time_of(verdict, "shifted", *detected_s).has_value());
}

// The landings on the tiles must not look like a load.
TEST(FloorPayload, IsNotSeenWhereNoneHangs) {
  const run::Verdict verdict = run_scenario("khr2_payload", {"payload=[]"});
  EXPECT_EQ(verdict.outcome, run::Outcome::kWalked) << verdict.reason;
  EXPECT_EQ(verdict.false_alarms, 0);
  EXPECT_FALSE(time_of(verdict, "payload_detected").has_value());
}

// The stabiliser alone carries 5 kg, too: the need for the reflex begins with heavier loads (docs/uneven_floor.md).
TEST(FloorPayload, IsOnlyReportedWithoutTheReflex) {
  const run::Verdict verdict = run_scenario("khr2_payload", {"reflex.method=off", "duration_s=9"});
  EXPECT_EQ(verdict.outcome, run::Outcome::kWalked) << verdict.reason;
  EXPECT_EQ(verdict.payloads_detected, 1);
  EXPECT_FALSE(time_of(verdict, "payload_detected").has_value());
}

TEST(FloorPayload, CarriesWithTheReflexWhatTheStabiliserAloneDoesNot) {
  const std::vector<std::string> heavy{"payload.0.mass_kg=30", "payload.0.at_s=5.95", "limits.max_abs_pitch_deg=0",
                                       "limits.max_abs_roll_deg=0"};
  const run::Verdict with = run_scenario("khr2_payload", heavy);
  EXPECT_EQ(with.outcome, run::Outcome::kWalked) << with.reason;
  std::vector<std::string> without = heavy;
  without.emplace_back("reflex.method=off");
  EXPECT_EQ(run_scenario("khr2_payload", without).outcome, run::Outcome::kFell);
}

}  // namespace
}  // namespace surefoot
