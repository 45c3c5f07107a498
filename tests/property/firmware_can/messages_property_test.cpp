#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "firmware/can/messages.hpp"
#include "firmware/can/physical_range.hpp"

namespace surefoot::can {
namespace {

/// Half a step of the last bit, and the rounding of the division.
constexpr double kHalf = 0.5 + 1e-6;

double any_in(PhysicalRange range) {
  const double share = *rc::gen::inRange(0, 1'000'001) * 1e-6;
  return range.lowest + share * (range.highest - range.lowest);
}

template <typename Values>
Values fill(PhysicalRange range) {
  Values values;
  for (double& value : values) value = any_in(range);
  return values;
}

FrameStamp any_stamp() {
  return {.tick = *rc::gen::arbitrary<std::uint32_t>(), .counter = *rc::gen::arbitrary<std::uint8_t>()};
}

Side any_side() { return *rc::gen::element(Side::kRight, Side::kLeft); }

LegSensors any_leg() {
  return {.angle_rad = fill<LegVector>(kJointAngleRad),
          .rate_rad_s = fill<LegVector>(kJointRateRadS),
          .torque_nm = fill<LegVector>(kJointTorqueNm),
          .freshness = {}};
}

ImuSensors any_imu() {
  ImuSensors imu;
  imu.angular_rate_body_rad_s = fill<geometry::Vector3>(kAngularRateRadS);
  imu.specific_force_body_m_s2 = fill<geometry::Vector3>(kSpecificForceMS2);
  return imu;
}

template <typename Values>
void expect_near(const Values& heard, const Values& sent, double resolution) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(sent.size()); ++i) {
    const auto at = static_cast<std::ptrdiff_t>(i);
    RC_ASSERT(std::abs(heard.begin()[at] - sent.begin()[at]) <= kHalf * resolution);
  }
}

void expect_stamp(FrameStamp heard, FrameStamp sent) {
  RC_ASSERT(heard.tick == (sent.tick & 0xFFFFU));
  RC_ASSERT(heard.counter == sent.counter);
}

RC_GTEST_PROP(Messages, LegStatesArriveWithinHalfAStep, ()) {
  const LegSensors sent = any_leg();
  const FrameStamp stamp = any_stamp();
  const LegStatus status{*rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>()};
  FrameStamp heard_stamp;
  LegSensors heard;
  LegStatus heard_status;
  RC_ASSERT(decode_leg_state(encode_leg_state(any_side(), stamp, sent, status), heard_stamp, heard, heard_status) ==
            Rejection::kNone);
  expect_stamp(heard_stamp, stamp);
  expect_near(heard.angle_rad, sent.angle_rad, 1e-6);
  expect_near(heard.rate_rad_s, sent.rate_rad_s, 1e-3);
  expect_near(heard.torque_nm, sent.torque_nm, 0.01);
  RC_ASSERT(heard_status.watchdog_expired == status.watchdog_expired);
  RC_ASSERT(heard_status.torque_limited == status.torque_limited);
  RC_ASSERT(heard_status.is_damping == status.is_damping);
}

RC_GTEST_PROP(Messages, LegCommandsArriveWithinHalfAStep, ()) {
  const LegCommand sent{.mode = *rc::gen::element(LegMode::kDamp, LegMode::kTorque),
                        .torque_nm = fill<LegVector>(kJointTorqueNm)};
  const FrameStamp stamp = any_stamp();
  FrameStamp heard_stamp;
  LegCommand heard;
  RC_ASSERT(decode_leg_command(encode_leg_command(any_side(), stamp, sent), heard_stamp, heard) == Rejection::kNone);
  expect_stamp(heard_stamp, stamp);
  RC_ASSERT(heard.mode == sent.mode);
  expect_near(heard.torque_nm, sent.torque_nm, 0.01);
}

FootInertialSensors any_foot_inertial() {
  return {.roll_rad = any_in(kSoleTiltRad),
          .pitch_rad = any_in(kSoleTiltRad),
          .specific_force_x_foot_m_s2 = any_in(kSpecificForceMS2),
          .specific_force_y_foot_m_s2 = any_in(kSpecificForceMS2),
          .freshness = {}};
}

RC_GTEST_PROP(Messages, LegPositionsArriveWithinHalfAStep, ()) {
  const LegCommand sent{.mode = LegMode::kPosition, .angle_rad = fill<LegVector>(kJointAngleRad)};
  const FrameStamp stamp = any_stamp();
  FrameStamp heard_stamp;
  LegCommand heard;
  RC_ASSERT(decode_leg_command(encode_leg_command(any_side(), stamp, sent), heard_stamp, heard) == Rejection::kNone);
  expect_stamp(heard_stamp, stamp);
  RC_ASSERT(heard.mode == LegMode::kPosition);
  RC_ASSERT(heard.torque_nm == LegVector{});
  expect_near(heard.angle_rad, sent.angle_rad, 1e-6);
}

RC_GTEST_PROP(Messages, InertialValuesArriveWithinHalfAStep, ()) {
  const FootInertialSensors sent = any_foot_inertial();
  const double rate = any_in(kAngularRateRadS);
  const FrameStamp stamp = any_stamp();
  FrameStamp heard_stamp;
  FootInertialSensors heard;
  LegInertialSensors leg;
  RC_ASSERT(decode_foot_inertial(encode_foot_inertial(any_side(), stamp, sent), heard_stamp, heard) ==
            Rejection::kNone);
  expect_stamp(heard_stamp, stamp);
  expect_near(std::array{heard.roll_rad, heard.pitch_rad}, std::array{sent.roll_rad, sent.pitch_rad}, 5e-5);
  expect_near(std::array{heard.specific_force_x_foot_m_s2, heard.specific_force_y_foot_m_s2},
              std::array{sent.specific_force_x_foot_m_s2, sent.specific_force_y_foot_m_s2}, 5e-3);
  RC_ASSERT(decode_leg_inertial(encode_leg_inertial(any_side(), stamp, {rate, {}}), heard_stamp, leg) ==
            Rejection::kNone);
  expect_stamp(heard_stamp, stamp);
  RC_ASSERT(std::abs(leg.hip_roll_rate_rad_s - rate) <= kHalf * 5e-4);
}

RC_GTEST_PROP(Messages, FootForcesArriveWithinHalfAStep, ()) {
  const FootSensors sent{.corner_force_n = fill<std::array<double, 4>>(kCornerForceN), .freshness = {}};
  const FrameStamp stamp = any_stamp();
  FrameStamp heard_stamp;
  FootSensors heard;
  RC_ASSERT(decode_foot_force(encode_foot_force(any_side(), stamp, sent), heard_stamp, heard) == Rejection::kNone);
  expect_stamp(heard_stamp, stamp);
  expect_near(heard.corner_force_n, sent.corner_force_n, 0.1);
}

RC_GTEST_PROP(Messages, ImuValuesArriveWithinHalfAStep, ()) {
  const ImuSensors sent = any_imu();
  const FrameStamp stamp = any_stamp();
  FrameStamp heard_stamp;
  ImuSensors heard;
  RC_ASSERT(decode_imu(encode_imu(stamp, sent), heard_stamp, heard) == Rejection::kNone);
  expect_stamp(heard_stamp, stamp);
  expect_near(heard.angular_rate_body_rad_s, sent.angular_rate_body_rad_s, 5e-4);
  expect_near(heard.specific_force_body_m_s2, sent.specific_force_body_m_s2, 5e-3);
}

RC_GTEST_PROP(Messages, AValueThatArrivedOnceArrivesUnchangedAgain, ()) {
  FrameStamp stamp;
  LegSensors once;
  LegSensors twice;
  LegStatus status;
  RC_ASSERT(decode_leg_state(encode_leg_state(Side::kLeft, {}, any_leg(), {}), stamp, once, status) ==
            Rejection::kNone);
  RC_ASSERT(decode_leg_state(encode_leg_state(Side::kLeft, {}, once, {}), stamp, twice, status) == Rejection::kNone);
  RC_ASSERT(twice.angle_rad == once.angle_rad);
  RC_ASSERT(twice.rate_rad_s == once.rate_rad_s);
  RC_ASSERT(twice.torque_nm == once.torque_nm);
}

/// A frame of any kind, and what its decoder says to it.
struct Kind {
  CanFrame frame;
  Rejection (*decode)(const CanFrame&);
};

Kind any_kind() {
  const FrameStamp stamp = any_stamp();
  const Node node = *rc::gen::elementOf(kNodes);
  switch (*rc::gen::inRange(0, 11)) {
    case 0:
      return {encode_sync(stamp), [](const CanFrame& frame) {
                FrameStamp heard;
                return decode_sync(frame, heard);
              }};
    case 1:
      return {encode_leg_state(any_side(), stamp, any_leg(), {}), [](const CanFrame& frame) {
                FrameStamp heard;
                LegSensors leg;
                LegStatus status;
                return decode_leg_state(frame, heard, leg, status);
              }};
    case 2:
      return {encode_foot_force(any_side(), stamp, {fill<std::array<double, 4>>(kCornerForceN), {}}),
              [](const CanFrame& frame) {
                FrameStamp heard;
                FootSensors foot;
                return decode_foot_force(frame, heard, foot);
              }};
    case 3:
      return {encode_imu(stamp, any_imu()), [](const CanFrame& frame) {
                FrameStamp heard;
                ImuSensors imu;
                return decode_imu(frame, heard, imu);
              }};
    case 7:
      return {encode_lockstep_served(stamp), [](const CanFrame& frame) {
                FrameStamp heard;
                return decode_lockstep_served(frame, heard);
              }};
    case 8:
      return {encode_leg_command(any_side(), stamp,
                                 {.mode = LegMode::kPosition, .angle_rad = fill<LegVector>(kJointAngleRad)}),
              [](const CanFrame& frame) {
                FrameStamp heard;
                LegCommand command;
                return decode_leg_command(frame, heard, command);
              }};
    case 9:
      return {encode_leg_inertial(any_side(), stamp, {any_in(kAngularRateRadS), {}}), [](const CanFrame& frame) {
                FrameStamp heard;
                LegInertialSensors leg;
                return decode_leg_inertial(frame, heard, leg);
              }};
    case 10:
      return {encode_foot_inertial(any_side(), stamp, any_foot_inertial()), [](const CanFrame& frame) {
                FrameStamp heard;
                FootInertialSensors foot;
                return decode_foot_inertial(frame, heard, foot);
              }};
    case 4:
      return {encode_leg_command(any_side(), stamp, {LegMode::kTorque, fill<LegVector>(kJointTorqueNm)}),
              [](const CanFrame& frame) {
                FrameStamp heard;
                LegCommand command;
                return decode_leg_command(frame, heard, command);
              }};
    case 5:
      return {encode_heartbeat(node, stamp, {}), [](const CanFrame& frame) {
                FrameStamp heard;
                Heartbeat heartbeat;
                return decode_heartbeat(frame, heard, heartbeat);
              }};
    default:
      return {encode_emergency(node, stamp, {*rc::gen::arbitrary<std::uint16_t>(), 1}), [](const CanFrame& frame) {
                FrameStamp heard;
                Emergency emergency;
                return decode_emergency(frame, heard, emergency);
              }};
  }
}

void flip(CanFrame& frame, std::size_t bit) { frame.payload[bit / 8] ^= static_cast<std::uint8_t>(0x80U >> (bit % 8)); }

RC_GTEST_PROP(Messages, EverySingleBitErrorIsRefusedByTheCrc, ()) {
  Kind kind = any_kind();
  RC_ASSERT(kind.decode(kind.frame) == Rejection::kNone);
  for (std::size_t bit = 0; bit < std::size_t{kind.frame.length} * 8; ++bit) {
    flip(kind.frame, bit);
    RC_ASSERT(kind.decode(kind.frame) == Rejection::kWrongCrc);
    flip(kind.frame, bit);
  }
}

// Bursts that reach over the edge of the CRC field are counted exhaustively in end_to_end_test.cpp.
RC_GTEST_PROP(Messages, EveryBurstOfSixteenBitsBesideTheCrcIsRefusedByTheCrc, ()) {
  Kind kind = any_kind();
  const bool crc_is_last =
      (kind.frame.identifier & 0x780) == 0x700 || (kind.frame.identifier > 0x80 && kind.frame.identifier < 0x100);
  const std::size_t first_bit = crc_is_last ? 0 : 16;
  const std::size_t bits = std::size_t{kind.frame.length} * 8 - 16;
  const auto length = *rc::gen::inRange<std::size_t>(1, 17);
  const auto start = first_bit + *rc::gen::inRange<std::size_t>(0, bits - length + 1);
  flip(kind.frame, start);
  if (length > 1) flip(kind.frame, start + length - 1);
  for (std::size_t i = 1; i + 1 < length; ++i) {
    if (*rc::gen::arbitrary<bool>()) flip(kind.frame, start + i);
  }
  RC_ASSERT(kind.decode(kind.frame) == Rejection::kWrongCrc);
}

RC_GTEST_PROP(Messages, AnotherIdentifierIsRefused, ()) {
  Kind kind = any_kind();
  const std::uint16_t own = kind.frame.identifier;
  for (std::uint16_t identifier = 0; identifier <= 0x7FF; ++identifier) {
    kind.frame.identifier = identifier;
    RC_ASSERT((kind.decode(kind.frame) == Rejection::kNone) == (identifier == own));
  }
}

RC_GTEST_PROP(Messages, AnotherLengthIsRefused, ()) {
  Kind kind = any_kind();
  const std::uint8_t own = kind.frame.length;
  for (unsigned length = 0; length < 256; ++length) {  // also lengths that no CAN controller would deliver
    kind.frame.length = static_cast<std::uint8_t>(length);
    RC_ASSERT(kind.decode(kind.frame) == (length == own ? Rejection::kNone : Rejection::kWrongLength));
  }
}

}  // namespace
}  // namespace surefoot::can
