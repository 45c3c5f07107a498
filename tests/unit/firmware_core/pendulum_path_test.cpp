#include "firmware/core/gait/pendulum_path.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace surefoot::gait {
namespace {

constexpr double kRate = 3.83;
constexpr double kStep_s = 0.95;

TEST(PendulumPath, BeginsAndEndsWhereAndAsFastAsItShall) {
  const PathPoint begin{0.02, 0.1};
  const PathPoint end{0.13, -0.05};
  const PendulumPath path(begin, end, kStep_s, kRate);
  EXPECT_NEAR(path.at(0.0).position_m, begin.position_m, 1e-12);
  EXPECT_NEAR(path.at(0.0).velocity_m_s, begin.velocity_m_s, 1e-12);
  EXPECT_NEAR(path.at(kStep_s).position_m, end.position_m, 1e-12);
  EXPECT_NEAR(path.at(kStep_s).velocity_m_s, end.velocity_m_s, 1e-12);
}

// x'' = w^2 (x - p), with x'' by differences.
TEST(PendulumPath, IsThatOfAPendulumOnItsPressureCentre) {
  const PendulumPath path({0.0, 0.0}, {0.1, 0.4}, kStep_s, kRate);
  constexpr double h = 1e-4;
  for (double t = 0.1; t < kStep_s; t += 0.1) {
    const double x = path.at(t).position_m;
    const double acceleration = (path.at(t + h).position_m - 2.0 * x + path.at(t - h).position_m) / (h * h);
    EXPECT_NEAR(acceleration, kRate * kRate * (x - path.pressure_centre_m(t)), 1e-5) << t;
    EXPECT_NEAR((path.at(t + h).position_m - path.at(t - h).position_m) / (2.0 * h), path.at(t).velocity_m_s, 1e-7);
  }
}

// x = d sinh(w (t - T/2)) / (2 sinh(w T / 2)): the steady walk rests on the foot.
TEST(PendulumPath, OfTheSteadyWalkRestsOnTheFoot) {
  constexpr double length_m = 0.2;
  const double half = 0.5 * kRate * kStep_s;
  const double speed = 0.5 * length_m * kRate / std::tanh(half);
  const PendulumPath path({-0.5 * length_m, speed}, {0.5 * length_m, speed}, kStep_s, kRate);
  for (double t = 0.0; t <= kStep_s; t += 0.095) {
    EXPECT_NEAR(path.pressure_centre_m(t), 0.0, 1e-12);
    EXPECT_NEAR(path.at(t).position_m, length_m * std::sinh(kRate * (t - 0.5 * kStep_s)) / (2.0 * std::sinh(half)),
                1e-12);
  }
}

TEST(PendulumPath, StaysWhereItIsToGoNowhere) {
  const PendulumPath path({0.03, 0.0}, {0.03, 0.0}, kStep_s, kRate);
  for (double t = 0.0; t <= kStep_s; t += 0.1) EXPECT_NEAR(path.at(t).position_m, 0.03, 1e-12);
}

}  // namespace
}  // namespace surefoot::gait
