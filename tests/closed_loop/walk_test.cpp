#include <gtest/gtest.h>

#include "tests/closed_loop/run_scenario.hpp"

namespace surefoot::run {
namespace {

using testing::run_main_job;

struct Variant {
  const char* name;
  std::vector<std::string> overrides;
};

void PrintTo(const Variant& variant, std::ostream* stream) { *stream << variant.name; }

class Walk : public ::testing::TestWithParam<Variant> {};

// Twenty cycles without a payload: the thesis' plots stay within 2.5 degrees. Chatter hides behind a
// robot that walks, so slip, ripple and time at the limit are judged as well.
TEST_P(Walk, GoesOnForTwentyCyclesQuietly) {
  std::vector<std::string> overrides{"payload=[]", "duration_s=96"};
  overrides.insert(overrides.end(), GetParam().overrides.begin(), GetParam().overrides.end());
  const Verdict verdict = run_main_job(overrides);
  ASSERT_EQ(verdict.outcome, Outcome::kWalked) << verdict.reason;
  EXPECT_LE(verdict.torso_pitch_deg.largest_magnitude(), 2.5);
  EXPECT_LE(verdict.torso_roll_deg.largest_magnitude(), 2.5);
  EXPECT_LT(verdict.time_at_torque_limit_percent, 0.1);
  EXPECT_NEAR(verdict.standing_zmp_x_body_m, -0.035, 0.003);  // statics of the printed masses
  EXPECT_EQ(verdict.unreachable_ticks, 0);
  EXPECT_EQ(verdict.frames_lost, 0u);
  EXPECT_EQ(verdict.frames_late, 0u);
  EXPECT_EQ(verdict.steps_walked, 40);
  for (const TimedEvent& event : verdict.events) {
    EXPECT_STRNE(event.name, "payload_detected") << "the detector fired without a payload";
  }
}

INSTANTIATE_TEST_SUITE_P(
    Plants, Walk,
    ::testing::Values(Variant{"thesis", {"plant=thesis"}}, Variant{"nominal", {"plant=nominal"}},
                      Variant{"thesis_half_step", {"plant=thesis", "physics.step_s=0.00025"}},
                      Variant{"nominal_half_step", {"plant=nominal", "physics.step_s=0.00025"}}),
    [](const auto& parameter) { return std::string(parameter.param.name); });

}  // namespace
}  // namespace surefoot::run
