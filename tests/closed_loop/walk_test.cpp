#include <gtest/gtest.h>

#include <cmath>

#include "tests/closed_loop/run_scenario.hpp"

namespace surefoot::run {
namespace {

using testing::run_scenario;
using testing::time_of;

struct Variant {
  const char* name;
  const char* scenario;
  std::vector<std::string> overrides;
  double max_ripple_nm = 0.45;  // 0.31 to 0.40 without chatter; rigid contact 0.66 to 0.75
  double max_slip_mm = 18.0;    // a step; 15.5 on the slippery floor, below 1 on the other
};

void PrintTo(const Variant& variant, std::ostream* stream) { *stream << variant.name; }

class Walk : public ::testing::TestWithParam<Variant> {};

// Twenty cycles without a payload: the thesis' plots stay within 2.5 degrees. Chatter hides behind a
// robot that walks, so slip, ripple and time at the limit are judged as well.
TEST_P(Walk, GoesOnForTwentyCyclesQuietly) {
  const Verdict verdict = run_scenario(GetParam().scenario, GetParam().overrides);
  ASSERT_EQ(verdict.outcome, Outcome::kWalked) << verdict.reason;
  EXPECT_LE(verdict.torso_pitch_deg.largest_magnitude(), 2.5);
  EXPECT_LE(verdict.torso_roll_deg.largest_magnitude(), 2.5);
  EXPECT_LT(verdict.time_at_torque_limit_percent, 0.1);
  EXPECT_LT(verdict.torque_ripple_nm, GetParam().max_ripple_nm);
  EXPECT_LT(verdict.foot_slip_mm, GetParam().max_slip_mm);
  EXPECT_NEAR(verdict.standing_zmp_x_body_m, -0.035, 0.003);  // statics of the printed masses
  EXPECT_EQ(verdict.unreachable_ticks, 0);
  EXPECT_EQ(verdict.frames_lost, 0U);
  EXPECT_EQ(verdict.frames_late, 0U);
  EXPECT_EQ(verdict.steps_walked, 40);
  EXPECT_FALSE(time_of(verdict, "payload_detected")) << "the detector fired without a payload";
}

INSTANTIATE_TEST_SUITE_P(
    Plants, Walk,
    ::testing::Values(Variant{"thesis", "no_payload", {}}, Variant{"nominal", "no_payload_nominal", {}, 0.45, 2.0},
                      Variant{"thesis_half_step", "no_payload", {"physics.step_s=0.00025"}},
                      Variant{"nominal_half_step", "no_payload_nominal", {"physics.step_s=0.00025"}, 0.45, 2.0},
                      Variant{"thesis_quarter_step", "no_payload", {"physics.step_s=0.000125"}},
                      Variant{"nominal_quarter_step", "no_payload_nominal", {"physics.step_s=0.000125"}, 0.45, 2.0},
                      Variant{"thesis_bullet_contact", "no_payload", {"contact.model=bullet"}, 0.9, 22.0},
                      Variant{"nominal_bullet_contact", "no_payload_nominal", {"contact.model=bullet"}, 0.9, 3.0}),
    [](const auto& variant) { return std::string(variant.param.name); });

// Sensor noise moves the learned threshold with it: no false alarm, no fall.
TEST(Walk, IsNotDisturbedBySensorNoise) {
  const Verdict verdict = run_scenario("main", {"sensor.encoder_noise_rad=2e-5", "sensor.joint_rate_noise_rad_s=0.005",
                                                "sensor.force_noise_n=2.0", "sensor.gyro_noise_rad_s=0.005"});
  ASSERT_EQ(verdict.outcome, Outcome::kWalked) << verdict.reason;
  EXPECT_GE(time_of(verdict, "payload_detected").value_or(NAN), 1.2);
  EXPECT_LE(time_of(verdict, "payload_detected").value_or(NAN), 1.35);
  EXPECT_EQ(verdict.false_alarms, 0);
}

}  // namespace
}  // namespace surefoot::run
