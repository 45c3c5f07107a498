// The main job, 5 kg hung on the walking robot, under every choice that the thesis leaves open: a variant
// nobody runs is a variant that does not work.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/closed_loop/run_scenario.hpp"

namespace surefoot::run {
namespace {

using testing::run_scenario;
using testing::time_of;

struct Variant {
  const char* name;
  std::vector<std::string> overrides;
};

void PrintTo(const Variant& variant, std::ostream* stream) { *stream << variant.name; }

class MainJob : public ::testing::TestWithParam<Variant> {};

TEST_P(MainJob, IsDoneInThisVariantToo) {
  const Verdict verdict = run_scenario("main", GetParam().overrides);
  ASSERT_EQ(verdict.outcome, Outcome::kWalked) << verdict.reason;
  EXPECT_LE(verdict.torso_pitch_deg.largest_magnitude(), 2.5);
  EXPECT_GE(verdict.cycles_after_recovery, 2.0);
  EXPECT_EQ(verdict.payloads_detected, 1);
  EXPECT_LE(time_of(verdict, "payload_detected").value_or(NAN),
            time_of(verdict, "payload_attached").value_or(NAN) + 0.15);
  EXPECT_LT(verdict.time_at_torque_limit_percent, 0.1);
  EXPECT_EQ(verdict.unreachable_ticks, 0);
}

INSTANTIATE_TEST_SUITE_P(
    Variants, MainJob,
    ::testing::Values(Variant{"quintic_feet", {"reflex.profile=quintic"}}, Variant{"nominal_plant", {"plant=nominal"}},
                      Variant{"literal_signs", {"reflex.mirrored=false"}},
                      Variant{"literal_signs_in_the_other_half",  // where mirroring would make a difference
                              {"reflex.mirrored=false", "payload.0.at_s=3.6", "duration_s=22.4"}},
                      Variant{"cosine_timing", {"reflex.timing=nominal_cosine"}},
                      Variant{"exact_inertia", {"payload.0.inertia=exact"}},
                      Variant{"half_period",
                              {"control_period_s=0.0005", "bus.command_latency_s=0.0005", "bus.count=2"}}),
    [](const auto& variant) { return std::string(variant.param.name); });

}  // namespace
}  // namespace surefoot::run
