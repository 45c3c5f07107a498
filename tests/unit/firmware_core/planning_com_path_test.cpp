#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "firmware/core/planning/com_path.hpp"

namespace surefoot::planning {
namespace {

using gait::ScalarMotion;

GaitFactors gait_of(double height_m, double share, double single_support_s) {
  GaitFactors gait{.com_height_m = height_m,
                   .step_length_m = 0.5,
                   .single_support_share = share,
                   .single_support_s = single_support_s,
                   .double_support_s = 0.0};
  gait.double_support_s = continuous_double_support_s(gait);
  return gait;
}

/// T_d by eq. (16), from positions and velocities at both ends.
double by_arc_cosine_s(const GaitFactors& gait) {
  const double length_m = (1.0 - gait.single_support_share) * gait.com_height_m / gait.single_support_share;
  const double rate = natural_rate_rad_s(length_m);
  const double half_way_m = gait.double_support_half_way_m();
  const double velocity_m_s = com_in_single_support(gait, gait.single_support_s).velocity;
  const double square = velocity_m_s * velocity_m_s / rate;
  return std::acos((square - rate * half_way_m * half_way_m) / (square + rate * half_way_m * half_way_m)) / rate;
}

// Al-Shuka et al. 2014, tables 2 and 3; their 0.7557 and 0.5757 are digits of 0.7575 in another order.
TEST(GaitFactors, GiveThePrintedDurationsOfDoubleSupport) {
  EXPECT_NEAR(gait_of(0.85, 0.7561, 0.5).double_support_s, 0.12500, 1e-5);
  EXPECT_NEAR(gait_of(0.88, 0.7575, 0.5).double_support_s, 0.12498, 1e-5);
  EXPECT_NEAR(gait_of(0.88, 0.7561, 0.5).double_support_s, 0.12589, 1e-5);
  EXPECT_NEAR(gait_of(0.88, 0.7557, 0.5).double_support_s, 0.12616, 1e-5);
  EXPECT_NEAR(gait_of(0.88, 0.5757, 0.5).double_support_s, 0.27272, 1e-5);
  EXPECT_NEAR(gait_of(0.86, 0.6203, 1.2).double_support_s, 0.29981, 1e-5);
}

TEST(GaitFactors, AgreeWithEquationSixteenForEveryStepLength) {
  for (const double share : {0.3, 0.6, 0.9}) {
    for (const double length_m : {0.1, 0.5, 1.0}) {
      GaitFactors gait = gait_of(0.86, share, 0.8);
      gait.step_length_m = length_m;
      EXPECT_NEAR(by_arc_cosine_s(gait), gait.double_support_s, 1e-12);
    }
  }
}

TEST(GaitFactors, FindTheShareOfAFifthOfTheTimeInDoubleSupport) {
  EXPECT_NEAR(*continuous_single_support_share(0.85, 0.5, 0.125), 0.75610, 1e-5);
  EXPECT_NEAR(*continuous_single_support_share(0.88, 0.5, 0.125), 0.75747, 1e-5);
  EXPECT_NEAR(*continuous_single_support_share(0.86, 1.2, 0.3), 0.62013, 1e-5);
  EXPECT_NEAR(*continuous_single_support_share(0.88, 0.5, gait_of(0.88, 0.31, 0.5).double_support_s), 0.31, 1e-12);
}

TEST(GaitFactors, FindNoShareForWhatIsNoDuration) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(continuous_single_support_share(kNan, 0.5, 0.1));
  EXPECT_FALSE(continuous_single_support_share(0.85, -0.5, 0.1));
  EXPECT_FALSE(continuous_single_support_share(0.85, 0.5, 0.0));
  EXPECT_FALSE(continuous_single_support_share(0.85, std::numeric_limits<double>::infinity(), 0.1));
  EXPECT_FALSE(continuous_single_support_share(0.85, 0.5, 1e9)) << "no share is that small";
}

TEST(GaitFactors, AskForTheFrictionOfTheLargestAcceleration) {
  for (const GaitFactors& gait : {gait_of(0.88, 0.7575, 0.5), gait_of(0.86, 0.6203, 1.2)}) {
    double largest_m_s2 = 0.0;
    for (int i = 0; i <= 1000; ++i) {
      const double share = 0.001 * i;
      const double single = com_in_single_support(gait, share * gait.single_support_s).acceleration;
      const double both =
          com_in_double_support(ComMethod::kSharedPressure, gait, share * gait.double_support_s).acceleration;
      largest_m_s2 = std::max({largest_m_s2, std::abs(single), std::abs(both)});
    }
    EXPECT_NEAR(least_friction(gait), largest_m_s2 / 9.81, 1e-9);
  }
  EXPECT_NEAR(least_friction(gait_of(0.88, 0.7575, 0.5)), 0.2152, 1e-4);
  EXPECT_NEAR(least_friction(gait_of(0.86, 0.6203, 1.2)), 0.1803, 1e-4);
}

TEST(ComPath, IsTheSameByTheFirstTwoMethods) {
  const GaitFactors gait = gait_of(0.88, 0.7575, 0.5);
  for (int i = 0; i <= 100; ++i) {
    const double time_s = 0.01 * i * gait.double_support_s;
    const ScalarMotion shared = com_in_double_support(ComMethod::kSharedPressure, gait, time_s);
    const ScalarMotion hanging = com_in_double_support(ComMethod::kHangingPendulum, gait, time_s);
    EXPECT_NEAR(shared.position, hanging.position, 1e-12);
    EXPECT_NEAR(shared.velocity, hanging.velocity, 1e-12);
    EXPECT_NEAR(shared.acceleration, hanging.acceleration, 1e-12);
  }
}

TEST(ComPath, JoinsTheSupportsUpToTheAcceleration) {
  for (const ComMethod method :
       {ComMethod::kSharedPressure, ComMethod::kHangingPendulum, ComMethod::kMirroredAcceleration}) {
    for (GaitFactors gait : {gait_of(0.88, 0.7561, 0.5), gait_of(0.86, 0.6203, 1.2), gait_of(0.6, 0.4, 0.9)}) {
      if (method == ComMethod::kMirroredAcceleration) gait.double_support_s = mirrored_double_support_s(gait);
      const double half_m = 0.5 * gait.step_length_m;  // from an ankle to the middle between them
      const ScalarMotion single_end = com_in_single_support(gait, gait.single_support_s);
      const ScalarMotion begin = com_in_double_support(method, gait, 0.0);
      EXPECT_NEAR(begin.position + half_m, single_end.position, 1e-12);
      EXPECT_NEAR(begin.velocity, single_end.velocity, 1e-12);
      EXPECT_NEAR(begin.acceleration, single_end.acceleration, 1e-12);
      const ScalarMotion single_begin = com_in_single_support(gait, 0.0);
      const ScalarMotion end = com_in_double_support(method, gait, gait.double_support_s);
      EXPECT_NEAR(end.position - half_m, single_begin.position, 1e-12);
      EXPECT_NEAR(end.velocity, single_begin.velocity, 1e-12);
      EXPECT_NEAR(end.acceleration, single_begin.acceleration, 1e-12);
    }
  }
}

TEST(ComPath, IsTheIntegralOfItsDerivatives) {
  const GaitFactors gait = gait_of(0.88, 0.7575, 0.5);
  constexpr double kStep_s = 1e-5;
  for (const ComMethod method : {ComMethod::kSharedPressure, ComMethod::kMirroredAcceleration}) {
    for (const double time_s : {0.02, 0.06, 0.1}) {
      const ScalarMotion before = com_in_double_support(method, gait, time_s - kStep_s);
      const ScalarMotion now = com_in_double_support(method, gait, time_s);
      const ScalarMotion after = com_in_double_support(method, gait, time_s + kStep_s);
      EXPECT_NEAR((after.position - before.position) / (2.0 * kStep_s), now.velocity, 1e-6);
      EXPECT_NEAR((after.velocity - before.velocity) / (2.0 * kStep_s), now.acceleration, 1e-6);
    }
  }
}

TEST(ComPath, KeepsThePressureCentreAtTheAnkleAndTakesItFromOneToTheOther) {
  const GaitFactors gait = gait_of(0.88, 0.7575, 0.5);
  for (const double share : {0.0, 0.3, 1.0}) {
    EXPECT_NEAR(ideal_zmp_m(gait, com_in_single_support(gait, share * gait.single_support_s)), 0.0, 1e-12);
    const ScalarMotion both = com_in_double_support(ComMethod::kSharedPressure, gait, share * gait.double_support_s);
    EXPECT_NEAR(ideal_zmp_m(gait, both), both.position / (1.0 - gait.single_support_share), 1e-12) << "eq. (14)";
  }
  const ScalarMotion begin = com_in_double_support(ComMethod::kSharedPressure, gait, 0.0);
  EXPECT_NEAR(ideal_zmp_m(gait, begin), -0.5 * gait.step_length_m, 1e-12);
}

// The paper finds the same result with all three. That holds for its fast gait only.
TEST(ComPath, DiffersByTheThirdMethodLittleInAFastGaitAndMoreInASlowOne) {
  const GaitFactors fast = gait_of(0.88, 0.7561, 0.5);
  EXPECT_NEAR(mirrored_double_support_s(fast) - fast.double_support_s, 0.29e-3, 0.01e-3);
  const GaitFactors slow = gait_of(0.86, 0.6203, 1.2);
  EXPECT_NEAR(mirrored_double_support_s(slow) - slow.double_support_s, 8.8e-3, 0.1e-3);
}

TEST(ComPath, DoesNotCloseByTheThirdMethodAsItIsPrinted) {
  GaitFactors gait = gait_of(0.88, 0.7561, 0.5);
  gait.double_support_s = 0.1259;
  const ScalarMotion next = com_in_single_support(gait, 0.0);
  const ScalarMotion end = com_in_double_support(ComMethod::kMirroredAsPrinted, gait, gait.double_support_s);
  EXPECT_NEAR(end.position - 0.5 * gait.step_length_m - next.position, 7.9e-3, 0.1e-3);
  EXPECT_NEAR(end.velocity - next.velocity, 0.190, 0.001);
  EXPECT_NEAR(end.acceleration - next.acceleration, 3.07, 0.01);
}

}  // namespace
}  // namespace surefoot::planning
