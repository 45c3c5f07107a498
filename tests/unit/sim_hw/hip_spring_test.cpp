#include "sim_hw/world/hip_spring.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim_hw/world/world.hpp"
#include "tests/unit/sim_hw/standing.hpp"

namespace surefoot::sim_hw {
namespace {

constexpr double kStepS = 5.0e-4;
constexpr std::size_t kHipRoll = index(LegJoint::kHipRoll);

DriveConfig undamped(double stiffness_nm_per_rad) {
  DriveConfig drive;
  drive.hip_knee_friction_nm_s_per_rad = 0.0;
  drive.hip_roll_stiffness_nm_per_rad = stiffness_nm_per_rad;
  drive.hip_roll_damping_nm_s_per_rad = 0.0;
  return drive;
}

/// Frequency of a swing, from its first and last upward zero crossing.
class Crossings {
 public:
  void add(double time_s, double value) {
    if (last_ < 0.0 && value >= 0.0) {
      const double at_s = time_s - kStepS * value / (value - last_);
      if (count_++ == 0) first_s_ = at_s;
      end_s_ = at_s;
    }
    last_ = value;
  }
  [[nodiscard]] double rate_rad_s() const { return 2.0 * std::numbers::pi * (count_ - 1) / (end_s_ - first_s_); }

 private:
  double last_ = 0.0;
  double first_s_ = 0.0;
  double end_s_ = 0.0;
  int count_ = 0;
};

// Symplectic Euler swings at 2/h asin(w h / 2), w the continuous frequency.
double sampled_rate_rad_s(double rate_rad_s) { return 2.0 / kStepS * std::asin(0.5 * kStepS * rate_rad_s); }

TEST(HipSpring, MotorAgainstAFastLegSwingsAtSqrtKOverJ) {
  HipSpring spring(undamped(1500.0), 0.1);  // 0.4 kg m2; the leg is held at 0
  Crossings crossings;
  for (int i = 0; i < 20000; ++i) {
    (void)spring.step(0.0, 0.0, 0.0, kStepS);
    crossings.add(i * kStepS, spring.angle_rad());
  }
  EXPECT_NEAR(crossings.rate_rad_s(), sampled_rate_rad_s(std::sqrt(1500.0 / 0.4)), 1e-3);
}

TEST(HipSpring, AFreeMotorAndAFlywheelSwingAgainstEachOther) {
  constexpr double kFlywheel_kg_m2 = 2.0;
  HipSpring spring(undamped(1500.0), 0.1);
  double angle = 0.0;
  double rate = 0.0;
  Crossings crossings;
  double highest_j = 0.0;
  double lowest_j = 1e9;
  for (int i = 0; i < 20000; ++i) {
    rate += kStepS * spring.step(0.0, angle, rate, kStepS) / kFlywheel_kg_m2;
    angle += kStepS * rate;
    const double twist = spring.angle_rad() - angle;
    crossings.add(i * kStepS, twist);
    const double energy_j = 0.5 * (0.4 * spring.rate_rad_s() * spring.rate_rad_s() + kFlywheel_kg_m2 * rate * rate +
                                   1500.0 * twist * twist);
    highest_j = std::max(highest_j, energy_j);
    lowest_j = std::min(lowest_j, energy_j);
    ASSERT_NEAR(0.4 * spring.rate_rad_s() + kFlywheel_kg_m2 * rate, 0.0, 1e-9) << "action is reaction";
  }
  EXPECT_NEAR(crossings.rate_rad_s(), sampled_rate_rad_s(std::sqrt(1500.0 * (1.0 / 0.4 + 1.0 / kFlywheel_kg_m2))),
              1e-3);
  // A symplectic step lets the energy waver by w h, and never drift.
  EXPECT_LT(highest_j / lowest_j, 1.05);
}

TEST(HipSpring, NoDampingAndNoFrictionIsTooLargeForTheStep) {
  DriveConfig drive = undamped(1500.0);
  drive.rotor_inertia_kg_m2 = 0.01;
  drive.hip_knee_friction_nm_s_per_rad = 100.0;  // 0.1 ms, a fifth of the step
  HipSpring spring(drive, 0.1);
  double before = 0.1;
  for (int i = 0; i < 2000; ++i) {
    (void)spring.step(0.0, 0.0, 0.0, kStepS);
    ASSERT_LE(std::abs(spring.angle_rad()), before);
    before = std::abs(spring.angle_rad());
  }
  EXPECT_LT(before, 1e-3);
}

// J from the tree itself: the acceleration that unit torques at the joints give. Both legs mirrored, so that their two
// springs swing as one.
TEST(HipSpring, TheLegsOfARobotInTheAirSwingAsItsMassMatrixSays) {
  SimConfig config;
  config.drive = undamped(1500.0);
  config.drive.ankle_friction_nm_s_per_rad = 0.0;
  World world(config, {});
  RobotModel& robot = world.robot();
  RobotModel probe(config.geometry, config.mass, config.drive, geometry::Vector3::Zero());
  PerSide<LegVector> torque{};
  torque[0][kHipRoll] = 1.0;
  torque[1][kHipRoll] = -1.0;
  probe.drive_joints(torque);
  probe.integrate(kStepS);
  const double compliance = probe.rates_rad_s()[0][kHipRoll] / kStepS;  // 1/J of the leg's side
  EXPECT_GT(compliance, 0.2);

  robot.place_body({0.0, 0.0, 100.0}, geometry::Matrix3::Identity(), geometry::Vector3::Zero(),
                   geometry::Vector3::Zero());  // falls freely: gravity is not felt
  PerSide<LegVector> bent{};
  bent[0][kHipRoll] = 1e-4;  // small: the mass matrix stays
  bent[1][kHipRoll] = -1e-4;
  robot.set_joints(bent, {});
  Crossings crossings;
  for (int i = 0; i < 2000; ++i) {
    world.advance({}, kStepS);
    crossings.add(i * kStepS, world.motor_angles_rad()[0][kHipRoll] - robot.angles_rad()[0][kHipRoll]);
  }
  const double expected = std::sqrt(1500.0 * (compliance + 1.0 / 0.4));
  EXPECT_NEAR(crossings.rate_rad_s(), sampled_rate_rad_s(expected), 0.002 * expected);
}

TEST(HipSpring, OfZeroStiffnessIsNoneAndEncodersSeeTheJoints) {
  SimConfig config;
  testing::StandingRobot robot(config);
  robot.stand(0.1);
  EXPECT_EQ(robot.world.motor_angles_rad(), robot.world.robot().angles_rad());
  EXPECT_EQ(robot.world.motor_rates_rad_s(), robot.world.robot().rates_rad_s());
}

// Statics: the spring carries the motor's torque, so motor and joint differ by torque / k.
TEST(HipSpring, GivesByTorqueOverStiffnessUnderAStandingRobot) {
  SimConfig config;
  config.drive.hip_roll_stiffness_nm_per_rad = 5000.0;
  config.contact.slope_roll_deg = 3.0;  // else the weight goes straight down through the hips
  const PerSide<LegVector> pose = testing::stance(config.geometry);
  World world(config, pose);
  PerSide<LegVector> torque{};
  for (int i = 0; i < 6000; ++i) {
    torque = testing::hold(pose, world.motor_angles_rad(), world.motor_rates_rad_s());
    world.advance(torque, kStepS);
  }
  for (const Side side : kSides) {
    const double twist =
        world.motor_angles_rad()[index(side)][kHipRoll] - world.robot().angles_rad()[index(side)][kHipRoll];
    EXPECT_NEAR(twist, torque[index(side)][kHipRoll] / 5000.0, 1e-6);
    EXPECT_GT(std::abs(twist), 1e-5);
  }
}

}  // namespace
}  // namespace surefoot::sim_hw
