#include "firmware/core/safety/output_gate.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace surefoot::safety {
namespace {

constexpr double kPeriodS = 1.0e-3;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::array<Freshness*, 5> nodes_of(SensorSnapshot& sensors) {
  return {&sensors.leg[0].freshness, &sensors.leg[1].freshness, &sensors.foot[0].freshness, &sensors.foot[1].freshness,
          &sensors.torso.freshness};
}

SensorSnapshot fresh_sensors() {
  SensorSnapshot sensors;
  for (Freshness* freshness : nodes_of(sensors)) freshness->age_ticks = 0;
  return sensors;
}

PerSide<LegVector> all_joints(double torque_nm) {
  PerSide<LegVector> wanted{};
  for (LegVector& leg : wanted) leg.fill(torque_nm);
  return wanted;
}

void expect_damped(const PerSide<LegCommand>& command) {
  for (const LegCommand& leg : command) {
    EXPECT_EQ(leg.mode, LegMode::kDamp);
    EXPECT_EQ(leg.torque_nm, LegVector{});
  }
}

void expect_torque(const PerSide<LegCommand>& command, double torque_nm) {
  for (const LegCommand& leg : command) {
    EXPECT_EQ(leg.mode, LegMode::kTorque);
    for (const double torque : leg.torque_nm) EXPECT_DOUBLE_EQ(torque, torque_nm);
  }
}

/// A gate with a fresh memory and the default limits; `tick` is one call.
struct Gate {
  OutputGateConfig config{};
  OutputGateState state{};
  GateOrders orders{};
  PerSide<LegCommand> tick(const SensorSnapshot& sensors, const PerSide<LegVector>& wanted) {
    return step(config, state, {.torque_nm = wanted}, sensors, orders, kPeriodS);
  }
};

TEST(OutputGate, PassesTorquesWithinTheLimitsUntouchedToTheirOwnJoint) {
  Gate gate;
  PerSide<LegVector> wanted{};
  for (std::size_t leg = 0; leg < 2; ++leg) {
    for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
      wanted[leg][joint] = 100.0 - 12.0 * static_cast<double>(joint) - 90.0 * static_cast<double>(leg);
    }
  }
  const PerSide<LegCommand> command = gate.tick(fresh_sensors(), wanted);
  for (std::size_t leg = 0; leg < 2; ++leg) EXPECT_EQ(command[leg].torque_nm, wanted[leg]);
  EXPECT_EQ(command[0].mode, LegMode::kTorque);
  EXPECT_EQ(gate.state.latched.fault, Fault::kNone);
}

TEST(OutputGate, LimitsTheTorqueInBothDirections) {
  for (const double sign : {1.0, -1.0}) {
    Gate gate;
    for (int tick = 0; tick < 3; ++tick)
      expect_torque(gate.tick(fresh_sensors(), all_joints(sign * 1e6)), sign * 200.0);
  }
}

// 200 Nm/ms: a full reversal takes two ticks, the first of which stops at zero.
TEST(OutputGate, TakesTwoTicksForAFullReversal) {
  Gate gate;
  expect_torque(gate.tick(fresh_sensors(), all_joints(200.0)), 200.0);
  expect_torque(gate.tick(fresh_sensors(), all_joints(-200.0)), 0.0);
  expect_torque(gate.tick(fresh_sensors(), all_joints(-200.0)), -200.0);
}

TEST(OutputGate, RampsWithTheRateLimitTimesThePeriod) {
  Gate gate;
  gate.config.torque_rate_limit_nm_s = 3.0e4;
  for (int tick = 1; tick <= 8; ++tick) {
    expect_torque(gate.tick(fresh_sensors(), all_joints(200.0)), std::fmin(30.0 * tick, 200.0));
  }
}

// The servo works on encoders: a foot or IMU that is late does not concern it, one leg does not concern the other.
TEST(OutputGate, HoldsTheLastTorquesOfALateLegBoardAndOfNobodyElse) {
  for (std::size_t node = 0; node < 5; ++node) {
    Gate gate;
    expect_torque(gate.tick(fresh_sensors(), all_joints(50.0)), 50.0);
    for (std::uint32_t age = 1; age <= gate.config.ride_through_ticks; ++age) {
      SensorSnapshot sensors = fresh_sensors();
      nodes_of(sensors)[node]->age_ticks = age;
      const PerSide<LegCommand> command = gate.tick(sensors, all_joints(-10.0));
      for (std::size_t leg = 0; leg < 2; ++leg) {
        EXPECT_EQ(command[leg].mode, LegMode::kTorque);
        for (const double torque : command[leg].torque_nm) EXPECT_DOUBLE_EQ(torque, node == leg ? 50.0 : -10.0);
      }
    }
    expect_torque(gate.tick(fresh_sensors(), all_joints(-10.0)), -10.0);
    EXPECT_EQ(gate.state.latched.fault, Fault::kNone);
  }
}

TEST(OutputGate, DampsWhenALegBoardIsSilentBeyondTheRideThroughAndGoesOnWithoutAFootOrTheImu) {
  for (std::size_t node = 0; node < 5; ++node) {
    for (const std::uint32_t age : {11U, 1000U, Freshness::kNeverHeard}) {
      Gate gate;
      static_cast<void>(gate.tick(fresh_sensors(), all_joints(50.0)));
      SensorSnapshot sensors = fresh_sensors();
      nodes_of(sensors)[node]->age_ticks = age;
      const PerSide<LegCommand> command = gate.tick(sensors, all_joints(60.0));
      EXPECT_EQ(gate.state.latched.fault, Fault::kSensorSilent);
      EXPECT_EQ(gate.state.latched.needs, node < 2 ? SafeState::kDamp : SafeState::kStanceHold);
      node < 2 ? expect_damped(command) : expect_torque(command, 60.0);
    }
  }
}

// The legs still obey: a foot or the IMU that falls silent asks for no more.
TEST(OutputGate, LatchesForInertialSensorsThatFallSilentBeyondTheRideThroughAndStandsOn) {
  for (std::size_t sensor = 0; sensor < 4; ++sensor) {
    Gate gate;
    SensorSnapshot sensors = fresh_sensors();
    for (std::size_t side = 0; side < 2; ++side) {
      sensors.leg_inertial[side].freshness.age_ticks = 0;
      sensors.foot_inertial[side].freshness.age_ticks = 0;
    }
    static_cast<void>(gate.tick(sensors, all_joints(50.0)));
    const std::size_t side = sensor % 2;
    Freshness& silent = sensor < 2 ? sensors.leg_inertial[side].freshness : sensors.foot_inertial[side].freshness;
    silent.age_ticks = 10;
    expect_torque(gate.tick(sensors, all_joints(55.0)), 55.0);
    EXPECT_EQ(gate.state.latched.fault, Fault::kNone) << sensor;
    silent.age_ticks = 11;
    expect_torque(gate.tick(sensors, all_joints(60.0)), 60.0);
    EXPECT_EQ(gate.state.latched.fault, Fault::kSensorSilent) << sensor;
    EXPECT_EQ(gate.state.latched.needs, SafeState::kStanceHold) << sensor;
  }
}

TEST(OutputGate, DampsWithoutAFaultUntilEveryNodeHasAnswered) {
  for (std::size_t node = 0; node < 5; ++node) {
    Gate gate;
    SensorSnapshot sensors = fresh_sensors();
    nodes_of(sensors)[node]->age_ticks = Freshness::kNeverHeard;
    for (std::uint32_t tick = 0; tick < gate.config.ride_through_ticks; ++tick) {
      expect_damped(gate.tick(sensors, all_joints(50.0)));
      EXPECT_EQ(gate.state.latched.fault, Fault::kNone);
    }
    Gate late = gate;
    expect_torque(late.tick(fresh_sensors(), all_joints(50.0)), 50.0);
    expect_damped(gate.tick(sensors, all_joints(50.0)));
    EXPECT_EQ(gate.state.latched.fault, Fault::kSensorSilent);
    EXPECT_EQ(gate.state.latched.needs, SafeState::kDamp);
  }
}

// While one node is awaited, another that was heard and fell silent is no less a fault.
TEST(OutputGate, LatchesForANodeThatFallsSilentWhileAnotherIsAwaited) {
  Gate gate;
  SensorSnapshot sensors = fresh_sensors();
  sensors.torso.freshness.age_ticks = Freshness::kNeverHeard;
  sensors.leg[1].freshness.age_ticks = 11;
  expect_damped(gate.tick(sensors, all_joints(0.0)));
  EXPECT_EQ(gate.state.latched.fault, Fault::kSensorSilent);
}

TEST(OutputGate, LatchesWhenAnyWantedTorqueIsNotFinite) {
  for (std::size_t leg = 0; leg < 2; ++leg) {
    for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
      for (const double bad : {kNan, -kNan, kInfinity, -kInfinity}) {
        Gate gate;
        PerSide<LegVector> wanted = all_joints(10.0);
        wanted[leg][joint] = bad;
        expect_damped(gate.tick(fresh_sensors(), wanted));
        EXPECT_EQ(gate.state.latched.fault, Fault::kTorqueNotFinite);
      }
    }
  }
}

// The limit itself is allowed, the next number beyond it is not; each joint has its own.
TEST(OutputGate, LatchesOutsideEachJointsOwnRange) {
  for (std::size_t leg = 0; leg < 2; ++leg) {
    for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
      const double low = OutputGateConfig{}.angle_min_rad[joint];
      const double high = OutputGateConfig{}.angle_max_rad[joint];
      for (const double allowed : {low, high}) {
        Gate gate;
        SensorSnapshot sensors = fresh_sensors();
        sensors.leg[leg].angle_rad[joint] = allowed;
        expect_torque(gate.tick(sensors, all_joints(1.0)), 1.0);
      }
      for (const double bad : {std::nextafter(low, -10.0), std::nextafter(high, 10.0), kNan, kInfinity, -kInfinity}) {
        Gate gate;
        SensorSnapshot sensors = fresh_sensors();
        sensors.leg[leg].angle_rad[joint] = bad;
        expect_damped(gate.tick(sensors, all_joints(1.0)));
        EXPECT_EQ(gate.state.latched.fault, Fault::kJointOutOfRange);
      }
    }
  }
}

TEST(OutputGate, LatchesWhenAnyJointIsTooFastInEitherDirection) {
  for (std::size_t leg = 0; leg < 2; ++leg) {
    for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
      for (const double allowed : {25.0, -25.0}) {
        Gate gate;
        SensorSnapshot sensors = fresh_sensors();
        sensors.leg[leg].rate_rad_s[joint] = allowed;
        expect_torque(gate.tick(sensors, all_joints(1.0)), 1.0);
      }
      for (const double bad : {25.001, -25.001, kNan, kInfinity, -kInfinity}) {
        Gate gate;
        SensorSnapshot sensors = fresh_sensors();
        sensors.leg[leg].rate_rad_s[joint] = bad;
        expect_damped(gate.tick(sensors, all_joints(1.0)));
        EXPECT_EQ(gate.state.latched.fault, Fault::kJointOverspeed);
      }
    }
  }
}

TEST(OutputGate, DoesNotAccuseAJointByAnOldMeasurement) {
  Gate gate;
  static_cast<void>(gate.tick(fresh_sensors(), all_joints(5.0)));
  SensorSnapshot sensors = fresh_sensors();
  sensors.leg[0].angle_rad[0] = 3.0;
  sensors.leg[0].rate_rad_s[1] = 300.0;
  sensors.leg[0].freshness.age_ticks = 1;
  expect_torque(gate.tick(sensors, all_joints(5.0)), 5.0);
  EXPECT_EQ(gate.state.latched.fault, Fault::kNone);
}

TEST(OutputGate, NamesTheCauseWhenOneTickShowsSeveralFaults) {
  PerSide<LegVector> wanted = all_joints(kNan);
  SensorSnapshot sensors = fresh_sensors();
  sensors.leg[1].rate_rad_s[0] = 30.0;
  Gate fast;
  expect_damped(fast.tick(sensors, wanted));
  EXPECT_EQ(fast.state.latched.fault, Fault::kJointOverspeed);
  sensors.leg[1].angle_rad[0] = 3.0;
  Gate outside;
  expect_damped(outside.tick(sensors, wanted));
  EXPECT_EQ(outside.state.latched.fault, Fault::kJointOutOfRange);
  sensors.foot[0].freshness.age_ticks = 11;
  Gate silent;
  expect_damped(silent.tick(sensors, wanted));
  EXPECT_EQ(silent.state.latched.fault, Fault::kSensorSilent);
  Gate told;
  told.orders.reported = finding_of(Fault::kSecondMaster);
  expect_damped(told.tick(sensors, wanted));
  EXPECT_EQ(told.state.latched.fault, Fault::kSecondMaster);
  EXPECT_EQ(told.state.latched.needs, SafeState::kDamp) << "the joint asks for worse than the master";
}

TEST(OutputGate, GoesOnWithTheTorquesInAStanceHoldAndNeverBackToNone) {
  Gate gate;
  gate.orders.reported = finding_of(Fault::kLoopOverrun);
  expect_torque(gate.tick(fresh_sensors(), all_joints(20.0)), 20.0);
  gate.orders.reported = {};
  for (int tick = 0; tick < 1000; ++tick) expect_torque(gate.tick(fresh_sensors(), all_joints(30.0)), 30.0);
  EXPECT_EQ(gate.state.latched.fault, Fault::kLoopOverrun);
  EXPECT_EQ(gate.state.latched.needs, SafeState::kStanceHold);
}

// Each way from the stance hold to damping; the first fault keeps its number.
TEST(OutputGate, GoesFromAStanceHoldToDampingWhenAWorseFaultFollows) {
  SensorSnapshot silent = fresh_sensors();
  silent.leg[1].freshness.age_ticks = 11;
  SensorSnapshot fast = fresh_sensors();
  fast.leg[0].rate_rad_s[2] = 26.0;
  SensorSnapshot folded = fresh_sensors();
  folded.leg[0].angle_rad[3] = 2.7;
  for (const SensorSnapshot& worse : {silent, fast, folded}) {
    Gate gate;
    gate.orders.reported = finding_of_node(Fault::kSensorImplausible, false);
    expect_torque(gate.tick(fresh_sensors(), all_joints(20.0)), 20.0);
    gate.orders.reported = {};
    expect_damped(gate.tick(worse, all_joints(20.0)));
    expect_damped(gate.tick(fresh_sensors(), all_joints(20.0)));
    EXPECT_EQ(gate.state.latched.fault, Fault::kSensorImplausible);
    EXPECT_EQ(gate.state.latched.needs, SafeState::kDamp);
  }
}

TEST(OutputGate, DampsWithoutAFaultWhileItWaitsForThePosture) {
  Gate gate;
  gate.orders.is_waiting_for_posture = true;
  SensorSnapshot sensors = fresh_sensors();
  for (LegSensors& leg : sensors.leg) leg.is_damping = true;  // as they are told to
  for (int tick = 0; tick < 1000; ++tick) expect_damped(gate.tick(sensors, all_joints(20.0)));
  EXPECT_EQ(gate.state.latched.fault, Fault::kNone);
  gate.orders.is_waiting_for_posture = false;
  expect_torque(gate.tick(sensors, all_joints(20.0)), 20.0);
}

// There is no stance to hold yet: a foot that falls silent damps for good.
TEST(OutputGate, DampsForGoodAfterAnyFaultBeforeTheFirstTorque) {
  Gate gate;
  gate.orders = {.reported = finding_of(Fault::kLoopOverrun), .is_waiting_for_posture = true};
  expect_damped(gate.tick(fresh_sensors(), all_joints(20.0)));
  gate.orders = {};
  expect_damped(gate.tick(fresh_sensors(), all_joints(20.0)));
  EXPECT_EQ(gate.state.latched.needs, SafeState::kDamp);
}

TEST(OutputGate, KeepsTheFirstFaultAndDampsUntilItsStateIsReplaced) {
  Gate gate;
  static_cast<void>(gate.tick(fresh_sensors(), all_joints(100.0)));
  expect_damped(gate.tick(fresh_sensors(), all_joints(kNan)));
  SensorSnapshot fast = fresh_sensors();
  fast.leg[0].rate_rad_s[0] = 99.0;
  expect_damped(gate.tick(fast, all_joints(1.0)));
  for (int tick = 0; tick < 1000; ++tick) expect_damped(gate.tick(fresh_sensors(), all_joints(1.0)));
  EXPECT_EQ(gate.state.latched.fault, Fault::kTorqueNotFinite);
  gate.state = {};
  expect_torque(gate.tick(fresh_sensors(), all_joints(1.0)), 1.0);
}

// Torques that do not arrive: the board's watchdog damps the joints and says so in its state.
TEST(OutputGate, LatchesWhenABoardDampsAgainstItsOrdersForLongerThanTheRideThrough) {
  for (const std::size_t leg : {0U, 1U}) {
    Gate gate;
    SensorSnapshot sensors = fresh_sensors();
    sensors.leg[leg].is_damping = true;
    for (std::uint32_t tick = 0; tick < gate.config.ride_through_ticks; ++tick) {
      expect_torque(gate.tick(sensors, all_joints(5.0)), 5.0);
    }
    expect_damped(gate.tick(sensors, all_joints(5.0)));
    EXPECT_EQ(gate.state.latched.fault, Fault::kBoardDamping);
  }
}

TEST(OutputGate, ForgivesABoardThatDampsNowAndThen) {
  Gate gate;
  SensorSnapshot sensors = fresh_sensors();
  for (int tick = 0; tick < 100; ++tick) {
    sensors.leg[1].is_damping = tick % 10 != 9;
    expect_torque(gate.tick(sensors, all_joints(5.0)), 5.0);
  }
}

TEST(OutputGate, DoesNotHoldTheLastWordOfASilentBoardAgainstIt) {
  Gate gate;
  gate.config.ride_through_ticks = 20;
  SensorSnapshot sensors = fresh_sensors();
  gate.tick(sensors, all_joints(5.0));
  sensors.leg[0].is_damping = true;
  for (std::uint32_t age = 1; age <= 20; ++age) {
    sensors.leg[0].freshness.age_ticks = age;
    gate.tick(sensors, all_joints(5.0));
  }
  EXPECT_EQ(gate.state.damped_ticks, 0U);
  EXPECT_EQ(gate.state.latched.fault, Fault::kNone);
}

}  // namespace
}  // namespace surefoot::safety
