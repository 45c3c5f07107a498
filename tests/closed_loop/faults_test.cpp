// A walking robot and each kind of fault: what the firmware makes of it is its own tests' concern; here every run ends
// with a verdict, ends alike twice, and keeps its joints within their torques.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "tests/closed_loop/run_scenario.hpp"

namespace surefoot::run {
namespace {

using testing::run_scenario;
using testing::time_of;

constexpr double kTorqueLimit_nm = 200.0;  // of the gate

/// A fault at 1 s, by its keys.
struct Case {
  const char* name;
  std::vector<std::string> keys;
};

void PrintTo(const Case& one, std::ostream* stream) { *stream << one.name; }

std::vector<std::string> overrides_of(const Case& one) {
  std::vector<std::string> overrides{"duration_s=4", "fault.0.at_s=1"};
  for (const std::string& key : one.keys) overrides.push_back("fault.0." + key);
  return overrides;
}

class Fault : public ::testing::TestWithParam<Case> {
 protected:
  void TearDown() override { std::filesystem::remove_all(folder_); }

  Verdict run() {
    RunOptions options;
    options.folder = folder_;
    return run_scenario("no_payload", overrides_of(GetParam()), options);
  }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("surefoot_fault_" + std::to_string(getpid()) + GetParam().name);
};

TEST_P(Fault, EndsInAVerdictTwiceTheSameWithinTheTorqueLimit) {
  const Verdict verdict = run();
  const Outcome outcome = verdict.outcome;
  EXPECT_TRUE(outcome == Outcome::kWalked || outcome == Outcome::kFell || outcome == Outcome::kFault ||
              outcome == Outcome::kLimit)
      << verdict.reason;
  EXPECT_NEAR(time_of(verdict, "fault_injected").value_or(NAN), 1.0, 1e-9);
  for (const double peak_nm : verdict.peak_torque_nm) EXPECT_LE(peak_nm, kTorqueLimit_nm);
  EXPECT_EQ(verdict.allocations_in_loop, 0U);
  const Verdict again = run();
  EXPECT_EQ(again.bus_log_sha256, verdict.bus_log_sha256);
  EXPECT_EQ(again.reason, verdict.reason);
}

INSTANTIATE_TEST_SUITE_P(
    Walking, Fault,
    ::testing::Values(
        Case{"drop", {"kind=drop", "probability=0.001"}}, Case{"drop_all_of_a_foot", {"kind=drop", "target=foot_left"}},
        Case{"drop_sync_and_torques", {"kind=drop", "target=controller", "for_s=0.1"}},
        Case{"duplicate", {"kind=duplicate", "value=3"}}, Case{"delay", {"kind=delay", "value=2", "probability=0.01"}},
        Case{"delay_all", {"kind=delay", "value=20"}},
        Case{"corrupt", {"kind=corrupt", "value=3", "probability=0.001"}},
        Case{"corrupt_all", {"kind=corrupt", "value=64"}},
        Case{"swap_misrouted", {"kind=swap", "target=foot_left", "value=0"}},
        Case{"swap_legs", {"kind=swap", "target=leg_left"}}, Case{"swap_feet", {"kind=swap", "target=foot_right"}},
        Case{"stuck", {"kind=stuck", "target=leg_left", "element=knee_pitch"}},
        Case{"stuck_torso", {"kind=stuck", "target=torso"}},
        Case{"drift", {"kind=drift", "target=leg_right", "signal=angle", "value=0.05"}},
        Case{"noise", {"kind=noise", "target=leg_left", "signal=rate", "value=0.5"}},
        Case{"saturate", {"kind=saturate", "target=foot_left", "value=50"}},
        Case{"dead_leg", {"kind=dead_node", "target=leg_left"}}, Case{"dead_torso", {"kind=dead_node", "target=torso"}},
        Case{"restart", {"kind=restart", "target=leg_right", "for_s=0.2"}},
        Case{"restart_in_no_time", {"kind=restart", "target=leg_right", "for_s=0.001"}},
        Case{"babble", {"kind=babble", "target=torso", "value=200"}},
        Case{"babbling_controller", {"kind=babble", "target=controller", "value=200"}},
        Case{"bus_off", {"kind=bus_off", "target=leg_right", "for_s=0.1"}},
        Case{"link_down", {"kind=link_down", "for_s=0.5"}}),
    [](const auto& one) { return std::string(one.param.name); });

// Faults of single frames, rare enough: the loop forgives them. Another implementation of the line that, say,
// delays everything behind a delayed frame would not be walked through.
TEST(Faults, OfAFewFramesAreWalkedThrough) {
  for (const char* kind : {"drop", "duplicate", "delay", "corrupt"}) {
    const Verdict verdict =
        run_scenario("no_payload", {"duration_s=5", "fault.0.kind=" + std::string(kind), "fault.0.probability=0.001",
                                    "fault.0.for_s=4", "fault.0.at_s=0.5"});
    EXPECT_EQ(verdict.outcome, Outcome::kWalked) << kind << ": " << verdict.reason;
    EXPECT_LE(verdict.torso_pitch_deg.largest_magnitude(), 2.5) << kind;
    EXPECT_NEAR(time_of(verdict, "fault_ended").value_or(NAN), 4.5, 1e-9) << kind;
  }
}

TEST(Faults, OfASecondKindDoNotChangeTheRunBeforeTheyBegin) {
  const std::vector<std::string> one{"duration_s=3",   "fault.0.kind=drop", "fault.0.probability=0.002",
                                     "fault.0.at_s=0", "fault.0.for_s=3",   "limits.min_cycles_after_recovery=0"};
  std::vector<std::string> two = one;
  two.insert(two.end(), {"fault.1.kind=corrupt", "fault.1.probability=0.5", "fault.1.at_s=100"});
  const Verdict alone = run_scenario("no_payload", one);
  const Verdict beside = run_scenario("no_payload", two);
  EXPECT_EQ(alone.torso_pitch_deg.max, beside.torso_pitch_deg.max);
  EXPECT_EQ(alone.frames_lost, beside.frames_lost);
  EXPECT_GT(alone.frames_lost, 20U);
}

}  // namespace
}  // namespace surefoot::run
