#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "firmware/core/safety/output_gate.hpp"

namespace surefoot::safety {
namespace {

constexpr double kPeriodS = 0.01;
constexpr double kLargestChangeRad = 0.12;  // 12 rad/s for 10 ms
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

SensorSnapshot fresh_sensors(double angle_rad = 0.0) {
  SensorSnapshot sensors;
  for (LegSensors& leg : sensors.leg) {
    leg.angle_rad.fill(angle_rad);
    leg.freshness.age_ticks = 0;
  }
  for (FootSensors& foot : sensors.foot) foot.freshness.age_ticks = 0;
  sensors.torso.freshness.age_ticks = 0;
  return sensors;
}

PerSide<LegVector> all_joints(double value) {
  PerSide<LegVector> wanted{};
  for (LegVector& leg : wanted) leg.fill(value);
  return wanted;
}

void expect_damped(const PerSide<LegCommand>& command) {
  for (const LegCommand& leg : command) EXPECT_EQ(leg.mode, LegMode::kDamp);
}

void expect_angle(const LegCommand& command, double angle_rad) {
  EXPECT_EQ(command.mode, LegMode::kPosition);
  EXPECT_EQ(command.torque_nm, LegVector{});
  for (const double angle : command.angle_rad) EXPECT_NEAR(angle, angle_rad, 1e-12);
}

void expect_angles(const PerSide<LegCommand>& command, double angle_rad) {
  for (const LegCommand& leg : command) expect_angle(leg, angle_rad);
}

/// A gate with a fresh memory and the default limits; `aim` is one call that wants all joints there.
struct Gate {
  OutputGateConfig config{};
  OutputGateState state{};
  GateOrders orders{};
  PerSide<LegCommand> tick(const SensorSnapshot& sensors, const WantedMotion& wanted) {
    return step(config, state, wanted, sensors, orders, kPeriodS);
  }
  PerSide<LegCommand> aim(const SensorSnapshot& sensors, double angle_rad) {
    return tick(sensors, {.mode = LegMode::kPosition, .angle_rad = all_joints(angle_rad)});
  }
};

TEST(OutputGateAngles, PassWithinTheLimitsUntouchedToTheirOwnJoint) {
  Gate gate;
  WantedMotion wanted{.mode = LegMode::kPosition};
  for (std::size_t leg = 0; leg < 2; ++leg) {
    for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
      wanted.angle_rad[leg][joint] = 0.01 * static_cast<double>(joint) + 0.05 * static_cast<double>(leg);
    }
  }
  const PerSide<LegCommand> command = gate.tick(fresh_sensors(), wanted);
  for (std::size_t leg = 0; leg < 2; ++leg) EXPECT_EQ(command[leg].angle_rad, wanted.angle_rad[leg]);
  EXPECT_EQ(gate.state.latched.fault, Fault::kNone);
}

TEST(OutputGateAngles, BeginAtTheJointsAsMeasuredAndFollowAtTheRateLimit) {
  Gate gate;
  expect_angles(gate.aim(fresh_sensors(0.5), 0.0), 0.5 - kLargestChangeRad);
  expect_angles(gate.aim(fresh_sensors(0.5), 0.0), 0.5 - 2.0 * kLargestChangeRad);
  for (int tick = 0; tick < 3; ++tick) (void)gate.aim(fresh_sensors(0.5), 0.0);
  expect_angles(gate.aim(fresh_sensors(0.5), 0.0), 0.0);
  gate.state = {};
  expect_angles(gate.aim(fresh_sensors(-0.01), 0.0), 0.0);
}

TEST(OutputGateAngles, StayInEachJointsOwnRange) {
  for (const double sign : {1.0, -1.0}) {
    Gate gate;
    PerSide<LegCommand> command;
    for (int tick = 0; tick < 30; ++tick) command = gate.aim(fresh_sensors(), sign * 10.0);
    for (const LegCommand& leg : command) {
      EXPECT_EQ(leg.angle_rad, sign > 0.0 ? gate.config.angle_max_rad : gate.config.angle_min_rad);
    }
    EXPECT_EQ(gate.state.latched.fault, Fault::kNone) << "clamped, not a fault";
  }
}

TEST(OutputGateAngles, LatchWhenAnyIsNotFiniteAndOnlyThen) {
  for (std::size_t leg = 0; leg < 2; ++leg) {
    for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
      for (const double bad : {kNan, -kNan, kInfinity, -kInfinity}) {
        WantedMotion wanted{.mode = LegMode::kPosition};
        wanted.angle_rad[leg][joint] = bad;
        Gate gate;
        expect_damped(gate.tick(fresh_sensors(), wanted));
        EXPECT_EQ(gate.state.latched.fault, Fault::kTorqueNotFinite);
        EXPECT_EQ(gate.state.latched.needs, SafeState::kDamp);
        wanted.mode = LegMode::kTorque;  // which sends no angles
        Gate other;
        EXPECT_EQ(other.tick(fresh_sensors(), wanted)[leg].mode, LegMode::kTorque);
      }
    }
  }
  Gate gate;  // a servo that nobody asked may be lost in NaN
  const WantedMotion wanted{.mode = LegMode::kPosition, .torque_nm = all_joints(kNan)};
  expect_angles(gate.tick(fresh_sensors(), wanted), 0.0);
}

TEST(OutputGateAngles, AreHeldForALateLegBoardAndForNobodyElse) {
  for (std::size_t leg = 0; leg < 2; ++leg) {
    Gate gate;
    expect_angles(gate.aim(fresh_sensors(), 0.1), 0.1);
    for (std::uint32_t age = 1; age <= gate.config.ride_through_ticks; ++age) {
      SensorSnapshot sensors = fresh_sensors(0.7);
      sensors.leg[leg].freshness.age_ticks = age;
      const PerSide<LegCommand> command = gate.aim(sensors, 0.05);
      expect_angle(command[leg], 0.1);
      expect_angle(command[1 - leg], 0.05);
    }
    expect_angles(gate.aim(fresh_sensors(), 0.05), 0.05);
    EXPECT_EQ(gate.state.latched.fault, Fault::kNone);
  }
}

TEST(OutputGateAngles, DampUnderTheRulesOfTorques) {
  SensorSnapshot silent = fresh_sensors();
  silent.leg[1].freshness.age_ticks = 11;
  SensorSnapshot fast = fresh_sensors();
  fast.leg[0].rate_rad_s[2] = 26.0;
  SensorSnapshot folded = fresh_sensors();
  folded.leg[0].angle_rad[3] = 2.7;
  for (const SensorSnapshot& bad : {silent, fast, folded}) {
    Gate gate;
    (void)gate.aim(fresh_sensors(), 0.1);
    expect_damped(gate.aim(bad, 0.1));
    for (int tick = 0; tick < 100; ++tick) expect_damped(gate.aim(fresh_sensors(), 0.1));
  }
}

TEST(OutputGateAngles, GoOnInAStanceHold) {
  Gate gate;
  gate.orders.reported = finding_of(Fault::kLoopOverrun);
  for (int tick = 0; tick < 100; ++tick) expect_angles(gate.aim(fresh_sensors(), 0.1), 0.1);
  EXPECT_EQ(gate.state.latched.needs, SafeState::kStanceHold);
}

TEST(OutputGateAngles, DampUntilEveryNodeAnsweredAndBeginAtTheJointsOfThatTick) {
  Gate gate;
  SensorSnapshot awaited = fresh_sensors(0.1);
  awaited.torso.freshness = {};
  for (int tick = 0; tick < 5; ++tick) expect_damped(gate.aim(awaited, 0.0));
  expect_angles(gate.aim(fresh_sensors(0.4), 0.0), 0.4 - kLargestChangeRad);
}

// Without a measurement of this tick nobody knows where a leg is: it may have fallen through half its range.
TEST(OutputGateAngles, BeginOnlyInATickInWhichBothBoardsAnswered) {
  Gate gate;
  (void)gate.tick(fresh_sensors(), {});
  SensorSnapshot late = fresh_sensors(0.1);
  late.leg[1].freshness.age_ticks = 1;
  late.leg[1].angle_rad.fill(kNan);
  expect_damped(gate.aim(late, 0.0));
  expect_angles(gate.aim(fresh_sensors(0.3), 0.0), 0.3 - kLargestChangeRad);
}

TEST(OutputGateAngles, BeginAnewForALegWhoseBoardDamps) {
  Gate gate;
  expect_angles(gate.aim(fresh_sensors(), 0.0), 0.0);
  SensorSnapshot sagged = fresh_sensors(0.6);
  sagged.leg[0].is_damping = true;
  const PerSide<LegCommand> command = gate.aim(sagged, 0.0);
  expect_angle(command[0], 0.6 - kLargestChangeRad);
  expect_angle(command[1], 0.0);
  sagged.leg[0].is_damping = false;
  EXPECT_NEAR(gate.aim(sagged, 0.0)[0].angle_rad[0], 0.6 - 2.0 * kLargestChangeRad, 1e-12);
}

TEST(OutputGateAngles, AndTorquesFollowEachOtherWithoutAMemoryOfTheLastTime) {
  Gate gate;
  gate.config.torque_rate_limit_nm_s = 1.0e3;
  (void)gate.tick(fresh_sensors(), {.torque_nm = all_joints(100.0)});
  EXPECT_EQ(gate.state.last_torque_nm, all_joints(10.0));
  expect_angles(gate.aim(fresh_sensors(0.2), 0.2), 0.2);
  EXPECT_EQ(gate.tick(fresh_sensors(), {.torque_nm = all_joints(100.0)})[0].torque_nm, all_joints(10.0)[0]);
  expect_angles(gate.aim(fresh_sensors(0.5), 0.5), 0.5);
}

TEST(OutputGateAngles, OrTorquesAreNeitherSentNorMissedWhereDampingIsWanted) {
  Gate gate;
  SensorSnapshot sensors = fresh_sensors(0.4);
  for (LegSensors& leg : sensors.leg) leg.is_damping = true;
  const WantedMotion damping{.mode = LegMode::kDamp, .torque_nm = all_joints(kNan), .angle_rad = all_joints(kNan)};
  for (int tick = 0; tick < 100; ++tick) expect_damped(gate.tick(sensors, damping));
  EXPECT_EQ(gate.state.latched.fault, Fault::kNone);
  expect_angles(gate.aim(sensors, 0.4), 0.4);
}

}  // namespace
}  // namespace surefoot::safety
