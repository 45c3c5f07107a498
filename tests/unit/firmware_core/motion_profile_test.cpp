#include "firmware/core/gait/motion_profile.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace surefoot::gait {
namespace {

TEST(Ramp, MovesAtConstantSpeedBetweenItsEndsAndRestsOutside) {
  EXPECT_EQ(ramp(1.0, 3.0, 0.5, -1.0e-9).position, 1.0);
  EXPECT_EQ(ramp(1.0, 3.0, 0.5, -1.0e-9).velocity, 0.0);
  EXPECT_EQ(ramp(1.0, 3.0, 0.5, 0.0).position, 1.0);
  EXPECT_DOUBLE_EQ(ramp(1.0, 3.0, 0.5, 0.0).velocity, 4.0);
  EXPECT_DOUBLE_EQ(ramp(1.0, 3.0, 0.5, 0.125).position, 1.5);
  EXPECT_EQ(ramp(1.0, 3.0, 0.5, 0.5).position, 3.0);
  EXPECT_EQ(ramp(1.0, 3.0, 0.5, 0.5).velocity, 0.0);
}

// The approach to the end is extrapolated from inside, so that a clamp at the end cannot hide a wrong coefficient.
TEST(Quintic, StartsAndEndsAsAskedToTwelveDigits) {
  const ScalarMotion start{0.12, -0.4, 3.0};
  constexpr double kEnd = -0.05;
  constexpr double kDuration_s = 0.1;
  const ScalarMotion first = quintic(start, kEnd, kDuration_s, 1.0e-15);
  EXPECT_NEAR(first.position, start.position, 1.0e-12);
  EXPECT_NEAR(first.velocity, start.velocity, 1.0e-12);
  EXPECT_NEAR(first.acceleration, start.acceleration, 1.0e-9);
  const ScalarMotion last = quintic(start, kEnd, kDuration_s, std::nextafter(kDuration_s, 0.0));
  EXPECT_NEAR(last.position, kEnd, 1.0e-12);
  EXPECT_NEAR(last.velocity, 0.0, 1.0e-12);
  EXPECT_NEAR(last.acceleration, 0.0, 1.0e-9);
  EXPECT_EQ(quintic(start, kEnd, kDuration_s, 1.0).position, kEnd);
  EXPECT_EQ(quintic(start, kEnd, kDuration_s, -1.0).position, start.position);
}

// The coefficients as the derivation states them, in seconds rather than in shares of the duration.
TEST(Quintic, FollowsTheCoefficientsOfTheDerivation) {
  const double p0 = 0.2, v0 = 0.3, a0 = -1.5, p1 = 0.26, T = 0.2;
  const double D = p1 - p0 - v0 * T - 0.5 * a0 * T * T, V = -v0 - a0 * T, A = -a0;
  const double c3 = (20.0 * D - 8.0 * V * T + A * T * T) / (2.0 * T * T * T);
  const double c4 = (-30.0 * D + 14.0 * V * T - 2.0 * A * T * T) / (2.0 * T * T * T * T);
  const double c5 = (12.0 * D - 6.0 * V * T + A * T * T) / (2.0 * T * T * T * T * T);
  for (double t = 0.01; t < T; t += 0.01) {
    const ScalarMotion now = quintic({p0, v0, a0}, p1, T, t);
    const double t2 = t * t, t3 = t2 * t, t4 = t3 * t, t5 = t4 * t;
    EXPECT_NEAR(now.position, p0 + v0 * t + 0.5 * a0 * t2 + c3 * t3 + c4 * t4 + c5 * t5, 1.0e-12);
    EXPECT_NEAR(now.velocity, v0 + a0 * t + 3.0 * c3 * t2 + 4.0 * c4 * t3 + 5.0 * c5 * t4, 1.0e-11);
    EXPECT_NEAR(now.acceleration, a0 + 6.0 * c3 * t + 12.0 * c4 * t2 + 20.0 * c5 * t3, 1.0e-10);
  }
}

TEST(RestToRest, IsTheQuinticWithoutStartSpeed) {
  for (double u = 0.0; u <= 1.0; u += 0.05) {
    const ScalarMotion s = rest_to_rest(u);
    const ScalarMotion q = quintic({}, 1.0, 1.0, u);
    EXPECT_NEAR(s.position, u * u * u * (10.0 - 15.0 * u + 6.0 * u * u), 1.0e-14);
    EXPECT_NEAR(s.position, q.position, 1.0e-12);
    EXPECT_NEAR(s.velocity, q.velocity, 1.0e-12);
    EXPECT_NEAR(s.acceleration, q.acceleration, 1.0e-11);
  }
  EXPECT_EQ(rest_to_rest(-1.0).position, 0.0);
  EXPECT_EQ(rest_to_rest(2.0).position, 1.0);
  EXPECT_EQ(rest_to_rest(2.0).velocity, 0.0);
}

}  // namespace
}  // namespace surefoot::gait
