#include <gtest/gtest.h>

#include "firmware/core/stabilizer/torso_tilt.hpp"
#include "tests/unit/firmware_core/compliant_ankle.hpp"
#include "tests/unit/firmware_core/flat_walk.hpp"

namespace surefoot::stabilizer {
namespace {

// 2 mm for each degree of the step's mean, to the left of a lean to the right, back from a lean forward.
TEST(TorsoTilt, MovesTheCentreAgainstTheMeanLeanOfAStep) {
  TorsoTiltState state;
  TorsoTiltConfig config;
  config.band_rad = 0.0;
  FlatWalk walk{5.0e-3};
  for (int k = 0; k < 191; ++k) {
    StabilizerInput input = walk.next();
    const double ripple_rad = 0.05 * std::sin(2.0 * M_PI * input.walk.step_share);
    input.measured.torso_roll_rad += M_PI / 180.0 + ripple_rad;
    input.measured.torso_pitch_rad += M_PI / 360.0 + ripple_rad;
    (void)step(config, state, input, true);
  }
  EXPECT_NEAR(state.learned_y_m, 0.002, 2e-5);
  EXPECT_NEAR(state.learned_x_m, -0.001, 2e-5);
}

// A floor that tilts the body by e0 at rest: the pelvis moved by c leans it by 1.253 c / l to the other side, so the
// tilt ends at e0 / (1 + 1.253 / l * gain / (1 - kept)).
TEST(TorsoTilt, LessensAConstantTiltAsMuchAsTheFixedPointSays) {
  const double lean_per_m = 1.2532 / CompliantAnkle::kLength_m;
  TorsoTiltConfig config;
  config.band_rad = 0.0;
  for (const double tilt_rad : {0.02, -0.03}) {
    TorsoTiltState state;
    FlatWalk walk{5.0e-3};
    double roll_rad = 0.0;
    double pitch_rad = 0.0;
    for (int k = 0; k < 190 * 30; ++k) {
      StabilizerInput input = walk.next();
      roll_rad = tilt_rad - lean_per_m * state.centre_y_m;   // left is against roll
      pitch_rad = tilt_rad + lean_per_m * state.centre_x_m;  // forward is with pitch
      input.measured.torso_roll_rad += roll_rad;
      input.measured.torso_pitch_rad += pitch_rad;
      (void)step(config, state, input, true);
    }
    const double left_rad = tilt_rad / (1.0 + lean_per_m * config.gain_m_per_rad / (1.0 - config.kept_share));
    EXPECT_NEAR(roll_rad, left_rad, 0.01 * std::abs(tilt_rad));
    EXPECT_NEAR(pitch_rad, left_rad, 0.01 * std::abs(tilt_rad));
  }
}

TEST(TorsoTilt, StaysWithinItsLimitAndKeepsWhatItHasWhileInactive) {
  TorsoTiltState state;
  FlatWalk walk{5.0e-3};
  Adjustment adjustment;
  for (int k = 0; k < 190 * 12; ++k) {
    StabilizerInput input = walk.next();
    input.measured.torso_roll_rad += 0.3;
    input.measured.torso_pitch_rad += 0.3;
    adjustment = step({}, state, input, k < 190 * 8);
  }
  EXPECT_NEAR(adjustment.sway_centre_y_m, 0.02, 1e-9);
  EXPECT_NEAR(adjustment.sway_centre_x_m, -0.02, 1e-9);
}

}  // namespace
}  // namespace surefoot::stabilizer
