#include <gtest/gtest.h>

#include "sim_hw/nodes/foot_node.hpp"
#include "sim_hw/nodes/imu_node.hpp"
#include "tests/unit/sim_hw/wire.hpp"

namespace surefoot::sim_hw {
namespace {

using geometry::Vector3;

TEST(ImuNode, SendsWhatTheTorsoFeels) {
  ImuNode node({}, 1);
  FrameOutbox outbox;
  testing::Wire wire;
  node.on_sync(77, {.angular_rate_body_rad_s = {0.5, -1.0, 1.5}, .specific_force_body_m_s2 = {1.0, -2.0, 9.5}}, outbox);
  outbox.flush(wire);
  ASSERT_EQ(wire.from_robot.size(), 1U);
  can::FrameStamp stamp;
  ImuSensors imu;
  ASSERT_EQ(can::decode_imu(wire.from_robot[0], stamp, imu), can::Rejection::kNone);
  EXPECT_EQ(stamp.tick, 77U);
  EXPECT_LT((imu.angular_rate_body_rad_s - Vector3(0.5, -1.0, 1.5)).norm(), 1e-3);
  EXPECT_LT((imu.specific_force_body_m_s2 - Vector3(1.0, -2.0, 9.5)).norm(), 1e-2);
}

TEST(FootNode, SendsEachCornerInItsPlaceToItsResolution) {
  FootNode node(Side::kLeft, {.force_resolution_n = 0.5}, 1);
  FrameOutbox outbox;
  testing::Wire wire;
  node.on_sync(5, {100.2, 200.3, 300.0, 0.0}, outbox);
  outbox.flush(wire);
  ASSERT_EQ(wire.from_robot.size(), 1U);
  EXPECT_EQ(wire.from_robot[0].identifier, can::state_identifier(can::Node::kFootLeft));
  can::FrameStamp stamp;
  FootSensors foot;
  ASSERT_EQ(can::decode_foot_force(wire.from_robot[0], stamp, foot), can::Rejection::kNone);
  constexpr std::array<double, 4> kExpected{100.0, 200.5, 300.0, 0.0};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(foot.corner_force_n[i], kExpected[i], 1e-9);
}

}  // namespace
}  // namespace surefoot::sim_hw
