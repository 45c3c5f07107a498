#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "firmware/core/stabilizer/attitude_feedback.hpp"
#include "firmware/core/stabilizer/damping.hpp"
#include "firmware/core/stabilizer/foot_tilt.hpp"
#include "firmware/core/stabilizer/soft_landing.hpp"
#include "firmware/core/stabilizer/step_adjustment.hpp"
#include "firmware/core/stabilizer/sway_amplitude.hpp"
#include "firmware/core/stabilizer/tilt_landing_position.hpp"
#include "firmware/core/stabilizer/tilt_over.hpp"
#include "firmware/core/stabilizer/torso_tilt.hpp"
#include "firmware/core/stabilizer/zmp_compensator.hpp"
#include "tests/unit/firmware_core/flat_walk.hpp"

// What every one of the seven earlier controllers and of our three has to keep.
namespace surefoot::stabilizer {
namespace {

/// A controller; `kKeeps`: its output outlives its activity, for it adapts once a step.
template <typename ConfigType, typename StateType, bool kKeepsOutput = false>
struct Of {
  using Config = ConfigType;
  using State = StateType;
  static constexpr bool kKeeps = kKeepsOutput;
};

template <typename Controller>
class EveryEarlierController : public testing::Test {};

using Controllers =
    testing::Types<Of<DampingConfig, DampingState>, Of<ZmpCompensatorConfig, ZmpCompensatorState>,
                   Of<SoftLandingConfig, SoftLandingState>, Of<SwayAmplitudeConfig, SwayAmplitudeState, true>,
                   Of<TorsoTiltConfig, TorsoTiltState, true>, Of<TiltOverConfig, TiltOverState>,
                   Of<TiltLandingPositionConfig, TiltLandingPositionState>,
                   Of<AttitudeFeedbackConfig, AttitudeFeedbackState>, Of<FootTiltConfig, FootTiltState>,
                   Of<StepAdjustmentConfig, StepAdjustmentState>>;
TYPED_TEST_SUITE(EveryEarlierController, Controllers);

/// Every output as one list.
std::array<double, 15> outputs(const Adjustment& a) {
  return {a.pelvis_x_m,         a.pelvis_y_m,        a.pelvis_z_m,        a.leg_length_m[0],
          a.leg_length_m[1],    a.ankle_roll_rad[0], a.ankle_roll_rad[1], a.ankle_pitch_rad[0],
          a.ankle_pitch_rad[1], a.landing_x_m,       a.landing_y_m,       a.sway_m,
          a.sway_centre_x_m,    a.sway_centre_y_m,   a.earlier_landing_s};
}

double largest(const Adjustment& adjustment) {
  double result = 0.0;
  for (const double output : outputs(adjustment)) {
    if (!std::isfinite(output)) return std::numeric_limits<double>::infinity();
    result = std::max(result, std::abs(output));
  }
  return result;
}

double largest_change(const Adjustment& before, const Adjustment& after) {
  double result = 0.0;
  for (std::size_t k = 0; k < outputs(before).size(); ++k) {
    result = std::max(result, std::abs(outputs(after)[k] - outputs(before)[k]));
  }
  return result;
}

/// Adds the same strong deviation from flat walking to every sensor.
void disturb(StabilizerInput& input, double size) {
  input.measured.torso_roll_rad -= 0.08 * size * lateral_sign(input.walk.moving);
  input.measured.torso_pitch_rad += 0.08 * size;
  input.measured.torso_roll_rate_rad_s += 0.3 * size;
  input.measured.torso_pitch_rate_rad_s -= 0.3 * size;
  const double swing = std::sin(12.0 * input.walk.step_time_s);
  input.measured.zmp_x_foot_m += 0.04 * size * swing;
  input.measured.zmp_y_foot_m += 0.04 * size * lateral_sign(input.walk.support()) * (1.0 + 0.5 * swing);
  for (const Side side : kSides) {
    input.ankle[index(side)].roll_moment_nm += 20.0 * size;
    input.ankle[index(side)].pitch_moment_nm -= 20.0 * size;
    input.foot_roll_rad[index(side)] = 0.03 * size;
    input.foot_pitch_rad[index(side)] = -0.03 * size;
  }
}

TYPED_TEST(EveryEarlierController, IsSilentInFlatWalking) {
  typename TypeParam::State state;
  FlatWalk walk{2.0e-3};
  for (int k = 0; k < 2000; ++k) ASSERT_EQ(largest(step(typename TypeParam::Config{}, state, walk.next(), true)), 0.0);
}

TYPED_TEST(EveryEarlierController, ActsOnWhatIsNotFlat) {
  typename TypeParam::State state;
  FlatWalk walk{2.0e-3};
  double most = 0.0;
  for (int k = 0; k < 2000; ++k) {
    StabilizerInput input = walk.next();
    disturb(input, 1.0);
    most = std::max(most, largest(step(typename TypeParam::Config{}, state, input, true)));
  }
  EXPECT_GT(most, 1e-4);
  EXPECT_LT(most, 0.1);
}

// 4 per second is 80 % of a fall from 5 cm, or 0.2 rad, within 50 ms; at 0.5 ms a tick it is 2 mm or 2 mrad.
TYPED_TEST(EveryEarlierController, NeverJumpsWhateverComesIn) {
  std::mt19937 random{7};
  std::uniform_real_distribution<double> size{-2.0, 2.0};
  typename TypeParam::State state;
  FlatWalk walk{0.5e-3};
  Adjustment before;
  bool is_active = true;
  for (int k = 0; k < 8000; ++k) {
    StabilizerInput input = walk.next();
    disturb(input, size(random));
    if (k % 37 == 0) is_active = !is_active;
    if (k % 11 == 0) input.ankle = {};
    if (k % 53 == 0) input.walk.moving = opposite(input.walk.moving);
    const Adjustment now = step(typename TypeParam::Config{}, state, input, is_active);
    ASSERT_LE(largest_change(before, now), 4.0 * 0.5e-3) << k;
    before = now;
  }
}

TYPED_TEST(EveryEarlierController, FadesOnceItMayNotActUnlessItAdaptsOnceAStep) {
  typename TypeParam::State state;
  FlatWalk walk{2.0e-3};
  Adjustment before;
  double most = 0.0;
  for (int k = 0; k < 475 * 3 - 100; ++k) {  // to the last quarter of a swing
    StabilizerInput input = walk.next();
    disturb(input, 1.0);
    before = step(typename TypeParam::Config{}, state, input, true);
    most = std::max(most, largest(before));
  }
  ASSERT_GT(most, 0.0);
  for (int k = 0; k < 475 * 2; ++k) {
    StabilizerInput input = walk.next();
    disturb(input, 1.0);
    before = step(typename TypeParam::Config{}, state, input, false);
  }
  if (TypeParam::kKeeps) {
    EXPECT_GT(largest(before), 0.5 * most);
  } else {
    EXPECT_LT(largest(before), 0.01 * most);
  }
}

/// Every number that a sensor or the pattern puts into the input.
const std::vector<std::function<double&(StabilizerInput&)>> kNumbers{
    [](StabilizerInput& in) -> double& { return in.measured.torso_roll_rad; },
    [](StabilizerInput& in) -> double& { return in.measured.torso_pitch_rad; },
    [](StabilizerInput& in) -> double& { return in.measured.torso_roll_rate_rad_s; },
    [](StabilizerInput& in) -> double& { return in.measured.torso_pitch_rate_rad_s; },
    [](StabilizerInput& in) -> double& { return in.measured.zmp_x_foot_m; },
    [](StabilizerInput& in) -> double& { return in.measured.zmp_y_foot_m; },
    [](StabilizerInput& in) -> double& { return in.nominal.torso_roll_rad; },
    [](StabilizerInput& in) -> double& { return in.nominal.zmp_y_foot_m; },
    [](StabilizerInput& in) -> double& { return in.ankle[0].normal_force_n; },
    [](StabilizerInput& in) -> double& { return in.ankle[1].normal_force_n; },
    [](StabilizerInput& in) -> double& { return in.ankle[0].roll_moment_nm; },
    [](StabilizerInput& in) -> double& { return in.ankle[1].pitch_moment_nm; },
    [](StabilizerInput& in) -> double& { return in.foot_roll_rad[0]; },
    [](StabilizerInput& in) -> double& { return in.foot_pitch_rad[1]; },
    [](StabilizerInput& in) -> double& { return in.walk.step_share; },
    [](StabilizerInput& in) -> double& { return in.walk.step_time_s; },
    [](StabilizerInput& in) -> double& { return in.walk.swing_share; },
    [](StabilizerInput& in) -> double& { return in.body_mass_kg; },
    [](StabilizerInput& in) -> double& { return in.period_s; },
};

TYPED_TEST(EveryEarlierController, GetsOverInputsThatAreNoNumbers) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  for (std::size_t field = 0; field < kNumbers.size(); ++field) {
    for (const double bad : {nan, infinite, -infinite, 1e300}) {
      typename TypeParam::State state;
      typename TypeParam::State unharmed;
      FlatWalk walk{5.0e-3};
      Adjustment adjustment;
      Adjustment wanted;
      for (int k = 0; k < 190 * 20; ++k) {  // foot tilt forgets by the slope's time constant, 2 s
        StabilizerInput input = walk.next();
        disturb(input, 0.5);
        wanted = step(typename TypeParam::Config{}, unharmed, input, true);
        if (k > 250 && k < 300) kNumbers[field](input) = bad;
        adjustment = step(typename TypeParam::Config{}, state, input, true);
        ASSERT_LT(largest(adjustment), 0.2) << field << " " << bad << " " << k;
      }
      // What was learned in the step of the fault is forgotten by 0.9 a step.
      EXPECT_LT(largest_change(adjustment, wanted), TypeParam::kKeeps ? 0.01 : 1e-4) << field << " " << bad;
    }
  }
}

TYPED_TEST(EveryEarlierController, DoesTheSameAtEveryPeriod) {
  std::vector<Adjustment> after;
  for (const double period_s : {0.25e-3, 1.0e-3, 10.0e-3}) {
    typename TypeParam::State state;
    FlatWalk walk{period_s};
    Adjustment adjustment;
    for (double time_s = 0.0; time_s < 2.6; time_s += period_s) {
      StabilizerInput input = walk.next();
      disturb(input, 0.3);
      adjustment = step(typename TypeParam::Config{}, state, input, true);
    }
    after.push_back(adjustment);
  }
  EXPECT_LT(largest_change(after[0], after[1]), 5e-4);
  EXPECT_LT(largest_change(after[0], after[2]), 5e-3);
}

}  // namespace
}  // namespace surefoot::stabilizer
