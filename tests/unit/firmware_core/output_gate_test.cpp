#include "firmware/core/safety/output_gate.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>

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
  PerSide<LegCommand> tick(const SensorSnapshot& sensors, const PerSide<LegVector>& wanted) {
    return step(config, state, wanted, sensors, kPeriodS);
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
  EXPECT_EQ(gate.state.latched, Fault::kNone);
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

TEST(OutputGate, HoldsTheLastTorquesWhileAnyNodeRidesThrough) {
  for (std::size_t node = 0; node < 5; ++node) {
    Gate gate;
    expect_torque(gate.tick(fresh_sensors(), all_joints(50.0)), 50.0);
    for (std::uint32_t age = 1; age <= gate.config.ride_through_ticks; ++age) {
      SensorSnapshot sensors = fresh_sensors();
      nodes_of(sensors)[node]->age_ticks = age;
      expect_torque(gate.tick(sensors, all_joints(-10.0)), 50.0);
    }
    expect_torque(gate.tick(fresh_sensors(), all_joints(-10.0)), -10.0);
    EXPECT_EQ(gate.state.latched, Fault::kNone);
  }
}

TEST(OutputGate, LatchesWhenAnyNodeIsSilentBeyondTheRideThrough) {
  for (std::size_t node = 0; node < 5; ++node) {
    for (const std::uint32_t age : {11U, 1000U, Freshness::kNeverHeard}) {
      Gate gate;
      static_cast<void>(gate.tick(fresh_sensors(), all_joints(50.0)));
      SensorSnapshot sensors = fresh_sensors();
      nodes_of(sensors)[node]->age_ticks = age;
      expect_damped(gate.tick(sensors, all_joints(50.0)));
      EXPECT_EQ(gate.state.latched, Fault::kSensorSilent);
    }
  }
}

TEST(OutputGate, DampsWithoutAFaultUntilEveryNodeHasAnswered) {
  for (std::size_t node = 0; node < 5; ++node) {
    Gate gate;
    SensorSnapshot sensors = fresh_sensors();
    nodes_of(sensors)[node]->age_ticks = Freshness::kNeverHeard;
    for (std::uint32_t tick = 0; tick < gate.config.ride_through_ticks; ++tick) {
      expect_damped(gate.tick(sensors, all_joints(50.0)));
      EXPECT_EQ(gate.state.latched, Fault::kNone);
    }
    Gate late = gate;
    expect_torque(late.tick(fresh_sensors(), all_joints(50.0)), 50.0);
    expect_damped(gate.tick(sensors, all_joints(50.0)));
    EXPECT_EQ(gate.state.latched, Fault::kSensorSilent);
  }
}

// While one node is awaited, another that was heard and fell silent is no less a fault.
TEST(OutputGate, LatchesForANodeThatFallsSilentWhileAnotherIsAwaited) {
  Gate gate;
  SensorSnapshot sensors = fresh_sensors();
  sensors.torso.freshness.age_ticks = Freshness::kNeverHeard;
  sensors.leg[1].freshness.age_ticks = 11;
  expect_damped(gate.tick(sensors, all_joints(0.0)));
  EXPECT_EQ(gate.state.latched, Fault::kSensorSilent);
}

TEST(OutputGate, LatchesWhenAnyWantedTorqueIsNotFinite) {
  for (std::size_t leg = 0; leg < 2; ++leg) {
    for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
      for (const double bad : {kNan, -kNan, kInfinity, -kInfinity}) {
        Gate gate;
        PerSide<LegVector> wanted = all_joints(10.0);
        wanted[leg][joint] = bad;
        expect_damped(gate.tick(fresh_sensors(), wanted));
        EXPECT_EQ(gate.state.latched, Fault::kTorqueNotFinite);
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
        EXPECT_EQ(gate.state.latched, Fault::kJointOutOfRange);
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
        EXPECT_EQ(gate.state.latched, Fault::kJointOverspeed);
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
  EXPECT_EQ(gate.state.latched, Fault::kNone);
}

TEST(OutputGate, NamesTheCauseWhenOneTickShowsSeveralFaults) {
  PerSide<LegVector> wanted = all_joints(kNan);
  SensorSnapshot sensors = fresh_sensors();
  sensors.leg[1].rate_rad_s[0] = 30.0;
  Gate fast;
  expect_damped(fast.tick(sensors, wanted));
  EXPECT_EQ(fast.state.latched, Fault::kJointOverspeed);
  sensors.leg[1].angle_rad[0] = 3.0;
  Gate outside;
  expect_damped(outside.tick(sensors, wanted));
  EXPECT_EQ(outside.state.latched, Fault::kJointOutOfRange);
  sensors.foot[0].freshness.age_ticks = 11;
  Gate silent;
  expect_damped(silent.tick(sensors, wanted));
  EXPECT_EQ(silent.state.latched, Fault::kSensorSilent);
}

TEST(OutputGate, KeepsTheFirstFaultAndDampsUntilItsStateIsReplaced) {
  Gate gate;
  static_cast<void>(gate.tick(fresh_sensors(), all_joints(100.0)));
  expect_damped(gate.tick(fresh_sensors(), all_joints(kNan)));
  SensorSnapshot fast = fresh_sensors();
  fast.leg[0].rate_rad_s[0] = 99.0;
  expect_damped(gate.tick(fast, all_joints(1.0)));
  for (int tick = 0; tick < 1000; ++tick) expect_damped(gate.tick(fresh_sensors(), all_joints(1.0)));
  EXPECT_EQ(gate.state.latched, Fault::kTorqueNotFinite);
  gate.state = {};
  expect_torque(gate.tick(fresh_sensors(), all_joints(1.0)), 1.0);
}

TEST(Fault, HasANameOfItsOwnForEachNumber) {
  const std::array faults{
      Fault::kNone,           Fault::kSensorSilent, Fault::kTorqueNotFinite, Fault::kJointOutOfRange,
      Fault::kJointOverspeed, Fault::kBoardDamping};
  std::set<std::string> names;
  for (const Fault fault : faults) names.insert(name(fault));
  EXPECT_EQ(names, (std::set<std::string>{"none", "sensor_silent", "torque_not_finite", "joint_out_of_range",
                                          "joint_overspeed", "board_damping"}));
  EXPECT_STREQ(name(static_cast<Fault>(99)), "unknown");
}

/// Torques that do not arrive: the board's watchdog damps the joints and says so in its state.
TEST(OutputGate, LatchesWhenABoardDampsAgainstItsOrdersForLongerThanTheRideThrough) {
  for (const std::size_t leg : {0U, 1U}) {
    Gate gate;
    SensorSnapshot sensors = fresh_sensors();
    sensors.leg[leg].is_damping = true;
    for (std::uint32_t tick = 0; tick < gate.config.ride_through_ticks; ++tick) {
      expect_torque(gate.tick(sensors, all_joints(5.0)), 5.0);
    }
    expect_damped(gate.tick(sensors, all_joints(5.0)));
    EXPECT_EQ(gate.state.latched, Fault::kBoardDamping);
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
  EXPECT_EQ(gate.state.latched, Fault::kNone);
}

}  // namespace
}  // namespace surefoot::safety
