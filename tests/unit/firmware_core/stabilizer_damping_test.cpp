#include <gtest/gtest.h>

#include <complex>
#include <vector>

#include "firmware/core/stabilizer/damping.hpp"
#include "tests/unit/firmware_core/compliant_ankle.hpp"
#include "tests/unit/firmware_core/flat_walk.hpp"

namespace surefoot::stabilizer {
namespace {

// T(s) / U(s) = -K (s^2 - g/l) / (s^2 + K/(m l^2) - g/l), the transfer function of the compliant ankle: the plant of
// these tests has it. Below the mode the moment follows the command in phase, near it in opposite phase.
TEST(CompliantAnklePlant, HasThePrintedTransferFunction) {
  for (const double omega_rad_s : {1.0, 5.0, 10.0, 30.0}) {
    CompliantAnkle plant;
    const double s2 = -omega_rad_s * omega_rad_s;
    const double unstable = CompliantAnkle::kGravity_m_s2 / CompliantAnkle::kLength_m;
    const double gain = -plant.stiffness_nm_per_rad * (s2 - unstable) / (s2 + plant.spring_per_s2() - unstable);
    // The undamped plant has no steady state that it finds by itself: it starts in it.
    const double lean_gain = plant.spring_per_s2() / (s2 + plant.spring_per_s2() - unstable);
    plant.rate_rad_s = 0.01 * lean_gain * omega_rad_s;
    const double period_s = 1.0e-5;
    for (int k = 0; k < 40000; ++k) {
      const double time_s = k * period_s;
      const double command_rad = 0.01 * std::sin(omega_rad_s * time_s);
      ASSERT_NEAR(plant.moment_nm(command_rad), gain * command_rad, 0.002 * std::abs(gain) * 0.01) << omega_rad_s;
      plant.advance(0.01 * std::sin(omega_rad_s * (time_s + 0.5 * period_s)), period_s);
    }
  }
}

/// Roll of a robot on its right foot, led by the controller; the command reaches the plant `delay_ticks` later.
struct Closed {
  DampingConfig config;
  DampingState state;
  CompliantAnkle plant;
  double period_s = 1.0e-3;
  std::vector<double> on_the_way;

  void tick(bool is_pitch = false) {
    StabilizerInput input = standing_on(Side::kRight, period_s);
    const double applied_rad = on_the_way.front();
    is_pitch ? lean_back(input, plant, applied_rad) : lean_left(input, plant, applied_rad);
    const Adjustment adjustment = step(config, state, input, true);
    on_the_way.erase(on_the_way.begin());
    on_the_way.push_back(is_pitch ? adjustment.ankle_pitch_rad[0] : adjustment.ankle_roll_rad[0]);
    plant.advance(on_the_way.front(), period_s);
  }
};

// kd = 2 zeta wn / (K / m l^2) = 0.122 s for zeta 0.5 at K = 2450 N m/rad; a free swing then goes through zero to
// exp(-pi zeta / sqrt(1 - zeta^2)) = 16.3 % on the other side. An estimate without the command, T / K alone, would not.
TEST(Damping, DampsByHalfOfCriticalWithAnEstimateThatLacksNothing) {
  Closed loop;
  const double gain_s = 2.0 * 0.5 * loop.plant.mode_rad_s() / loop.plant.spring_per_s2();
  EXPECT_NEAR(gain_s, 0.122, 5e-4);
  EXPECT_NEAR(loop.plant.mode_rad_s(), 6.57, 5e-3);
  loop.period_s = 1.0e-4;
  loop.config = {
      .gain_s = gain_s, .time_constant_s = 2e-4, .command_lag_s = 0.0, .smoothing_s = 2e-4, .max_angle_rad = 1.0};
  loop.on_the_way = {0.0};
  loop.plant.lean_rad = 0.02;
  double lowest_rad = 0.0;
  for (int k = 0; k < 10000; ++k) {
    loop.tick();
    lowest_rad = std::min(lowest_rad, loop.plant.lean_rad);
  }
  EXPECT_NEAR(-lowest_rad / 0.02, 0.163, 0.005);
}

TEST(Damping, DampsBothAxesAsItIsSetWithAPeriodOfTenMillisecondsAndACycleOfLatency) {
  for (const bool is_pitch : {false, true}) {
    Closed loop;
    loop.period_s = 0.01;
    loop.on_the_way = {0.0, 0.0};
    loop.plant.lean_rad = 0.02;
    const double before = loop.plant.energy();
    for (int k = 0; k < 300; ++k) loop.tick(is_pitch);
    EXPECT_LT(loop.plant.energy(), 0.2 * before) << is_pitch;
  }
}

TEST(Damping, StaysWithinItsLimitAndOnTheSupportingFoot) {
  DampingState state;
  StabilizerInput input = standing_on(Side::kLeft, 1.0e-3);
  double largest_rad = 0.0;
  for (int k = 0; k < 500; ++k) {
    input.measured.zmp_y_foot_m = std::sin(0.02 * k);
    const Adjustment adjustment = step({}, state, input, true);
    largest_rad = std::max(largest_rad, std::abs(adjustment.ankle_roll_rad[index(Side::kLeft)]));
    EXPECT_EQ(adjustment.ankle_roll_rad[index(Side::kRight)], 0.0);
  }
  EXPECT_LE(largest_rad, DampingConfig{}.max_angle_rad);
  EXPECT_GT(largest_rad, 0.5 * DampingConfig{}.max_angle_rad);
}

// The moment of a new supporting foot is another's: its first value is a place to start from, not a rate.
TEST(Damping, TakesNoRateFromAChangeOfTheSupportingFoot) {
  DampingState state;
  StabilizerInput right = standing_on(Side::kRight, 1.0e-3);
  right.measured.zmp_y_foot_m = 0.03;
  for (int k = 0; k < 2000; ++k) (void)step({}, state, right, true);
  StabilizerInput left = standing_on(Side::kLeft, 1.0e-3);
  left.measured.zmp_y_foot_m = -0.03;
  for (int k = 0; k < 100; ++k) EXPECT_NEAR(step({}, state, left, true).ankle_roll_rad[1], 0.0, 1e-6);
}

TEST(Damping, KnowsNoMomentOfAFootThatDoesNotCarry) {
  DampingState state;
  StabilizerInput input = standing_on(Side::kLeft, 1.0e-3);
  input.ankle[index(Side::kLeft)].normal_force_n = 48.0;
  for (int k = 0; k < 100; ++k) {
    input.measured.zmp_y_foot_m = 0.001 * k;
    EXPECT_EQ(step({}, state, input, true).ankle_roll_rad[1], 0.0);
  }
}

}  // namespace
}  // namespace surefoot::stabilizer
