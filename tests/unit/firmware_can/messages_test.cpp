#include "firmware/can/messages.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "firmware/can/end_to_end.hpp"
#include "firmware/can/physical_range.hpp"

namespace surefoot::can {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Sends one value in every physical signal of a frame and gives back what arrives, signal by signal.
struct Channel {
  const char* name;
  std::vector<double> (*pass)(double value);
  PhysicalRange range;
  double resolution;
};

LegSensors pass_leg_state(const LegSensors& sent) {
  FrameStamp stamp;
  LegSensors heard;
  LegStatus status;
  EXPECT_EQ(decode_leg_state(encode_leg_state(Side::kLeft, {}, sent, {}), stamp, heard, status), Rejection::kNone);
  return heard;
}

ImuSensors pass_imu(const ImuSensors& sent) {
  FrameStamp stamp;
  ImuSensors heard;
  EXPECT_EQ(decode_imu(encode_imu({}, sent), stamp, heard), Rejection::kNone);
  return heard;
}

template <typename Values>
std::vector<double> listed(const Values& values) {
  return {values.begin(), values.end()};
}

std::vector<double> pass_angle(double value) {
  LegSensors sent;
  sent.angle_rad.fill(value);
  return listed(pass_leg_state(sent).angle_rad);
}
std::vector<double> pass_rate(double value) {
  LegSensors sent;
  sent.rate_rad_s.fill(value);
  return listed(pass_leg_state(sent).rate_rad_s);
}
std::vector<double> pass_applied_torque(double value) {
  LegSensors sent;
  sent.torque_nm.fill(value);
  return listed(pass_leg_state(sent).torque_nm);
}
std::vector<double> pass_wanted_torque(double value) {
  LegCommand sent{.mode = LegMode::kTorque, .torque_nm = {}};
  sent.torque_nm.fill(value);
  FrameStamp stamp;
  LegCommand heard;
  EXPECT_EQ(decode_leg_command(encode_leg_command(Side::kRight, {}, sent), stamp, heard), Rejection::kNone);
  return listed(heard.torque_nm);
}
std::vector<double> pass_wanted_angle(double value) {
  LegCommand sent{.mode = LegMode::kPosition};
  sent.angle_rad.fill(value);
  FrameStamp stamp;
  LegCommand heard;
  EXPECT_EQ(decode_leg_command(encode_leg_command(Side::kRight, {}, sent), stamp, heard), Rejection::kNone);
  return listed(heard.angle_rad);
}
std::vector<double> pass_hip_roll_rate(double value) {
  FrameStamp stamp;
  LegInertialSensors heard;
  EXPECT_EQ(decode_leg_inertial(encode_leg_inertial(Side::kRight, {}, {value, {}}), stamp, heard), Rejection::kNone);
  return {heard.hip_roll_rate_rad_s};
}
FootInertialSensors pass_foot_inertial(const FootInertialSensors& sent) {
  FrameStamp stamp;
  FootInertialSensors heard;
  EXPECT_EQ(decode_foot_inertial(encode_foot_inertial(Side::kRight, {}, sent), stamp, heard), Rejection::kNone);
  return heard;
}
std::vector<double> pass_sole_tilt(double value) {
  const FootInertialSensors heard = pass_foot_inertial({.roll_rad = value, .pitch_rad = value, .freshness = {}});
  return {heard.roll_rad, heard.pitch_rad};
}
std::vector<double> pass_sole_force(double value) {
  const FootInertialSensors heard =
      pass_foot_inertial({.specific_force_x_foot_m_s2 = value, .specific_force_y_foot_m_s2 = value, .freshness = {}});
  return {heard.specific_force_x_foot_m_s2, heard.specific_force_y_foot_m_s2};
}
std::vector<double> pass_corner_force(double value) {
  FootSensors sent;
  sent.corner_force_n.fill(value);
  FrameStamp stamp;
  FootSensors heard;
  EXPECT_EQ(decode_foot_force(encode_foot_force(Side::kRight, {}, sent), stamp, heard), Rejection::kNone);
  return listed(heard.corner_force_n);
}
std::vector<double> pass_angular_rate(double value) {
  ImuSensors sent;
  sent.angular_rate_body_rad_s.setConstant(value);
  return listed(pass_imu(sent).angular_rate_body_rad_s);
}
std::vector<double> pass_specific_force(double value) {
  ImuSensors sent;
  sent.specific_force_body_m_s2.setConstant(value);
  return listed(pass_imu(sent).specific_force_body_m_s2);
}

const std::array kChannels{Channel{"angle", pass_angle, kJointAngleRad, 1e-6},
                           Channel{"rate", pass_rate, kJointRateRadS, 1e-3},
                           Channel{"applied torque", pass_applied_torque, kJointTorqueNm, 0.01},
                           Channel{"wanted torque", pass_wanted_torque, kJointTorqueNm, 0.01},
                           Channel{"wanted angle", pass_wanted_angle, kJointAngleRad, 1e-6},
                           Channel{"hip roll rate", pass_hip_roll_rate, kAngularRateRadS, 5e-4},
                           Channel{"sole tilt", pass_sole_tilt, kSoleTiltRad, 5e-5},
                           Channel{"sole force", pass_sole_force, kSpecificForceMS2, 5e-3},
                           Channel{"corner force", pass_corner_force, kCornerForceN, 0.1},
                           Channel{"angular rate", pass_angular_rate, kAngularRateRadS, 5e-4},
                           Channel{"specific force", pass_specific_force, kSpecificForceMS2, 5e-3}};

void expect_arrives(const Channel& channel, double sent, double expected) {
  for (const double heard : channel.pass(sent)) EXPECT_NEAR(heard, expected, 1e-9) << channel.name << ' ' << sent;
}

TEST(Encoders, ClampWhatIsOutsideThePhysicalRange) {
  for (const Channel& channel : kChannels) {
    for (const double excess : {channel.resolution, 1.0, 1e6, 1e300, kInfinity}) {
      expect_arrives(channel, channel.range.highest + excess, channel.range.highest);
      expect_arrives(channel, channel.range.lowest - excess, channel.range.lowest);
    }
  }
}

TEST(Encoders, SendZeroForNan) {
  for (const Channel& channel : kChannels) {
    expect_arrives(channel, kNan, 0.0);
    expect_arrives(channel, -kNan, 0.0);
  }
}

TEST(Encoders, RoundToTheNearestStepAndNotTowardsZero) {
  for (const Channel& channel : kChannels) {
    expect_arrives(channel, 10.6 * channel.resolution, 11.0 * channel.resolution);
    expect_arrives(channel, -10.6 * channel.resolution, -11.0 * channel.resolution);
    expect_arrives(channel, 10.4 * channel.resolution, 10.0 * channel.resolution);
  }
}

TEST(Encoders, CarryTheLowSixteenBitsOfTheTick) {
  FrameStamp stamp;
  FootSensors heard;
  const CanFrame frame = encode_foot_force(Side::kRight, {.tick = 0x0001'FFFE, .counter = 4}, {});
  ASSERT_EQ(decode_foot_force(frame, stamp, heard), Rejection::kNone);
  EXPECT_EQ(stamp.tick, 0xFFFEU);
}

/// Writes a raw value, little-endian, and signs the frame again: what a faulty node with a sound codec sends.
CanFrame with_raw(CanFrame frame, std::size_t first_byte, std::size_t bytes, int raw) {
  for (std::size_t i = 0; i < bytes; ++i) {
    frame.payload[first_byte + i] = static_cast<std::uint8_t>((static_cast<unsigned>(raw) >> (8 * i)) & 0xFFU);
  }
  protect(frame, 0);
  return frame;
}

Rejection decode_any(const CanFrame& frame) {
  FrameStamp stamp;
  LegSensors leg;
  LegStatus status;
  FootSensors foot;
  ImuSensors imu;
  LegCommand command;
  LegInertialSensors leg_inertial;
  FootInertialSensors foot_inertial;
  switch (frame.identifier) {
    case 0x281:
      return decode_leg_inertial(frame, stamp, leg_inertial);
    case 0x283:
      return decode_foot_inertial(frame, stamp, foot_inertial);
    case 0x181:
      return decode_leg_state(frame, stamp, leg, status);
    case 0x183:
      return decode_foot_force(frame, stamp, foot);
    case 0x185:
      return decode_imu(frame, stamp, imu);
    default:
      return decode_leg_command(frame, stamp, command);
  }
}

/// The raw value at each end of every signal is accepted, the next one is not.
void expect_bounds(const CanFrame& frame, std::size_t first_byte, std::size_t bytes, std::size_t signals, int lowest,
                   int highest) {
  for (std::size_t i = 0; i < signals; ++i) {
    const std::size_t at = first_byte + i * bytes;
    EXPECT_EQ(decode_any(with_raw(frame, at, bytes, highest)), Rejection::kNone) << at;
    EXPECT_EQ(decode_any(with_raw(frame, at, bytes, highest + 1)), Rejection::kImplausible) << at;
    EXPECT_EQ(decode_any(with_raw(frame, at, bytes, lowest)), Rejection::kNone) << at;
    EXPECT_EQ(decode_any(with_raw(frame, at, bytes, lowest - 1)), Rejection::kImplausible) << at;
  }
}

// Layout and ranges as surefoot.dbc has them: catches a signal that nobody checks.
TEST(Decoders, RefuseTheFirstRawValueBeyondEachEndOfEachSignal) {
  const CanFrame leg = encode_leg_state(Side::kRight, {}, {}, {});
  expect_bounds(leg, 6, 3, 6, -3'200'000, 3'200'000);
  expect_bounds(leg, 24, 2, 6, -30'000, 30'000);
  expect_bounds(leg, 36, 2, 6, -30'000, 30'000);
  expect_bounds(encode_leg_command(Side::kRight, {}, {}), 6, 2, 6, -30'000, 30'000);
  expect_bounds(encode_leg_command(Side::kRight, {}, {.mode = LegMode::kPosition}), 6, 3, 6, -3'200'000, 3'200'000);
  expect_bounds(encode_leg_inertial(Side::kRight, {}, {}), 6, 2, 1, -32'000, 32'000);
  expect_bounds(encode_foot_inertial(Side::kRight, {}, {}), 6, 2, 4, -32'000, 32'000);
  expect_bounds(encode_foot_force(Side::kRight, {}, {}), 6, 2, 4, -5'000, 32'000);
  expect_bounds(encode_imu({}, {}), 6, 2, 6, -32'000, 32'000);
}

TEST(Decoders, RefuseUnknownModesAndNodeStates) {
  const CanFrame command = encode_leg_command(Side::kRight, {}, {});
  EXPECT_EQ(decode_any(with_raw(command, 3, 1, 1)), Rejection::kNone);
  for (int mode = 2; mode < 256; ++mode) {
    EXPECT_EQ(decode_any(with_raw(command, 3, 1, mode)), Rejection::kImplausible) << mode;
  }
  for (int state = 0; state < 256; ++state) {
    FrameStamp stamp;
    Heartbeat heartbeat;
    const bool is_defined = state == 0x00 || state == 0x04 || state == 0x05 || state == 0x7F;  // CiA 301
    EXPECT_EQ(decode_heartbeat(encode_heartbeat(Node::kLegRight, {}, {.state = static_cast<NodeState>(state)}), stamp,
                               heartbeat),
              is_defined ? Rejection::kNone : Rejection::kImplausible)
        << state;
  }
}

TEST(Decoders, RefuseARightFrameUnderTheLeftIdentifier) {
  const auto renamed = [](CanFrame frame, std::uint16_t identifier) {
    frame.identifier = identifier;
    return frame;
  };
  FrameStamp stamp;
  LegSensors leg;
  LegStatus status;
  FootSensors foot;
  LegCommand command;
  Heartbeat heartbeat;
  Emergency emergency;
  EXPECT_EQ(decode_leg_state(renamed(encode_leg_state(Side::kRight, {}, {}, {}), 0x182), stamp, leg, status),
            Rejection::kWrongCrc);
  EXPECT_EQ(decode_foot_force(renamed(encode_foot_force(Side::kLeft, {}, {}), 0x183), stamp, foot),
            Rejection::kWrongCrc);
  EXPECT_EQ(decode_leg_command(renamed(encode_leg_command(Side::kRight, {}, {}), 0x202), stamp, command),
            Rejection::kWrongCrc);
  EXPECT_EQ(decode_heartbeat(renamed(encode_heartbeat(Node::kLegLeft, {}, {}), 0x701), stamp, heartbeat),
            Rejection::kWrongCrc);
  EXPECT_EQ(decode_emergency(renamed(encode_emergency(Node::kLegLeft, {}, {}), 0x081), stamp, emergency),
            Rejection::kWrongCrc);
}

TEST(Decoders, RefuseFramesOfAnotherKind) {
  FrameStamp stamp;
  LegSensors leg;
  LegStatus status;
  FootSensors foot;
  ImuSensors imu;
  LegCommand command;
  Heartbeat heartbeat;
  Emergency emergency;
  const CanFrame sync = encode_sync({});
  const CanFrame leg_state = encode_leg_state(Side::kRight, {}, {}, {});
  EXPECT_EQ(decode_leg_state(encode_foot_force(Side::kRight, {}, {}), stamp, leg, status),
            Rejection::kUnknownIdentifier);
  EXPECT_EQ(decode_foot_force(leg_state, stamp, foot), Rejection::kUnknownIdentifier);
  EXPECT_EQ(decode_imu(leg_state, stamp, imu), Rejection::kUnknownIdentifier);
  EXPECT_EQ(decode_leg_command(leg_state, stamp, command), Rejection::kUnknownIdentifier);
  EXPECT_EQ(decode_heartbeat(sync, stamp, heartbeat), Rejection::kUnknownIdentifier);
  EXPECT_EQ(decode_emergency(sync, stamp, emergency), Rejection::kUnknownIdentifier);
  EXPECT_EQ(decode_sync(encode_emergency(Node::kLegRight, {}, {}), stamp), Rejection::kUnknownIdentifier);
  EXPECT_EQ(decode_sync(encode_lockstep_served({}), stamp), Rejection::kUnknownIdentifier);
  EXPECT_EQ(decode_lockstep_served(sync, stamp), Rejection::kUnknownIdentifier);
}

TEST(Decoders, LeaveTheirOutputsAloneWhenTheyRefuse) {
  const CanFrame implausible =
      with_raw(encode_leg_state(Side::kRight, {.tick = 5, .counter = 5}, {}, {}), 46, 2, 32'767);
  FrameStamp stamp{.tick = 99, .counter = 98};
  LegSensors leg;
  leg.angle_rad.fill(0.5);
  LegStatus status{.watchdog_expired = true, .torque_limited = true, .is_damping = true};
  ASSERT_EQ(decode_leg_state(implausible, stamp, leg, status), Rejection::kImplausible);
  EXPECT_EQ(stamp.tick, 99U);
  EXPECT_EQ(stamp.counter, 98);
  EXPECT_EQ(leg.angle_rad[0], 0.5);
  EXPECT_TRUE(status.torque_limited);
}

TEST(Decoders, LeaveFreshnessToTheReceiver) {
  FrameStamp stamp;
  ImuSensors imu;
  imu.freshness.age_ticks = 17;
  ASSERT_EQ(decode_imu(encode_imu({}, {}), stamp, imu), Rejection::kNone);
  EXPECT_EQ(imu.freshness.age_ticks, 17U);
}

}  // namespace
}  // namespace surefoot::can
