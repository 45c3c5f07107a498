#include "tests/unit/firmware_can/golden_frames.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "firmware/can/messages.hpp"

// Our encoders must write the bytes that cantools writes, our decoders read the values that it was given:
// catches a scale, sign, bit position, joint order, CRC or counter place other than the DBC's, and a left
// frame whose layout is not the right one's.
namespace surefoot::can {
namespace {

using ::testing::ElementsAreArray;
using ::testing::Pointwise;

constexpr double kRounding = 1e-12;
constexpr PerSide<std::string_view> kLegStates{golden::kLegStateRight, golden::kLegStateLeft};
constexpr PerSide<std::string_view> kFootForces{golden::kFootForceRight, golden::kFootForceLeft};
constexpr PerSide<std::string_view> kLegCommands{golden::kLegCommandRight, golden::kLegCommandLeft};
constexpr PerSide<std::string_view> kLegPositions{golden::kLegPositionRight, golden::kLegPositionLeft};
constexpr PerSide<std::string_view> kLegInertials{golden::kLegInertialRight, golden::kLegInertialLeft};
constexpr PerSide<std::string_view> kFootInertials{golden::kFootInertialRight, golden::kFootInertialLeft};
constexpr PerSide<LegStatus> kStatus{LegStatus{.watchdog_expired = true, .torque_limited = false, .is_damping = true},
                                     LegStatus{.watchdog_expired = false, .torque_limited = true, .is_damping = false}};

void expect_same(const CanFrame& ours, std::string_view theirs) {
  const CanFrame expected = golden::frame(theirs);
  EXPECT_EQ(ours.identifier, expected.identifier);
  EXPECT_THAT(ours.bytes(), ElementsAreArray(expected.bytes()));
}

MATCHER(IsNearTheOther, "") { return std::abs(std::get<0>(arg) - std::get<1>(arg)) < kRounding; }

ImuSensors golden_imu() {
  ImuSensors imu;
  imu.angular_rate_body_rad_s = geometry::Vector3(golden::kAngularRateRadS.data());
  imu.specific_force_body_m_s2 = geometry::Vector3(golden::kSpecificForceMS2.data());
  return imu;
}

TEST(GoldenFrames, SyncIsWrittenAndReadAsByCantools) {
  expect_same(encode_sync({.tick = 0x12345678, .counter = 0xA5}), golden::kSync);
  FrameStamp stamp;
  ASSERT_EQ(decode_sync(golden::frame(golden::kSync), stamp), Rejection::kNone);
  EXPECT_EQ(stamp.tick, 0x12345678U);
  EXPECT_EQ(stamp.counter, 0xA5);
}

TEST(GoldenFrames, LockstepServedIsWrittenAndReadAsByCantools) {
  expect_same(encode_lockstep_served({.tick = 0x12345678, .counter = 0xA5}), golden::kLockstepServed);
  FrameStamp stamp;
  ASSERT_EQ(decode_lockstep_served(golden::frame(golden::kLockstepServed), stamp), Rejection::kNone);
  EXPECT_EQ(stamp.tick, 0x12345678U);
  EXPECT_EQ(stamp.counter, 0xA5);
}

TEST(GoldenFrames, LegStatesAreWrittenAndReadAsByCantools) {
  for (const Side side : kSides) {
    const std::size_t i = index(side);
    const LegSensors sent{.angle_rad = golden::kAngleRad[i],
                          .rate_rad_s = golden::kRateRadS[i],
                          .torque_nm = golden::kTorqueNm[i],
                          .freshness = {}};
    expect_same(encode_leg_state(side, {.tick = 1200, .counter = 7}, sent, kStatus[i]), kLegStates[i]);

    FrameStamp stamp;
    LegSensors heard;
    LegStatus status;
    ASSERT_EQ(decode_leg_state(golden::frame(kLegStates[i]), stamp, heard, status), Rejection::kNone);
    EXPECT_EQ(stamp.tick, 1200U);
    EXPECT_EQ(stamp.counter, 7);
    EXPECT_THAT(heard.angle_rad, Pointwise(IsNearTheOther(), golden::kAngleRad[i]));
    EXPECT_THAT(heard.rate_rad_s, Pointwise(IsNearTheOther(), golden::kRateRadS[i]));
    EXPECT_THAT(heard.torque_nm, Pointwise(IsNearTheOther(), golden::kTorqueNm[i]));
    EXPECT_EQ(status.watchdog_expired, kStatus[i].watchdog_expired);
    EXPECT_EQ(status.torque_limited, kStatus[i].torque_limited);
    EXPECT_EQ(status.is_damping, kStatus[i].is_damping);
  }
}

TEST(GoldenFrames, FootForcesAreWrittenAndReadAsByCantools) {
  for (const Side side : kSides) {
    const std::size_t i = index(side);
    const FootSensors sent{.corner_force_n = golden::kCornerForceN[i], .freshness = {}};
    expect_same(encode_foot_force(side, {.tick = 65535, .counter = 255}, sent), kFootForces[i]);

    FrameStamp stamp;
    FootSensors heard;
    ASSERT_EQ(decode_foot_force(golden::frame(kFootForces[i]), stamp, heard), Rejection::kNone);
    EXPECT_EQ(stamp.tick, 65535U);
    EXPECT_EQ(stamp.counter, 255);
    EXPECT_THAT(heard.corner_force_n, Pointwise(IsNearTheOther(), golden::kCornerForceN[i]));
  }
}

TEST(GoldenFrames, ImuIsWrittenAndReadAsByCantools) {
  expect_same(encode_imu({.tick = 2, .counter = 1}, golden_imu()), golden::kImu);
  FrameStamp stamp;
  ImuSensors heard;
  ASSERT_EQ(decode_imu(golden::frame(golden::kImu), stamp, heard), Rejection::kNone);
  EXPECT_EQ(stamp.tick, 2U);
  EXPECT_EQ(stamp.counter, 1);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(heard.angular_rate_body_rad_s[axis], golden_imu().angular_rate_body_rad_s[axis], kRounding);
    EXPECT_NEAR(heard.specific_force_body_m_s2[axis], golden_imu().specific_force_body_m_s2[axis], kRounding);
  }
}

TEST(GoldenFrames, LegCommandsAreWrittenAndReadAsByCantools) {
  for (const Side side : kSides) {
    const std::size_t i = index(side);
    const LegCommand sent{.mode = side == Side::kRight ? LegMode::kTorque : LegMode::kDamp,
                          .torque_nm = golden::kTorqueNm[i]};
    expect_same(encode_leg_command(side, {.tick = 4660, .counter = 3}, sent), kLegCommands[i]);

    FrameStamp stamp;
    LegCommand heard;
    ASSERT_EQ(decode_leg_command(golden::frame(kLegCommands[i]), stamp, heard), Rejection::kNone);
    EXPECT_EQ(stamp.tick, 4660U);
    EXPECT_EQ(stamp.counter, 3);
    EXPECT_EQ(heard.mode, sent.mode);
    EXPECT_THAT(heard.torque_nm, Pointwise(IsNearTheOther(), golden::kTorqueNm[i]));
  }
}

TEST(GoldenFrames, LegPositionsAreWrittenAndReadAsByCantools) {
  for (const Side side : kSides) {
    const std::size_t i = index(side);
    const LegCommand sent{.mode = LegMode::kPosition, .angle_rad = golden::kAngleRad[i]};
    expect_same(encode_leg_command(side, {.tick = 513, .counter = 5}, sent), kLegPositions[i]);

    FrameStamp stamp;
    LegCommand heard{.mode = LegMode::kTorque, .torque_nm = golden::kTorqueNm[i]};
    ASSERT_EQ(decode_leg_command(golden::frame(kLegPositions[i]), stamp, heard), Rejection::kNone);
    EXPECT_EQ(stamp.tick, 513U);
    EXPECT_EQ(stamp.counter, 5);
    EXPECT_EQ(heard.mode, LegMode::kPosition);
    EXPECT_EQ(heard.torque_nm, LegVector{});
    EXPECT_THAT(heard.angle_rad, Pointwise(IsNearTheOther(), golden::kAngleRad[i]));
  }
}

TEST(GoldenFrames, LegInertialsAreWrittenAndReadAsByCantools) {
  for (const Side side : kSides) {
    const std::size_t i = index(side);
    const LegInertialSensors sent{.hip_roll_rate_rad_s = golden::kHipRollRateRadS[i], .freshness = {}};
    expect_same(encode_leg_inertial(side, {.tick = 40000, .counter = 8}, sent), kLegInertials[i]);

    FrameStamp stamp;
    LegInertialSensors heard;
    ASSERT_EQ(decode_leg_inertial(golden::frame(kLegInertials[i]), stamp, heard), Rejection::kNone);
    EXPECT_EQ(stamp.tick, 40000U);
    EXPECT_EQ(stamp.counter, 8);
    EXPECT_NEAR(heard.hip_roll_rate_rad_s, golden::kHipRollRateRadS[i], kRounding);
  }
}

TEST(GoldenFrames, FootInertialsAreWrittenAndReadAsByCantools) {
  for (const Side side : kSides) {
    const std::size_t i = index(side);
    const std::array<double, 4>& values = golden::kFootInertial[i];
    const FootInertialSensors sent{.roll_rad = values[0],
                                   .pitch_rad = values[1],
                                   .specific_force_x_foot_m_s2 = values[2],
                                   .specific_force_y_foot_m_s2 = values[3],
                                   .freshness = {}};
    expect_same(encode_foot_inertial(side, {.tick = 7, .counter = 200}, sent), kFootInertials[i]);

    FrameStamp stamp;
    FootInertialSensors heard;
    ASSERT_EQ(decode_foot_inertial(golden::frame(kFootInertials[i]), stamp, heard), Rejection::kNone);
    EXPECT_EQ(stamp.tick, 7U);
    EXPECT_EQ(stamp.counter, 200);
    EXPECT_NEAR(heard.roll_rad, values[0], kRounding);
    EXPECT_NEAR(heard.pitch_rad, values[1], kRounding);
    EXPECT_NEAR(heard.specific_force_x_foot_m_s2, values[2], kRounding);
    EXPECT_NEAR(heard.specific_force_y_foot_m_s2, values[3], kRounding);
  }
}

TEST(GoldenFrames, HeartbeatsTellOfInertialSensorsInABitThatWasReserved) {
  const Heartbeat plain{.state = NodeState::kOperational};
  const Heartbeat richer{.state = NodeState::kOperational, .has_inertial_sensors = true};
  EXPECT_EQ(encode_heartbeat(Node::kFootLeft, {}, plain).payload[3], 0);
  const CanFrame frame = encode_heartbeat(Node::kFootLeft, {}, richer);
  EXPECT_EQ(frame.payload[3], 1);
  FrameStamp stamp;
  Heartbeat heard;
  ASSERT_EQ(decode_heartbeat(frame, stamp, heard), Rejection::kNone);
  EXPECT_TRUE(heard.has_inertial_sensors);
}

TEST(GoldenFrames, HeartbeatsOfAllNodesAreWrittenAndReadAsByCantools) {
  for (std::size_t i = 0; i < kNodes.size(); ++i) {
    const CanFrame ours = encode_heartbeat(kNodes[i], {.tick = 100, .counter = 9}, {.state = NodeState::kOperational});
    expect_same(ours, golden::kHeartbeats[i]);

    FrameStamp stamp;
    Heartbeat heard;
    ASSERT_EQ(decode_heartbeat(golden::frame(golden::kHeartbeats[i]), stamp, heard), Rejection::kNone);
    EXPECT_EQ(stamp.tick, 100U);
    EXPECT_EQ(stamp.counter, 9);
    EXPECT_EQ(heard.state, NodeState::kOperational);
    EXPECT_EQ(heard.protocol_version, 1);
  }
}

TEST(GoldenFrames, EmergenciesOfAllNodesAreWrittenAndReadAsByCantools) {
  for (std::size_t i = 0; i < kNodes.size(); ++i) {
    expect_same(encode_emergency(kNodes[i], {.tick = 321, .counter = 2}, {.code = 0x8130, .error_register = 0x11}),
                golden::kEmergencies[i]);
    FrameStamp stamp;
    Emergency heard;
    ASSERT_EQ(decode_emergency(golden::frame(golden::kEmergencies[i]), stamp, heard), Rejection::kNone);
    EXPECT_EQ(stamp.tick, 321U);
    EXPECT_EQ(stamp.counter, 2);
    EXPECT_EQ(heard.code, 0x8130);
    EXPECT_EQ(heard.error_register, 0x11);
  }
}

// CiA 301: a dissector reads the NMT state from byte 0 and the emergency code from bytes 0 and 1.
TEST(GoldenFrames, KeepTheBytesThatCiA301Defines) {
  const CanFrame heartbeat = encode_heartbeat(Node::kLegLeft, {}, {.state = NodeState::kPreOperational});
  EXPECT_EQ(heartbeat.identifier, 0x702);
  EXPECT_EQ(heartbeat.payload[0], 0x7F);
  const CanFrame emergency = encode_emergency(Node::kLegLeft, {}, {.code = 0x2310, .error_register = 3});
  EXPECT_EQ(emergency.identifier, 0x082);
  EXPECT_EQ(emergency.payload[0], 0x10);
  EXPECT_EQ(emergency.payload[1], 0x23);
  EXPECT_EQ(emergency.payload[2], 3);
}

}  // namespace
}  // namespace surefoot::can
