#include "firmware/core/gait/nominal_walk.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace surefoot::gait {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::size_t kRight = index(Side::kRight);
constexpr std::size_t kLeft = index(Side::kLeft);

const WalkParameters kWalk{};
constexpr double kReference_x_m = -0.09;
constexpr double kTime = 1.0e-7;  // either side of a boundary

// P1..P4 and T of El-Kahlout 2003, section 3.2, with its t_ss 1.4 and t_ds 1.0.
constexpr std::array kBoundaries_s{0.5, 1.9, 2.9, 4.3, 4.8};

FootReference at(double phase_s) { return nominal_walk(kWalk, phase_s, kReference_x_m); }

TEST(NominalWalk, IsContinuousInPositionAndVelocityAtEveryBoundary) {
  for (const double boundary_s : kBoundaries_s) {
    const FootReference before = at(boundary_s - kTime);
    const FootReference after = at(boundary_s + kTime);
    const FootReference here = at(boundary_s);
    for (const Side side : kSides) {
      const std::size_t s = index(side);
      const geometry::Vector3 step_m = after[s].position_body_m - before[s].position_body_m;
      const geometry::Vector3 smooth_m = 2.0 * kTime * here[s].velocity_body_m_s;
      EXPECT_LT((step_m - smooth_m).norm(), 1.0e-9) << boundary_s;
      EXPECT_LT((after[s].velocity_body_m_s - before[s].velocity_body_m_s).norm(), 2.0 * kTime) << boundary_s;
    }
  }
}

// Appendix A.2 of the specification: inherent to cosines.
TEST(NominalWalk, JumpsInAccelerationAtLiftOffAndTouchDownAsCosinesMust) {
  const FootPath before = at(0.5 - kTime)[kLeft];
  const FootPath after = at(0.5 + kTime)[kLeft];
  const geometry::Vector3 jump = after.acceleration_body_m_s2 - before.acceleration_body_m_s2;
  EXPECT_NEAR(jump.x(), 0.403, 5.0e-4);
  EXPECT_NEAR(jump.y(), 0.0, 1.0e-6);
  EXPECT_NEAR(jump.z(), 0.302, 5.0e-4);
}

// The thesis prints (3.6) with the phase origin 3/2 t_ds + t_ss of (3.5). This is why we do not follow it.
TEST(NominalWalk, WouldJumpByEighteenMillimetresWithThePrintedPhaseOfTheLeftFoot) {
  const auto printed_z_left_m = [](double t) {
    const double origin_s = 1.5 * kWalk.double_support_s + kWalk.single_support_s;
    return -kWalk.body_height_m +
           0.5 * kWalk.swing_height_m * (1.0 - std::cos(2.0 * kPi * (t - origin_s) / kWalk.single_support_s));
  };
  EXPECT_NEAR(printed_z_left_m(0.5) + kWalk.body_height_m, 0.01834, 5.0e-6);
  EXPECT_NEAR(at(0.5)[kLeft].position_body_m.z() + kWalk.body_height_m, 0.0, 1.0e-12);
}

TEST(NominalWalk, StandsWhereTheEquationsPutIt) {
  // Mid swing of the left foot: feet side by side, apex of the foot, largest sway.
  const FootReference mid_swing = at(1.2);
  EXPECT_NEAR(mid_swing[kRight].position_body_m.x(), -0.09, 1.0e-12);
  EXPECT_NEAR(mid_swing[kLeft].position_body_m.x(), -0.09, 1.0e-12);
  EXPECT_NEAR(mid_swing[kRight].position_body_m.y(), -0.11 + 0.13, 1.0e-12);
  EXPECT_NEAR(mid_swing[kLeft].position_body_m.y(), 0.11 + 0.13, 1.0e-12);
  EXPECT_NEAR(mid_swing[kRight].position_body_m.z(), -0.5, 1.0e-12);
  EXPECT_NEAR(mid_swing[kLeft].position_body_m.z(), -0.47, 1.0e-12);
  // Phase 0: right foot in front; half a cycle later: left foot in front.
  EXPECT_NEAR(at(0.0)[kRight].position_body_m.x(), -0.01, 1.0e-12);
  EXPECT_NEAR(at(0.0)[kLeft].position_body_m.x(), -0.17, 1.0e-12);
  EXPECT_NEAR(at(2.4)[kRight].position_body_m.x(), -0.17, 1.0e-12);
  EXPECT_NEAR(at(2.4)[kLeft].position_body_m.x(), -0.01, 1.0e-12);
  // (3.1) in the first swing, at a third of it.
  EXPECT_NEAR(at(0.5 + 1.4 / 3.0)[kRight].position_body_m.x(), -0.09 + 0.08 * 0.5, 1.0e-12);
}

TEST(NominalWalk, HasDerivativesThatMatchItsPositions) {
  constexpr double h = 1.0e-5;
  for (double t = 0.0123; t < 4.8; t += 0.0371) {
    const FootReference before = at(t - h);
    const FootReference here = at(t);
    const FootReference after = at(t + h);
    for (std::size_t s : {kRight, kLeft}) {
      const geometry::Vector3 velocity = (after[s].position_body_m - before[s].position_body_m) / (2.0 * h);
      const geometry::Vector3 acceleration = (after[s].velocity_body_m_s - before[s].velocity_body_m_s) / (2.0 * h);
      EXPECT_LT((velocity - here[s].velocity_body_m_s).norm(), 1.0e-8) << t;
      EXPECT_LT((acceleration - here[s].acceleration_body_m_s2).norm(), 1.0e-7) << t;
    }
  }
}

TEST(NominalWalk, MirrorsItselfAfterHalfACycle) {
  for (double t = 0.0; t < 2.4; t += 0.0137) {
    const FootReference now = at(t);
    const FootReference later = at(t + 2.4);
    for (const Side side : kSides) {
      const geometry::Vector3 a = now[index(side)].position_body_m;
      const geometry::Vector3 b = later[index(opposite(side))].position_body_m;
      EXPECT_LT((a - geometry::Vector3(b.x(), -b.y(), b.z())).norm(), 1.0e-12) << t;
    }
  }
}

TEST(NominalWalk, TakesAnyPhaseModuloTheCycle) {
  for (const double phase_s : {0.3, 1.2625, 3.1}) {
    for (const double cycles : {-3.0, 1.0, 1000.0}) {
      const FootReference far = at(phase_s + cycles * 4.8);
      EXPECT_LT((far[kLeft].position_body_m - at(phase_s)[kLeft].position_body_m).norm(), 1.0e-10);
    }
  }
}

TEST(NominalWalk, HasBothFeetDownExactlyOutsideTheTwoSwings) {
  for (const double phase_s : {0.0, 0.49, 1.91, 2.4, 2.89, 4.31, 4.79}) {
    EXPECT_TRUE(is_double_support(kWalk, phase_s)) << phase_s;
  }
  for (const double phase_s : {0.51, 1.2, 1.89, 2.91, 3.6, 4.29}) {
    EXPECT_FALSE(is_double_support(kWalk, phase_s)) << phase_s;
  }
}

TEST(HalfCycle, TakesANanosecondEarlyForTheNextHalf) {
  EXPECT_EQ(half_cycle(kWalk, 2.4 - 1.0e-12).swing, Side::kRight);
  EXPECT_EQ(half_cycle(kWalk, 4.8 - 1.0e-12).swing, Side::kLeft);
  EXPECT_EQ(half_cycle(kWalk, 2.4 - 1.0e-6).swing, Side::kLeft);
  EXPECT_GE(half_cycle(kWalk, 2.4 - 1.0e-12).time_s, 0.0);
}

TEST(NominalWalkFromRest, StartsAtRestAndJoinsTheWalkAfterHalfADoubleSupport) {
  for (const double start_s : {0.0, 2.4}) {
    const auto from_rest = [&](double t) { return nominal_walk_from_rest(kWalk, start_s + t, kReference_x_m, t); };
    for (std::size_t s : {kRight, kLeft}) {
      EXPECT_NEAR(from_rest(0.0)[s].velocity_body_m_s.norm(), 0.0, 1.0e-12);
      EXPECT_NEAR(std::abs(at(start_s)[s].velocity_body_m_s.y()), 0.170, 5.0e-4);  // what the fade is for
      const FootPath before = from_rest(0.5 - kTime)[s];
      const FootPath after = from_rest(0.5 + kTime)[s];
      EXPECT_LT((after.position_body_m - before.position_body_m).norm(), 2.0 * kTime);
      EXPECT_LT((after.velocity_body_m_s - before.velocity_body_m_s).norm(), 2.0 * kTime);
      EXPECT_EQ(from_rest(0.7)[s].position_body_m, at(start_s + 0.7)[s].position_body_m);
    }
  }
}

TEST(NominalWalkFromRest, FadesNothingButTheSway) {
  for (double t = 0.0; t < 0.6; t += 0.01) {
    const FootReference faded = nominal_walk_from_rest(kWalk, t, kReference_x_m, t);
    const FootReference full = at(t);
    for (std::size_t s : {kRight, kLeft}) {
      EXPECT_EQ(faded[s].position_body_m.x(), full[s].position_body_m.x());
      EXPECT_EQ(faded[s].position_body_m.z(), full[s].position_body_m.z());
      EXPECT_LE(std::abs(faded[s].position_body_m.y() + (s == kRight ? 0.11 : -0.11)),
                std::abs(full[s].position_body_m.y() + (s == kRight ? 0.11 : -0.11)) + 1.0e-15);
    }
  }
}

TEST(NominalWalkFromRest, HasDerivativesThatMatchItsPositions) {
  constexpr double h = 1.0e-5;
  const auto y = [](double t) { return nominal_walk_from_rest(kWalk, 2.4 + t, kReference_x_m, t)[kLeft]; };
  for (double t = 0.01; t < 0.5; t += 0.01) {
    EXPECT_NEAR((y(t + h).position_body_m.y() - y(t - h).position_body_m.y()) / (2.0 * h), y(t).velocity_body_m_s.y(),
                1.0e-8);
    EXPECT_NEAR((y(t + h).velocity_body_m_s.y() - y(t - h).velocity_body_m_s.y()) / (2.0 * h),
                y(t).acceleration_body_m_s2.y(), 1.0e-6);
  }
}

}  // namespace
}  // namespace surefoot::gait
