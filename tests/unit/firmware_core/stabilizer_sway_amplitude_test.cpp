#include <gtest/gtest.h>

#include "firmware/core/stabilizer/sway_amplitude.hpp"
#include "tests/unit/firmware_core/flat_walk.hpp"

namespace surefoot::stabilizer {
namespace {

/// Walks with a ZMP that lies `outwards_m` further out than on flat floor; returns the last output.
double walk(const SwayAmplitudeConfig& config, SwayAmplitudeState& state, double outwards_m, int steps,
            bool is_active = true) {
  FlatWalk walk{5.0e-3};
  double sway_m = 0.0;
  for (int k = 0; k < 190 * steps + 1; ++k) {
    StabilizerInput input = walk.next();
    input.measured.zmp_y_foot_m += outwards_m * lateral_sign(input.walk.support());
    sway_m = step(config, state, input, is_active).sway_m;
  }
  return sway_m;
}

// A <- A + Ka (Y_ref - Y) / (1 + l w^2 / g), here with 13 mm: 10 beyond the band, on either foot.
TEST(SwayAmplitude, SwaysLessByTheFormulaWhenTheZmpIsTooFarOut) {
  SwayAmplitudeState state;
  const SwayAmplitudeConfig config;
  (void)walk(config, state, 0.013, 1);
  EXPECT_NEAR(state.learned_m, -0.05 * 0.010 / 2.0, 1e-9);
  SwayAmplitudeState other;
  (void)walk(config, other, -0.013, 2);
  EXPECT_NEAR(other.learned_m, (1.0 + config.kept_share) * 0.05 * 0.010 / 2.0, 1e-9);
}

TEST(SwayAmplitude, LooksAtTheZmpOfASingleSupportAlone) {
  SwayAmplitudeState state;
  FlatWalk walk{5.0e-3};
  for (int k = 0; k < 500; ++k) {
    StabilizerInput input = walk.next();
    if (input.walk.is_double_support) input.measured.zmp_y_foot_m += 0.2 * lateral_sign(input.walk.support());
    EXPECT_EQ(step({}, state, input, true).sway_m, 0.0);
  }
}

TEST(SwayAmplitude, KeepsTheSumWithinItsBounds) {
  SwayAmplitudeConfig config;
  config.gain = 10.0;
  SwayAmplitudeState state;
  EXPECT_NEAR(walk(config, state, 0.2, 8), 0.02 - 0.06, 1e-5);
  EXPECT_NEAR(walk(config, state, -0.2, 8), 0.07 - 0.06, 1e-5);
}

TEST(SwayAmplitude, NeverPushesAPatternOverABoundThatThePatternItselfIsBeyond) {
  SwayAmplitudeConfig config;
  config.pattern_sway_m = 0.08;
  SwayAmplitudeState state;
  EXPECT_LE(walk(config, state, -0.1, 5), 0.0);
  EXPECT_EQ(walk(config, state, 0.0, 0), state.added_sway_m);
}

TEST(SwayAmplitude, LearnsNothingWhileInactiveAndKeepsWhatItHas) {
  SwayAmplitudeState state;
  EXPECT_EQ(walk({}, state, 0.05, 3, false), 0.0);
  (void)walk({}, state, 0.05, 3);
  const double learned_m = state.learned_m;
  EXPECT_LT(learned_m, 0.0);
  EXPECT_NEAR(walk({}, state, 0.0, 5, false), learned_m, 1e-9);
}

TEST(SwayAmplitude, ForgetsOnFlatFloor) {
  SwayAmplitudeState state;
  (void)walk({}, state, 0.05, 5);
  const double learned_m = state.learned_m;
  (void)walk({}, state, 0.0, 11);
  EXPECT_LT(std::abs(state.learned_m), 0.4 * std::abs(learned_m));
}

}  // namespace
}  // namespace surefoot::stabilizer
