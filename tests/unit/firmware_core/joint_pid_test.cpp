#include "firmware/core/servo/joint_pid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace surefoot::servo {
namespace {

constexpr double kPeriodS = 1.0e-3;

ServoConfig with_gains(const JointGains& gains) {
  ServoConfig config;
  config.gains.fill(gains);
  return config;
}

SensorSnapshot fresh_sensors() {
  SensorSnapshot sensors;
  for (LegSensors& leg : sensors.leg) leg.freshness.age_ticks = 0;
  return sensors;
}

void set_all(PerSide<LegVector>& values, double value) {
  for (LegVector& leg : values) leg.fill(value);
}

TEST(JointPid, GivesEachJointItsOwnProportionalTorque) {
  ServoConfig config;
  JointReference reference;
  SensorSnapshot sensors = fresh_sensors();
  for (std::size_t leg = 0; leg < 2; ++leg) {
    for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
      config.gains[joint] = {1000.0 * static_cast<double>(joint + 1), 0.0, 0.0};
      reference.angle_rad[leg][joint] = 0.01 * static_cast<double>(joint) + 0.1 * static_cast<double>(leg);
      sensors.leg[leg].angle_rad[joint] = 0.02;
    }
  }
  ServoState state;
  const PerSide<LegVector> torque = step(config, state, reference, sensors, kPeriodS);
  for (std::size_t leg = 0; leg < 2; ++leg) {
    for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
      const double error = 0.01 * static_cast<double>(joint) + 0.1 * static_cast<double>(leg) - 0.02;
      EXPECT_NEAR(torque[leg][joint], 1000.0 * static_cast<double>(joint + 1) * error, 1e-12);
    }
  }
}

// A jump of the reference angle must not appear in the derivative: it comes from the rates alone.
TEST(JointPid, TakesTheReferenceRateAsItIs) {
  const ServoConfig config = with_gains({0.0, 0.0, 40.0});
  JointReference reference;
  SensorSnapshot sensors = fresh_sensors();
  ServoState state;
  for (const double angle : {0.0, 1.0, -1.0}) {
    set_all(reference.angle_rad, angle);
    set_all(reference.rate_rad_s, 2.0);
    for (LegSensors& leg : sensors.leg) leg.rate_rad_s.fill(0.5);
    for (const LegVector& leg : step(config, state, reference, sensors, kPeriodS)) {
      for (const double torque : leg) EXPECT_DOUBLE_EQ(torque, 40.0 * 1.5);
    }
  }
}

// Constant error e over n ticks: ki e n T, for any period.
TEST(JointPid, IntegratesTheErrorOverTime) {
  const ServoConfig config = with_gains({0.0, 50.0, 0.0});
  JointReference reference;
  set_all(reference.angle_rad, 0.2);
  for (const double period_s : {1.0e-3, 0.5e-3}) {
    ServoState state;
    PerSide<LegVector> torque{};
    for (int tick = 0; tick < 1000; ++tick) torque = step(config, state, reference, fresh_sensors(), period_s);
    for (const LegVector& leg : torque) {
      for (const double joint_torque : leg) EXPECT_NEAR(joint_torque, 50.0 * 0.2 * 1000.0 * period_s, 1e-9);
    }
  }
}

TEST(JointPid, StopsIntegratingWhereTheOutputWouldPassTheLimit) {
  const ServoConfig config = with_gains({0.0, 500.0, 0.0});
  for (const double error : {0.3, -0.3}) {
    JointReference reference;
    set_all(reference.angle_rad, error);
    ServoState state;
    for (int tick = 0; tick < 10'000; ++tick) {
      for (const LegVector& leg : step(config, state, reference, fresh_sensors(), kPeriodS)) {
        for (const double torque : leg) EXPECT_LE(std::abs(torque), config.torque_limit_nm);
      }
    }
    EXPECT_NEAR(state.integral_nm[0][0], std::copysign(200.0, error), 0.15);  // one increment below the limit
  }
}

// Ten seconds at the limit, then the error reverses: the output is that of a servo that was never saturated.
TEST(JointPid, DoesNotRememberSaturation) {
  const ServoConfig config = with_gains({1000.0, 100.0, 0.0});
  for (const double sign : {1.0, -1.0}) {
    ServoState state;
    JointReference reference;
    set_all(reference.angle_rad, sign * 0.5);  // asks for 500 Nm of 200
    for (int tick = 0; tick < 10'000; ++tick) {
      static_cast<void>(step(config, state, reference, fresh_sensors(), kPeriodS));
    }
    set_all(reference.angle_rad, sign * -0.1);
    const PerSide<LegVector> reversed = step(config, state, reference, fresh_sensors(), kPeriodS);
    for (const LegVector& leg : reversed) {
      for (const double torque : leg) EXPECT_NEAR(torque, sign * (-100.0 - 100.0 * 0.1 * kPeriodS), 1e-9);
    }
  }
}

// At the limit because of the integral itself, an error of the other sign must be allowed to empty it.
TEST(JointPid, IntegratesAtTheLimitTowardsSmallerOutput) {
  const ServoConfig config = with_gains({0.0, 100.0, 0.0});
  for (const double sign : {1.0, -1.0}) {
    ServoState state;
    set_all(state.integral_nm, sign * 250.0);
    JointReference reference;
    set_all(reference.angle_rad, -sign);
    static_cast<void>(step(config, state, reference, fresh_sensors(), kPeriodS));
    EXPECT_NEAR(state.integral_nm[1][3], sign * (250.0 - 0.1), 1e-12);
  }
}

// A rotor of 0.4 kg m2 held ten seconds 0.5 rad from its reference, where the servo saturates, then released:
// with conditional integration the integral adds no overshoot beyond that of the PD part.
TEST(JointPid, ComesOutOfSaturationWithoutOvershootFromTheIntegral) {
  const ServoConfig config = with_gains({4000.0, 2000.0, 200.0});
  const double inertia_kg_m2 = 0.4;
  ServoState state;
  JointReference reference;
  SensorSnapshot sensors = fresh_sensors();
  double angle = 0.0, rate = 0.0, largest = 0.0;
  set_all(reference.angle_rad, 0.5);
  for (int tick = 0; tick < 12'000; ++tick) {
    const bool held = tick < 10'000;  // ten seconds against a stop
    for (LegSensors& leg : sensors.leg) {
      leg.angle_rad.fill(angle);
      leg.rate_rad_s.fill(rate);
    }
    const double wanted = step(config, state, reference, sensors, kPeriodS)[0][0];
    const double torque = std::fmin(std::fmax(wanted, -200.0), 200.0);
    if (!held) {
      rate += torque / inertia_kg_m2 * kPeriodS;
      angle += rate * kPeriodS;
    }
    largest = std::fmax(largest, angle);
  }
  EXPECT_NEAR(angle, 0.5, 1e-2);
  EXPECT_LT(largest, 0.5 * 1.02);  // an integral wound up to the 200 Nm limit passes by 9 %
}

TEST(JointPid, DoesNotIntegrateOverAMeasurementThatDidNotArrive) {
  const ServoConfig config = with_gains({0.0, 100.0, 0.0});
  JointReference reference;
  set_all(reference.angle_rad, 1.0);
  SensorSnapshot sensors = fresh_sensors();
  sensors.leg[index(Side::kLeft)].freshness.age_ticks = 1;
  ServoState state;
  static_cast<void>(step(config, state, reference, sensors, kPeriodS));
  EXPECT_DOUBLE_EQ(state.integral_nm[index(Side::kRight)][0], 0.1);
  EXPECT_EQ(state.integral_nm[index(Side::kLeft)][0], 0.0);
}

// The gate must see the NaN; the integral must not keep it.
TEST(JointPid, PassesNanOnButDoesNotStoreIt) {
  const ServoConfig config = with_gains({1000.0, 100.0, 10.0});
  JointReference reference;
  reference.angle_rad[0][2] = std::numeric_limits<double>::quiet_NaN();
  ServoState state;
  EXPECT_TRUE(std::isnan(step(config, state, reference, fresh_sensors(), kPeriodS)[0][2]));
  EXPECT_EQ(state.integral_nm[0][2], 0.0);
}

// Gains of the sampled loop (kd/J <= 300 1/s, kp/J <= 75000 1/s2 at one tick of latency): the default
// servo on a rotor of 0.4 kg m2 that acts one tick late must settle, not chatter.
TEST(JointPid, SettlesAtDefaultGainsWithOneTickOfLatency) {
  const ServoConfig config;
  const double inertia_kg_m2 = 0.4;
  ServoState state;
  JointReference reference;
  SensorSnapshot sensors = fresh_sensors();
  double angle = 0.001, rate = 0.0, torque = 0.0;
  for (int tick = 0; tick < 1000; ++tick) {
    for (LegSensors& leg : sensors.leg) {
      leg.angle_rad.fill(angle);
      leg.rate_rad_s.fill(rate);
    }
    const double wanted = step(config, state, reference, sensors, kPeriodS)[0][index(LegJoint::kKneePitch)];
    rate += torque / inertia_kg_m2 * kPeriodS;
    angle += rate * kPeriodS;
    torque = wanted;
  }
  EXPECT_LT(std::abs(angle), 1e-9);
  EXPECT_LT(std::abs(torque), 1e-4);
}

}  // namespace
}  // namespace surefoot::servo
