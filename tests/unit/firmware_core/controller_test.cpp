#include "firmware/core/controller.hpp"

#include <gtest/gtest.h>

#include "firmware/core/kinematics/leg_kinematics.hpp"

namespace surefoot {
namespace {

/// Every node fresh, the legs exactly where the last reference wanted them, the weight evenly on the soles.
SensorSnapshot ideal_sensors(const JointReference& joints, std::uint32_t tick, double weight_n) {
  SensorSnapshot sensors;
  sensors.tick = tick;
  for (const Side side : kSides) {
    sensors.leg[index(side)].angle_rad = joints.angle_rad[index(side)];
    sensors.leg[index(side)].rate_rad_s = joints.rate_rad_s[index(side)];
    sensors.leg[index(side)].freshness.age_ticks = 0;
    sensors.foot[index(side)].corner_force_n.fill(weight_n / 8.0);
    sensors.foot[index(side)].freshness.age_ticks = 0;
  }
  sensors.torso.specific_force_body_m_s2 = {0.0, 0.0, 9.81};
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

}  // namespace
}  // namespace surefoot
