#include "firmware/core/gait/lateral_pendulum.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace surefoot::gait {
namespace {

constexpr double kFoot_m = 0.071;
constexpr double kHeight_m = 0.67;
constexpr double kGravity_m_s2 = 9.81;
constexpr double kSingle_s = 0.7;
constexpr double kDouble_s = 0.25;

double natural_rate_rad_s() { return std::sqrt(kGravity_m_s2 / kHeight_m); }

LateralPendulum pendulum() { return {kFoot_m, natural_rate_rad_s(), kSingle_s, kDouble_s}; }

double pressure_centre_m(const ScalarMotion& com) {
  return com.position - kHeight_m / kGravity_m_s2 * com.acceleration;
}

void expect_equal(const ScalarMotion& a, const ScalarMotion& b) {
  EXPECT_NEAR(a.position, b.position, 1e-12);
  EXPECT_NEAR(a.velocity, b.velocity, 1e-11);
  EXPECT_NEAR(a.acceleration, b.acceleration, 1e-10);
}

TEST(LateralPendulum, RestsItsPressureCentreUnderTheFootThatCarries) {
  for (double time_s = kDouble_s + 1e-9; time_s < kDouble_s + kSingle_s; time_s += 0.01) {
    EXPECT_NEAR(pressure_centre_m(pendulum().at(time_s)), kFoot_m, 1e-12);
  }
}

TEST(LateralPendulum, MovesItsPressureCentreFromFootToFootInDoubleSupport) {
  EXPECT_NEAR(pressure_centre_m(pendulum().at(0.0)), -kFoot_m, 1e-10);
  EXPECT_NEAR(pressure_centre_m(pendulum().at(0.5 * kDouble_s)), 0.0, 1e-12);
  EXPECT_NEAR(pressure_centre_m(pendulum().at(kDouble_s)), kFoot_m, 1e-10);
}

TEST(LateralPendulum, JoinsItsSupportsWithoutAStep) {
  expect_equal(pendulum().at(kDouble_s), pendulum().at(kDouble_s + 1e-15));
  const ScalarMotion end = pendulum().at(kDouble_s + kSingle_s);
  expect_equal({-end.position, -end.velocity, -end.acceleration}, pendulum().at(0.0));
}

TEST(LateralPendulum, HasDerivativesThatAreThoseOfItsPath) {
  constexpr double kStep_s = 1e-5;
  for (const double time_s : {-1.3, -0.4, 0.03, 0.2, 0.3, 0.6, 0.94}) {
    const ScalarMotion before = pendulum().at(time_s - kStep_s);
    const ScalarMotion after = pendulum().at(time_s + kStep_s);
    EXPECT_NEAR((after.position - before.position) / (2.0 * kStep_s), pendulum().at(time_s).velocity, 1e-7);
    EXPECT_NEAR((after.velocity - before.velocity) / (2.0 * kStep_s), pendulum().at(time_s).acceleration, 1e-6);
  }
}

TEST(LateralPendulum, WentBeforeItsBeginAsItGoesOn) {
  const double step_s = kDouble_s + kSingle_s;
  for (const double time_s : {0.1, 0.4, 0.9}) {
    const ScalarMotion now = pendulum().at(time_s);
    expect_equal(pendulum().at(time_s - step_s), {-now.position, -now.velocity, -now.acceleration});
    expect_equal(pendulum().at(time_s - 2.0 * step_s), now);
  }
}

TEST(LateralPendulum, SwaysFurthestInTheMiddleOfSingleSupport) {
  const ScalarMotion middle = pendulum().at(kDouble_s + 0.5 * kSingle_s);
  EXPECT_NEAR(middle.position, pendulum().amplitude_m(), 1e-15);
  EXPECT_NEAR(middle.velocity, 0.0, 1e-12);
  EXPECT_LT(pendulum().amplitude_m(), kFoot_m);
}

}  // namespace
}  // namespace surefoot::gait
