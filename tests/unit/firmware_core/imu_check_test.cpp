#include "firmware/core/safety/imu_check.hpp"

#include <gtest/gtest.h>

namespace surefoot::safety {
namespace {

constexpr double kPeriodS = 1.0e-3;

struct FeelingImu {
  ImuCheckConfig config{};
  ImuCheckState state{};
  bool is_moving = true;
  int tick = 0;

  template <typename Lie>
  int objects_after(int limit, Lie lie) {
    for (int i = 1; i <= limit; ++i) {
      ImuSensors imu;
      imu.angular_rate_body_rad_s = {0.0005 * (tick % 5), 0.0, 0.0};
      imu.specific_force_body_m_s2 = {0.0, 0.0, 9.81};
      imu.freshness.age_ticks = 0;
      ++tick;
      lie(imu);
      if (!is_imu_plausible(config, state, imu, is_moving, kPeriodS)) return i;
    }
    return 0;
  }
};

TEST(ImuCheck, AcceptsAnyOneOfItsSixValuesMoving) {
  FeelingImu imu;
  EXPECT_EQ(imu.objects_after(20'000, [](auto&) {}), 0);
  EXPECT_EQ(imu.objects_after(20'000,
                              [&](ImuSensors& s) {
                                s.angular_rate_body_rad_s.setZero();
                                s.specific_force_body_m_s2.y() = 0.005 * (imu.tick % 2);
                              }),
            0);
}

TEST(ImuCheck, FindsAnImuThatKeepsItsBitsWhileTheRobotWalks) {
  FeelingImu imu;
  const auto stuck = [](ImuSensors& s) { s.angular_rate_body_rad_s = {0.1, -0.2, 0.3}; };
  EXPECT_EQ(imu.objects_after(2000, stuck), 502);
  FeelingImu standing;
  standing.is_moving = false;
  EXPECT_EQ(standing.objects_after(20'000, stuck), 0);
}

TEST(ImuCheck, DoesNotCountTheLastWordOfASilentImu) {
  FeelingImu imu;
  EXPECT_EQ(imu.objects_after(20'000,
                              [](ImuSensors& s) {
                                s.angular_rate_body_rad_s = {0.1, -0.2, 0.3};
                                s.specific_force_body_m_s2 = {0.0, 0.0, 160.0};
                                s.freshness.age_ticks = 2;
                              }),
            0);
}

// The hardest landing of the scenarios is 153 m/s2 in one tick and 13 filtered.
TEST(ImuCheck, AcceptsTheShockOfALandingAndFindsAForceThatLasts) {
  FeelingImu imu;
  EXPECT_EQ(imu.objects_after(10, [](auto& s) { s.specific_force_body_m_s2 = {0.0, 0.0, 160.0}; }), 0);
  EXPECT_EQ(imu.objects_after(2000, [](auto&) {}), 0);
  const int ticks = imu.objects_after(200, [](auto& s) { s.specific_force_body_m_s2 = {-160.0, 0.0, 0.0}; });
  EXPECT_GT(ticks, 20);
  EXPECT_LT(ticks, 40);  // 0.1 s times ln(160 / 120) is 29 ms
}

}  // namespace
}  // namespace surefoot::safety
