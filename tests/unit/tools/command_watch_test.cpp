#include "tools/faults/command_watch.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace surefoot::faults {
namespace {

constexpr double kPeriodS = 1.0e-3;

PerSide<LegSensors> legs_at(double angle_rad) {
  PerSide<LegSensors> legs;
  for (LegSensors& leg : legs) {
    leg.angle_rad.fill(angle_rad);
    leg.freshness.age_ticks = 0;
  }
  return legs;
}

PerSide<LegCommand> angles(double angle_rad) {
  PerSide<LegCommand> command{};
  for (LegCommand& leg : command) {
    leg.mode = LegMode::kPosition;
    leg.angle_rad.fill(angle_rad);
  }
  return command;
}

struct CommandWatchTest : ::testing::Test {
  safety::OutputGateConfig gate{};
  double most_rad = gate.reference_rate_limit_rad_s * kPeriodS;
  CommandWatch watch{gate, kPeriodS};
};

TEST_F(CommandWatchTest, LetsAnglesGoAsFarInATickAsTheGateDoesAndNoFarther) {
  watch.observe(angles(0.1), legs_at(0.1));
  watch.observe(angles(0.1 + most_rad), legs_at(0.1));
  EXPECT_TRUE(watch.extremes().is_within_gate);
  EXPECT_NEAR(watch.extremes().angle_step_rad, most_rad, 1e-12);
  PerSide<LegCommand> jump = angles(0.1 + most_rad);
  jump[1].angle_rad[4] += 1.01 * most_rad;
  watch.observe(jump, legs_at(0.1));
  EXPECT_FALSE(watch.extremes().is_within_gate);
}

TEST_F(CommandWatchTest, LetsTheFirstAngleBeginWhereTheJointStandsAndNowhereElse) {
  watch.observe({}, legs_at(0.4));
  watch.observe(angles(0.4), legs_at(0.4));
  EXPECT_TRUE(watch.extremes().is_within_gate);
  CommandWatch far(gate, kPeriodS);
  far.observe(angles(0.3), legs_at(0.4));
  EXPECT_FALSE(far.extremes().is_within_gate);
}

TEST_F(CommandWatchTest, LetsABoardThatDampedBeginAnewWhereItsJointsHaveGone) {
  watch.observe(angles(0.1), legs_at(0.1));
  PerSide<LegSensors> sunk = legs_at(0.4);
  for (LegSensors& leg : sunk) leg.is_damping = true;
  watch.observe(angles(0.4), sunk);
  EXPECT_TRUE(watch.extremes().is_within_gate);
  for (LegSensors& leg : sunk) leg.freshness.age_ticks = 1;  // old news: it may obey by now
  watch.observe(angles(0.8), sunk);
  EXPECT_FALSE(watch.extremes().is_within_gate);
}

TEST_F(CommandWatchTest, AccusesAnAngleOutsideItsRangeAndOneThatIsNoNumber) {
  const double beyond_rad = gate.angle_max_rad[3] + 1e-6;
  for (const double bad : {beyond_rad, std::numeric_limits<double>::quiet_NaN()}) {
    CommandWatch one(gate, kPeriodS);
    PerSide<LegCommand> command = angles(0.1);
    PerSide<LegSensors> legs = legs_at(0.1);
    command[0].angle_rad[3] = legs[0].angle_rad[3] = bad;
    one.observe(command, legs);
    EXPECT_FALSE(one.extremes().is_within_gate) << bad;
  }
}

TEST_F(CommandWatchTest, JudgesTorquesByLimitAndStepAsBefore) {
  PerSide<LegCommand> command{};
  for (LegCommand& leg : command) leg.mode = LegMode::kTorque;
  command[0].torque_nm[2] = gate.torque_limit_nm;
  watch.observe(command, legs_at(0.0));
  EXPECT_TRUE(watch.extremes().is_within_gate);
  EXPECT_EQ(watch.extremes().torque_nm, gate.torque_limit_nm);
  EXPECT_EQ(watch.extremes().angle_step_rad, 0.0);
  command[0].torque_nm[2] = -gate.torque_limit_nm - 1.0;
  watch.observe(command, legs_at(0.0));
  EXPECT_FALSE(watch.extremes().is_within_gate);
}

}  // namespace
}  // namespace surefoot::faults
