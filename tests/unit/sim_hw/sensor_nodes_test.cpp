#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "sim_hw/nodes/foot_node.hpp"
#include "sim_hw/nodes/imu_node.hpp"
#include "sim_hw/nodes/leg_board.hpp"
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
  node.on_sync(5, {100.2, 200.3, 300.0, 0.0}, {}, outbox);
  outbox.flush(wire);
  ASSERT_EQ(wire.from_robot.size(), 1U);
  EXPECT_EQ(wire.from_robot[0].identifier, can::state_identifier(can::Node::kFootLeft));
  can::FrameStamp stamp;
  FootSensors foot;
  ASSERT_EQ(can::decode_foot_force(wire.from_robot[0], stamp, foot), can::Rejection::kNone);
  constexpr std::array<double, 4> kExpected{100.0, 200.5, 300.0, 0.0};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(foot.corner_force_n[i], kExpected[i], 1e-9);
}

/// A leg board and a foot with inertial sensors; what they send of these in one tick.
struct InertialNodes {
  explicit InertialNodes(const SensorConfig& sensor, std::vector<FaultConfig> faults = {}) {
    config.sensor = sensor;
    config.sensor.has_inertial_legs = true;
    config.faults = std::move(faults);
    board.emplace(Side::kRight, config);
    foot.emplace(Side::kRight, config.sensor, config.seed,
                 SensorFaults(config.faults, FaultTarget::kFootRight, config.seed, config.control_period_s));
  }

  void tick(std::uint32_t tick, const LegInertialMotion& motion) {
    FrameOutbox outbox;
    testing::Wire wire;
    for (SensorFaults* faults : {&board->faults(), &foot->faults()}) faults->begin_tick(1.0, tick);
    board->on_sync(tick, {}, {}, motion, outbox);
    foot->on_sync(tick, {}, motion, outbox);
    outbox.flush(wire);
    ASSERT_EQ(wire.from_robot.size(), 4U);
    ASSERT_EQ(can::decode_leg_inertial(wire.from_robot[1], stamp, leg_sensors), can::Rejection::kNone);
    ASSERT_EQ(can::decode_foot_inertial(wire.from_robot[3], stamp, foot_sensors), can::Rejection::kNone);
  }

  SimConfig config;
  std::optional<LegBoard> board;
  std::optional<FootNode> foot;
  can::FrameStamp stamp;
  LegInertialSensors leg_sensors;
  FootInertialSensors foot_sensors;
};

constexpr std::uint32_t kTick = 777;

LegInertialMotion some_motion(double scale = 1.0) {
  return {.hip_roll_rate_rad_s = 0.5 * scale,
          .sole_roll_rad = 0.02 * scale,
          .sole_pitch_rad = -0.03 * scale,
          .specific_force_foot_m_s2 = scale * Vector3(1.0, -2.0, 9.0)};
}

TEST(InertialNodes, SendEachValueInItsPlace) {
  InertialNodes nodes({});
  nodes.tick(kTick, some_motion());
  EXPECT_EQ(nodes.stamp.tick, kTick);
  EXPECT_NEAR(nodes.leg_sensors.hip_roll_rate_rad_s, 0.5, 1e-9);
  EXPECT_NEAR(nodes.foot_sensors.roll_rad, 0.02, 1e-9);
  EXPECT_NEAR(nodes.foot_sensors.pitch_rad, -0.03, 1e-9);
  EXPECT_NEAR(nodes.foot_sensors.specific_force_x_foot_m_s2, 1.0, 1e-9);
  EXPECT_NEAR(nodes.foot_sensors.specific_force_y_foot_m_s2, -2.0, 1e-9);
}

// Kim, Park, Oh 2007, Table 2: 100 deg/s, 15 degrees, 2 g.
TEST(InertialNodes, TellNoMoreThanTheirRangeInEitherDirection) {
  for (const double sign : {1.0, -1.0}) {
    InertialNodes nodes({});
    nodes.tick(kTick, some_motion(sign * 100.0));
    EXPECT_NEAR(nodes.leg_sensors.hip_roll_rate_rad_s, sign * 1.745, 1e-9);
    EXPECT_NEAR(nodes.foot_sensors.roll_rad, sign * 0.262, 1e-9);
    EXPECT_NEAR(nodes.foot_sensors.pitch_rad, sign * -0.262, 1e-9);
    EXPECT_NEAR(nodes.foot_sensors.specific_force_x_foot_m_s2, sign * 19.62, 1e-9);
    EXPECT_NEAR(nodes.foot_sensors.specific_force_y_foot_m_s2, sign * -19.62, 1e-9);
  }
}

TEST(InertialNodes, HaveEachTheNoiseOfItsKind) {
  constexpr int kSamples = 4000;
  InertialNodes nodes(
      {.hip_gyro_noise_rad_s = 0.02, .inclinometer_noise_rad = 0.003, .foot_accelerometer_noise_m_s2 = 0.4});
  std::array<double, 5> squares{};
  for (int i = 0; i < kSamples; ++i) {
    nodes.tick(kTick, {});
    const FootInertialSensors& foot = nodes.foot_sensors;
    const std::array<double, 5> read{nodes.leg_sensors.hip_roll_rate_rad_s, foot.roll_rad, foot.pitch_rad,
                                     foot.specific_force_x_foot_m_s2, foot.specific_force_y_foot_m_s2};
    for (std::size_t k = 0; k < read.size(); ++k) squares[k] += read[k] * read[k] / kSamples;
  }
  constexpr std::array<double, 5> kDeviation{0.02, 0.003, 0.003, 0.4, 0.4};
  for (std::size_t i = 0; i < squares.size(); ++i) {
    EXPECT_NEAR(std::sqrt(squares[i]), kDeviation[i], 0.05 * kDeviation[i]) << i;
  }
}

TEST(InertialNodes, GoWrongAsTheScenarioSaysAndOnlyWhereItSaysSo) {
  const auto saturated = [](FaultTarget target, FaultSignal signal) {
    return FaultConfig{
        .kind = FaultKind::kSaturate, .target = target, .signal = signal, .at_s = 0.0, .for_s = 5.0, .value = 0.01};
  };
  InertialNodes hip({}, {saturated(FaultTarget::kLegRight, FaultSignal::kHipGyro)});
  hip.tick(kTick, some_motion());
  EXPECT_NEAR(hip.leg_sensors.hip_roll_rate_rad_s, 0.01, 1e-9);
  EXPECT_NEAR(hip.foot_sensors.roll_rad, 0.02, 1e-9);
  InertialNodes tilt({}, {saturated(FaultTarget::kFootRight, FaultSignal::kInclinometer)});
  tilt.tick(kTick, some_motion());
  EXPECT_NEAR(tilt.foot_sensors.roll_rad, 0.01, 1e-9);
  EXPECT_NEAR(tilt.foot_sensors.pitch_rad, -0.01, 1e-9);
  EXPECT_NEAR(tilt.foot_sensors.specific_force_x_foot_m_s2, 1.0, 1e-9);
  InertialNodes force({}, {saturated(FaultTarget::kFootRight, FaultSignal::kFootAccelerometer)});
  force.tick(kTick, some_motion());
  EXPECT_NEAR(force.foot_sensors.roll_rad, 0.02, 1e-9);
  EXPECT_NEAR(force.foot_sensors.specific_force_y_foot_m_s2, -0.01, 1e-9);
  FaultConfig corner = saturated(FaultTarget::kFootRight, FaultSignal::kAll);
  corner.element = FaultElement::kFrontLeft;
  InertialNodes load_cell({}, {corner});
  load_cell.tick(kTick, some_motion());
  EXPECT_NEAR(load_cell.foot_sensors.roll_rad, 0.02, 1e-9) << "a corner is none of theirs";
}

}  // namespace
}  // namespace surefoot::sim_hw
