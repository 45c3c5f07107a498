#include "sim_hw/world/slope.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "tests/unit/sim_hw/held_robot.hpp"
#include "tests/unit/sim_hw/momentum.hpp"

namespace surefoot::sim_hw {
namespace {

using geometry::Vector3;
using testing::StandingRobot;

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;
constexpr double kAccelerometerStep_m_s2 = 0.005;  // surefoot.dbc

SimConfig on_slope(double pitch_deg, double roll_deg) {
  SimConfig config;
  config.contact.slope_pitch_deg = pitch_deg;
  config.contact.slope_roll_deg = roll_deg;
  return config;
}

TEST(Slope, OfALevelFloorLeavesGravityAsItIsToTheBit) {
  const Vector3 gravity = gravity_floor_m_s2({});
  EXPECT_EQ(gravity.z(), -kGravityM_S2);
  for (const double across : {gravity.x(), gravity.y()}) {
    EXPECT_EQ(across, 0.0);
    EXPECT_FALSE(std::signbit(across)) << "a negative zero would change sums of zeros";
  }
}

// The torso's convention, z-y-x: gravity as seen by a body that is turned so.
TEST(Slope, TurnsAsATorsoDoes) {
  const double pitch = -7.0 * kRadiansPerDegree;
  const double roll = 4.0 * kRadiansPerDegree;
  const geometry::Matrix3 level_from_floor =
      (Eigen::AngleAxisd(pitch, Vector3::UnitY()) * Eigen::AngleAxisd(roll, Vector3::UnitX())).toRotationMatrix();
  const Vector3 expected = level_from_floor.transpose() * Vector3(0.0, 0.0, -kGravityM_S2);
  EXPECT_LT((gravity_floor_m_s2(on_slope(-7.0, 4.0).contact) - expected).norm(), 1e-14);
}

TEST(Slope, PullsAheadWhenItsPitchIsPositiveAndToTheRightWhenItsRollIs) {
  EXPECT_GT(gravity_floor_m_s2(on_slope(3.0, 0.0).contact).x(), 0.0) << "downhill ahead";
  EXPECT_LT(gravity_floor_m_s2(on_slope(0.0, 3.0).contact).y(), 0.0) << "y points left";
}

// Statics on an inclined plane: normal m g cos, along it m g sin; the ZMP moves downhill by h tan, h the height of the
// centre of mass.
TEST(Slope, MovesTheZmpDownhillByHeightTimesTangentOnEitherFloor) {
  for (const ContactModel model : {ContactModel::kSpringDamper, ContactModel::kBullet}) {
    for (const auto& [pitch_deg, roll_deg] : {std::pair{3.0, 0.0}, {-3.0, 0.0}, {0.0, 3.0}}) {
      SimConfig config = on_slope(pitch_deg, roll_deg);
      config.contact.model = model;
      StandingRobot robot(config);
      robot.stand(1.5);
      const testing::Momentum body = testing::momentum(robot.world.robot());
      const double tangent_x = std::tan(pitch_deg * kRadiansPerDegree);
      const double tangent_y = -std::tan(roll_deg * kRadiansPerDegree);
      const double normal_n =
          80.0 * kGravityM_S2 * std::cos(pitch_deg * kRadiansPerDegree) * std::cos(roll_deg * kRadiansPerDegree);
      EXPECT_NEAR(robot.carried_n(), normal_n, 0.005 * normal_n);
      const btVector3 moment =
          robot.world.loads()[0].normal_moment_world_nm + robot.world.loads()[1].normal_moment_world_nm;
      const double height_m = body.com_world_m.z();
      EXPECT_GT(height_m, 0.5);
      EXPECT_NEAR(moment.x() / robot.carried_n() - body.com_world_m.x(), height_m * tangent_x, 0.002);
      EXPECT_NEAR(moment.y() / robot.carried_n() - body.com_world_m.y(), height_m * tangent_y, 0.002);
    }
  }
}

// Coulomb: at rest while mu > tan(slope), else downhill with g (sin - mu cos).
TEST(Slope, HoldsTheSolesAboveTheTangentInFrictionAndLetsThemSlideBelow) {
  SimConfig sticky = on_slope(3.0, 0.0);  // tan 3 degrees = 0.0524
  sticky.contact.friction = 0.06;
  SimConfig slippery = sticky;
  slippery.contact.friction = 0.04;
  StandingRobot holds(sticky);
  StandingRobot slides(slippery);
  holds.stand(1.0);
  slides.stand(0.5);  // the soles' shear springs let go
  const double begin_m_s = slides.world.robot().body_velocity_world_m_s().x();
  slides.stand(0.5);
  const double gained_m_s = slides.world.robot().body_velocity_world_m_s().x() - begin_m_s;
  const double acceleration_m_s2 =
      kGravityM_S2 * (std::sin(3.0 * kRadiansPerDegree) - 0.04 * std::cos(3.0 * kRadiansPerDegree));
  EXPECT_LT(std::abs(holds.world.robot().body_position_world_m().x()), 0.005);
  EXPECT_NEAR(gained_m_s, 0.5 * acceleration_m_s2, 0.02 * acceleration_m_s2);
}

// An accelerometer at rest feels the floor's push against gravity, in its own axes; a gyro feels nothing.
TEST(Slope, IsFeltByTheTorsosAccelerometerFromTheFirstTickOnAndNotByItsGyro) {
  testing::HeldRobot held(on_slope(-5.0, 2.0));
  const Vector3 felt = -gravity_floor_m_s2(on_slope(-5.0, 2.0).contact);
  held.puppeteer.sync();
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(held.puppeteer.imu.specific_force_body_m_s2[axis], felt[axis], kAccelerometerStep_m_s2);
  }
  held.puppeteer.command(held.wanted());
  held.stand(1.5);
  // The drives give by some milliradians, so the truth of the torso turns what is expected; and the encoders' steps let
  // the joints tremble, so it is a mean.
  constexpr int kTicks = 500;
  Vector3 difference = Vector3::Zero();
  Vector3 spin = Vector3::Zero();
  for (int i = 0; i < kTicks; ++i) {
    held.tick();
    const GroundTruth& truth = held.robot.truth();
    const geometry::Matrix3 floor_from_body =
        (Eigen::AngleAxisd(truth.yaw_rad, Vector3::UnitZ()) * Eigen::AngleAxisd(truth.pitch_rad, Vector3::UnitY()) *
         Eigen::AngleAxisd(truth.roll_rad, Vector3::UnitX()))
            .toRotationMatrix();
    const Vector3 expected = floor_from_body.transpose() * felt;
    for (int axis = 0; axis < 3; ++axis) {
      difference[axis] += (held.puppeteer.imu.specific_force_body_m_s2[axis] - expected[axis]) / kTicks;
      spin[axis] += held.puppeteer.imu.angular_rate_body_rad_s[axis] / kTicks;
    }
  }
  EXPECT_LT(difference.norm(), kAccelerometerStep_m_s2);
  EXPECT_LT(spin.norm(), 1e-3);
  EXPECT_NEAR(held.robot.truth().pitch_rad, 0.0, 5e-3)
      << "against the floor's normal, not 5 degrees against the vertical";
}

}  // namespace
}  // namespace surefoot::sim_hw
