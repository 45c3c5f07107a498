#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "surefoot/event_t.hpp"
#include "tools/run/judge.hpp"

namespace surefoot::run::testing {

inline constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;
inline constexpr double kPeriod_s = 0.125;  // exact in binary, and so are all instants below
inline constexpr double kTimeZero_s = 8.0;

inline const RunEvent kAttached{event_t::PAYLOAD_ATTACHED, "payload_attached", 5.0};
inline const RunEvent kDetected{event_t::PAYLOAD_DETECTED, "payload_detected", 0.0};
inline const RunEvent kBalanceLost{event_t::BALANCE_LOST, "balance_lost", 0.0};
inline const RunEvent kRemoved{event_t::PAYLOAD_REMOVED, "payload_removed", 5.0};
inline const RunEvent kPushBegins{event_t::PUSH_BEGINS, "push_begins", 0.0};
inline const RunEvent kPushEnds{event_t::PUSH_ENDS, "push_ends", 0.0};
inline const RunEvent kSeen{event_t::PAYLOAD_SEEN, "payload_seen", 800.0};

/// A judge that is shown ticks which nobody simulated; the robot walks, in double support.
class JudgeFixture : public ::testing::Test {
 protected:
  JudgeFixture() {
    scenario_.firmware.period_s = kPeriod_s;
    scenario_.sim.time_zero_s = kTimeZero_s;
    output_.decision.phase = decision::ReflexPhase::kWalking;
  }

  Judge& judge() {
    if (!judge_) judge_.emplace(scenario_);
    return *judge_;
  }

  /// Shows the tick at `time_s` on the scenario's clock.
  void see(double time_s, const std::vector<RunEvent>& events = {}) {
    output_.tick = static_cast<std::uint32_t>(std::lround((time_s + kTimeZero_s) / kPeriod_s));
    for (const RunEvent& event : events) {
      truth_.payloads_hung += event.code == event_t::PAYLOAD_ATTACHED ? 1 : 0;
      truth_.payloads_removed += event.code == event_t::PAYLOAD_REMOVED ? 1 : 0;
    }
    judge().observe(output_, truth_, events);
  }

  /// Shows all ticks in [from_s, to_s).
  void see_from_to(double from_s, double to_s) {
    for (double time_s = from_s; time_s < to_s; time_s += kPeriod_s) see(time_s);
  }

  void lean(double pitch_deg, double roll_deg) {
    truth_.pitch_rad = pitch_deg * kRadiansPerDegree;
    truth_.roll_rad = roll_deg * kRadiansPerDegree;
  }

  /// From power-up: the load of 5 kg comes at 1 s and is noticed; then the robot walks on until `end_s`.
  void survive_a_payload(double end_s) {
    see(-kTimeZero_s);
    see(1.0, {kAttached});
    output_.decision.phase = decision::ReflexPhase::kReflex;
    see(1.125, {kDetected});
    output_.decision.phase = decision::ReflexPhase::kWalking;
    see_from_to(5.0, end_s);
  }

  Verdict verdict(bool was_interrupted = false) { return judge().verdict(was_interrupted); }

  scenario::Scenario scenario_;
  TickOutput output_;
  sim_hw::GroundTruth truth_;

 private:
  std::optional<Judge> judge_;
};

inline void expect_outcome(const Verdict& verdict, Outcome outcome, int code, const std::string& figure) {
  EXPECT_EQ(verdict.outcome, outcome) << verdict.reason;
  EXPECT_EQ(static_cast<int>(exit_code(verdict.outcome)), code);
  EXPECT_THAT(verdict.reason, ::testing::HasSubstr(figure));
}

}  // namespace surefoot::run::testing
