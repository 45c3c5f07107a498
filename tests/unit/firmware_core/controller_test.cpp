#include "firmware/core/controller.hpp"

#include <gtest/gtest.h>

#include "firmware/core/kinematics/leg_kinematics.hpp"

namespace surefoot {
namespace {

/// Every node fresh, the legs exactly where the last reference wanted them, the weight evenly on the soles. No
/// live sensor gives the same bits twice.
SensorSnapshot ideal_sensors(const JointReference& joints, std::uint32_t tick, double weight_n) {
  SensorSnapshot sensors;
  sensors.tick = tick;
  for (const Side side : kSides) {
    sensors.leg[index(side)].angle_rad = joints.angle_rad[index(side)];
    sensors.leg[index(side)].rate_rad_s = joints.rate_rad_s[index(side)];
    sensors.leg[index(side)].freshness.age_ticks = 0;
    sensors.foot[index(side)].corner_force_n.fill(weight_n / 8.0 + 0.1 * (tick % 2));
    sensors.foot[index(side)].freshness.age_ticks = 0;
  }
  sensors.torso.specific_force_body_m_s2 = {0.0, 0.0, 9.81};
  sensors.torso.angular_rate_body_rad_s.x() = 5e-4 * (tick % 2);
  sensors.torso.freshness.age_ticks = 0;
  return sensors;
}

JointReference side_by_side(const ControllerConfig& config) {
  FootReference feet;
  for (const Side side : kSides) feet[index(side)].position_body_m = {-0.09, lateral_sign(side) * 0.11, -0.5};
  return kinematics::inverse(config.geometry, feet);
}

TEST(Controller, WalksAnIdealRobotThroughAPayloadWithoutFault) {
  const ControllerConfig config;
  Controller controller(config);
  JointReference joints = side_by_side(config);
  TickOutput out;
  int reflexes = 0;
  for (std::uint32_t tick = 0; tick < 30000; ++tick) {
    out = controller.tick(ideal_sensors(joints, tick, tick < 13200 ? 784.8 : 833.9));
    joints = out.joint_reference;
    reflexes += out.decision.event == decision::ReflexEvent::kPayloadDetected ? 1 : 0;
    ASSERT_EQ(out.tick, tick);
    ASSERT_TRUE(out.joint_reference.is_reachable) << tick;
    ASSERT_EQ(out.fault, safety::Fault::kNone) << tick;
    ASSERT_EQ(out.command[0].mode, LegMode::kTorque);
  }
  EXPECT_EQ(reflexes, 1);
  EXPECT_EQ(out.decision.phase, decision::ReflexPhase::kWalking);
}

TEST(Controller, GivesTheSameBitsForTheSameSensors) {
  const ControllerConfig config;
  Controller one(config);
  Controller other(config);
  const SensorSnapshot sensors = ideal_sensors(side_by_side(config), 0, 784.8);
  for (int k = 0; k < 6000; ++k) {
    const TickOutput a = one.tick(sensors);
    const TickOutput b = other.tick(sensors);
    for (const Side side : kSides) ASSERT_EQ(a.command[index(side)].torque_nm, b.command[index(side)].torque_nm);
  }
}

TEST(Controller, DampsTheLegsWhenNothingIsEverHeard) {
  Controller controller(ControllerConfig{});
  TickOutput out;
  for (std::uint32_t tick = 0; tick < 100; ++tick) {
    SensorSnapshot sensors;
    sensors.tick = tick;
    out = controller.tick(sensors);
  }
  EXPECT_NE(out.fault, safety::Fault::kNone);
  for (const LegCommand& leg : out.command) {
    EXPECT_EQ(leg.mode, LegMode::kDamp);
    EXPECT_EQ(leg.torque_nm, LegVector{});
  }
}

// A robot that hangs in a stand: no torque, no fault, and once it is let down the very run of a controller just
// started.
TEST(Controller, BeginsWhenTheRobotStandsAndNotBefore) {
  const ControllerConfig config;
  Controller waited(config);
  const JointReference standing = side_by_side(config);
  for (std::uint32_t tick = 0; tick < 500; ++tick) {
    const TickOutput out = waited.tick(ideal_sensors(standing, tick, 0.0));
    ASSERT_TRUE(out.is_waiting_for_posture);
    ASSERT_EQ(out.command[0].mode, LegMode::kDamp);
    ASSERT_EQ(out.fault, safety::Fault::kNone);
    ASSERT_EQ(out.decision.time_in_phase_s, 0.0);
  }
  Controller fresh(config);
  JointReference joints = standing;
  for (std::uint32_t tick = 0; tick < 5000; ++tick) {
    const TickOutput late = waited.tick(ideal_sensors(joints, tick, 784.8));
    const TickOutput soon = fresh.tick(ideal_sensors(joints, tick, 784.8));
    ASSERT_FALSE(soon.is_waiting_for_posture);
    for (std::size_t leg = 0; leg < 2; ++leg) ASSERT_EQ(late.command[leg].torque_nm, soon.command[leg].torque_nm);
    ASSERT_EQ(late.estimate.filtered_zmp_x_body_m, soon.estimate.filtered_zmp_x_body_m);
    ASSERT_EQ(late.decision.phase, soon.decision.phase);
    joints = soon.joint_reference;
  }
}

TEST(Controller, StandsUpOnceAndDoesNotAskForThePostureAgain) {
  const ControllerConfig config;
  Controller controller(config);
  JointReference joints = side_by_side(config);
  static_cast<void>(controller.tick(ideal_sensors(joints, 0, 784.8)));
  joints.angle_rad[1][0] += 0.2;
  const TickOutput out = controller.tick(ideal_sensors(joints, 1, 784.8));
  EXPECT_FALSE(out.is_waiting_for_posture);
}

TEST(Controller, StopsInTheTickAfterAReportedFaultAndHoldsItsStance) {
  const ControllerConfig config;
  Controller controller(config);
  JointReference joints = side_by_side(config);
  TickOutput out;
  for (std::uint32_t tick = 0; tick < 9000; ++tick) {
    const bool is_told = tick == 6000;
    const safety::Finding told = is_told ? safety::finding_of(safety::Fault::kLoopOverrun) : safety::Finding{};
    out = controller.tick(ideal_sensors(joints, tick, 784.8), told);
    joints = out.joint_reference;
    ASSERT_EQ(out.decision.phase == decision::ReflexPhase::kStopped, tick > 6000) << tick;
    ASSERT_EQ(out.fault, tick < 6000 ? safety::Fault::kNone : safety::Fault::kLoopOverrun);
    ASSERT_EQ(out.safe_state, tick < 6000 ? safety::SafeState::kNone : safety::SafeState::kStanceHold);
    ASSERT_EQ(out.command[0].mode, LegMode::kTorque);
  }
  for (const Side side : kSides) EXPECT_EQ(out.foot_reference[index(side)].position_body_m.z(), -0.5);
}

TEST(Controller, DampsForGoodWhenAFaultComesWhileItWaitsForThePosture) {
  const ControllerConfig config;
  Controller controller(config);
  JointReference folded = side_by_side(config);
  folded.angle_rad[0][0] += 0.5;
  static_cast<void>(controller.tick(ideal_sensors(folded, 0, 784.8), safety::finding_of(safety::Fault::kLoopOverrun)));
  const TickOutput out = controller.tick(ideal_sensors(side_by_side(config), 1, 784.8));
  EXPECT_EQ(out.safe_state, safety::SafeState::kDamp);
  EXPECT_EQ(out.command[1].mode, LegMode::kDamp);
  EXPECT_FALSE(out.is_waiting_for_posture);
}

}  // namespace
}  // namespace surefoot
