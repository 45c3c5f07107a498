#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "sim_hw/world/corner_contact.hpp"
#include "tests/unit/sim_hw/momentum.hpp"
#include "tests/unit/sim_hw/standing.hpp"

namespace surefoot::sim_hw {
namespace {

using geometry::Matrix3;
using geometry::Vector3;

double within(double lowest, double highest) {
  const auto share = *rc::gen::inRange<std::int32_t>(0, 1'000'001);
  return lowest + (highest - lowest) * 1.0e-6 * share;
}

Vector3 vector_within(double bound) { return {within(-bound, bound), within(-bound, bound), within(-bound, bound)}; }

PerSide<LegVector> joints_within(double bound) {
  PerSide<LegVector> value;
  for (LegVector& leg : value) {
    for (double& joint : leg) joint = within(-bound, bound);
  }
  return value;
}

Matrix3 any_rotation() {
  const Vector3 turn = vector_within(3.0);
  return turn.norm() < 1e-9 ? Matrix3::Identity()
                            : Matrix3(Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix());
}

btMatrix3x3 to_basis(const Matrix3& m) {
  return {m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1), m(2, 2)};
}

RC_GTEST_PROP(CornerContactProperty, NeverPullsAndStaysInTheFrictionCone, ()) {
  ContactConfig config;
  config.friction = within(0.0, 1.5);
  CornerContact contact({}, config);
  for (int i = 0; i < 20; ++i) {  // anchors carry over
    BodyMotion foot;
    foot.rotation_world_from_body = to_basis(any_rotation());
    foot.position_m = to_bullet(Vector3(0.02 * vector_within(1.0)));
    foot.velocity_m_s = to_bullet(vector_within(3.0));
    foot.angular_rad_s = to_bullet(vector_within(10.0));
    const SoleWrench wrench = contact.step(foot);
    for (const double normal_n : wrench.load.normal_n) RC_ASSERT(normal_n >= 0.0);
    const double tangential_n = std::hypot(wrench.force_world_n.x(), wrench.force_world_n.y());
    RC_ASSERT(tangential_n <= config.friction * wrench.load.normal_sum_n() * (1.0 + 1e-12));
    RC_ASSERT(std::abs(wrench.force_world_n.z() - wrench.load.normal_sum_n()) <=
              1e-9 * (1.0 + wrench.load.normal_sum_n()));
  }
}

RC_GTEST_PROP(RobotModelProperty, AgreesWithTheFirmwareOnWhereTheFeetAre, ()) {
  const SimConfig config;
  RobotModel robot(config.geometry, config.mass, config.drive);
  const PerSide<LegVector> angle = joints_within(1.5);
  const Matrix3 rotation = any_rotation();
  const Vector3 position = vector_within(10.0);
  robot.set_joints(angle, {});
  robot.place_body(position, rotation, Vector3::Zero(), Vector3::Zero());
  for (const Side side : kSides) {
    const kinematics::FootPose pose = kinematics::forward(config.geometry, side, angle[index(side)]);
    const BodyMotion foot = robot.foot_motion(side);
    RC_ASSERT((from_bullet(foot.position_m) - position - rotation * pose.position_body_m).norm() < 1e-12);
    RC_ASSERT((from_bullet(foot.rotation_world_from_body) - rotation * pose.rotation_body_from_foot).norm() < 1e-12);
  }
}

RC_GTEST_PROP(RobotModelProperty, TakesAnyLoadWithoutAJumpOfAnyPoint, ()) {
  RobotModel robot({}, {}, {});
  robot.set_joints(joints_within(1.5), joints_within(3.0));
  robot.place_body(vector_within(10.0), any_rotation(), vector_within(2.0), vector_within(3.0));
  for (int i = 0; i < 3; ++i) {
    PayloadConfig payload;
    payload.mass_kg = within(0.0, 40.0);
    payload.position_m = {within(-0.5, 0.5), within(-0.5, 0.5), within(-0.5, 1.0)};
    payload.inertia = *rc::gen::arbitrary<bool>() ? PayloadInertia::kThesis : PayloadInertia::kExact;
    const auto before = robot.motions();
    const Vector3 momentum_before = testing::momentum(robot).linear_n_s;
    const Vector3 spin = robot.rotation_world_from_body() * robot.body_rate_body_rad_s();
    const Vector3 arm =
        robot.rotation_world_from_body() * Vector3(payload.position_m[0], payload.position_m[1], payload.position_m[2]);
    const Vector3 load_velocity = robot.body_velocity_world_m_s() + spin.cross(arm);
    robot.set_trunk(hang_payload(robot.trunk(), payload));
    const auto after = robot.motions();
    for (std::size_t link = 0; link < RobotModel::kLinks; ++link) {
      RC_ASSERT((after[link].position_m - before[link].position_m).length() < 1e-12);
      RC_ASSERT((after[link].velocity_m_s - before[link].velocity_m_s).length() < 1e-12);
    }
    const Vector3 gained = testing::momentum(robot).linear_n_s - momentum_before;
    RC_ASSERT((gained - payload.mass_kg * load_velocity).norm() < 1e-9);
    // The diagonal alone must still belong to a body.
    const Vector3 inertia = robot.trunk().inertia_kg_m2;
    RC_ASSERT(inertia.minCoeff() > 0.0);
    RC_ASSERT(2.0 * inertia.maxCoeff() <= inertia.sum() * (1.0 + 1e-12));
  }
}

PayloadConfig any_box() {
  PayloadConfig payload;
  payload.mass_kg = within(0.0, 40.0);
  payload.position_m = {within(-0.5, 0.5), within(-0.5, 0.5), within(-0.5, 1.0)};
  payload.inertia = *rc::gen::arbitrary<bool>() ? PayloadInertia::kThesis : PayloadInertia::kExact;
  return payload;
}

RC_GTEST_PROP(WorldProperty, IsAfterAnyRemovalAsIfOnlyTheRestHadBeenHungOn, ()) {
  World world(SimConfig{}, testing::stance({}));
  world.robot().set_joints(joints_within(1.5), joints_within(3.0));
  world.robot().place_body(vector_within(10.0), any_rotation(), vector_within(2.0), vector_within(3.0));
  std::vector<PayloadConfig> boxes;
  for (int i = *rc::gen::inRange(1, 7); i > 0; --i) boxes.push_back(any_box());
  std::vector<bool> hangs(boxes.size(), true);
  for (const PayloadConfig& box : boxes) world.hang(box);
  const auto removals = *rc::gen::container<std::vector<std::size_t>>(rc::gen::inRange<std::size_t>(0, boxes.size()));
  for (const std::size_t place : removals) {
    const auto before = world.robot().motions();
    world.take_off(place);
    hangs[place] = false;
    const auto after = world.robot().motions();
    for (std::size_t link = 0; link < RobotModel::kLinks; ++link) {
      RC_ASSERT((after[link].position_m - before[link].position_m).length() < 1e-12);
      RC_ASSERT((after[link].velocity_m_s - before[link].velocity_m_s).length() < 1e-12);
      RC_ASSERT((after[link].angular_rad_s - before[link].angular_rad_s).length() < 1e-12);
    }
  }
  World rest(SimConfig{}, testing::stance({}));
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (hangs[i]) rest.hang(boxes[i]);
  }
  const TrunkMass& trunk = world.robot().trunk();
  RC_ASSERT(std::abs(trunk.mass_kg - rest.robot().trunk().mass_kg) < 1e-12);
  RC_ASSERT((trunk.com_body_m - rest.robot().trunk().com_body_m).norm() < 1e-12);
  RC_ASSERT((trunk.inertia_kg_m2 - rest.robot().trunk().inertia_kg_m2).norm() < 1e-12);
}

}  // namespace
}  // namespace surefoot::sim_hw
