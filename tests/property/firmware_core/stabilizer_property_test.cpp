#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>

#include "firmware/core/stabilizer/stabilizer.hpp"

namespace surefoot::stabilizer {
namespace {

double within(double min, double max) { return min + (max - min) * *rc::gen::inRange(0, 10001) * 1e-4; }

/// Any stage with any flags, and sensors anywhere in their ranges: contact chatters, signs flip from tick to tick.
StabilizerInput any_input(double period_s) {
  StabilizerInput input;
  WalkView& walk = input.walk;
  walk.stage = *rc::gen::elementOf(decision::kWalkStages);
  walk.moving = decision::moving_foot(walk.stage);
  walk.is_double_support = *rc::gen::arbitrary<bool>();
  walk.has_landed = *rc::gen::arbitrary<bool>();
  walk.is_waiting = *rc::gen::arbitrary<bool>();
  walk.swing_share = within(0.0, 1.0);
  walk.step_share = within(0.0, 1.0);
  walk.step_time_s = within(0.0, 0.95);
  for (PhaseSample* sample : {&input.measured, &input.nominal}) {
    sample->torso_roll_rad = within(-0.3, 0.3);
    sample->torso_pitch_rad = within(-0.3, 0.3);
    sample->support_roll_rate_rad_s = within(-1.7, 1.7);
  }
  for (const Side side : kSides) {
    input.ankle[index(side)].normal_force_n = within(-10.0, 1000.0);
    input.ankle[index(side)].roll_moment_nm = within(-60.0, 60.0);
    input.foot_roll_rad[index(side)] = within(-0.26, 0.26);
    input.foot_lateral_force_m_s2[index(side)] = within(-20.0, 20.0);
  }
  input.period_s = period_s;
  return input;
}

struct Bound {
  double Adjustment::*value;
  double max_rate_per_s;
};

struct SideBound {
  PerSide<double> Adjustment::*value;
  double max_rate_per_s;
};

/// Of the six new controllers together; the shock absorber moves with at most 1000 N / (1500 N s/m).
constexpr std::array kBounds{Bound{&Adjustment::pelvis_z_m, 1.0}, Bound{&Adjustment::landing_y_m, 1.3},
                             Bound{&Adjustment::earlier_landing_s, 2.0 + 1e-9}};
constexpr std::array kSideBounds{SideBound{&Adjustment::leg_length_m, 0.1}, SideBound{&Adjustment::ankle_roll_rad, 1.2},
                                 SideBound{&Adjustment::ankle_pitch_rad, 0.7},
                                 SideBound{&Adjustment::hip_roll_rad, 0.7}};

RC_GTEST_PROP(NewControllers, NeverJumpWhateverTheyAreTold, ()) {
  StabilizerConfig config;
  for (const Controller controller :
       {Controller::kUprightPose, Controller::kLandingMomentum, Controller::kShockAbsorber, Controller::kLandingTiming,
        Controller::kLandingPosition, Controller::kVibrationReduction}) {
    config.is_on[static_cast<std::size_t>(controller)] = true;
  }
  const double period_s = *rc::gen::element(0.25e-3, 1e-3, 10e-3);
  StabilizerState state;
  Adjustment before;
  StabilizerInput input = any_input(period_s);
  for (int tick = 0; tick < 200; ++tick) {
    if (tick % 8 == 0) input = any_input(period_s);
    const Adjustment now = step(config, state, input).total;
    for (const Bound& bound : kBounds) {
      RC_ASSERT(std::abs(now.*bound.value - before.*bound.value) <= bound.max_rate_per_s * period_s);
    }
    for (const SideBound& bound : kSideBounds) {
      for (const Side side : kSides) {
        const double change = (now.*bound.value)[index(side)] - (before.*bound.value)[index(side)];
        RC_ASSERT(std::abs(change) <= bound.max_rate_per_s * period_s);
      }
    }
    before = now;
  }
}

}  // namespace
}  // namespace surefoot::stabilizer
