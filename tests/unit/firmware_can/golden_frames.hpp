#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "firmware/can/can_frame.hpp"
#include "firmware/core/joints.hpp"

/// Frames written by cantools 45.1.0 from surefoot.dbc, their CRC by Python's binascii.crc_hqx (an
/// implementation of CRC-16/CCITT-FALSE that is not ours), in the notation of `candump -L`. The
/// values below them are what went in.
namespace surefoot::can::golden {

/// Frame of `III##FPP..`: three digits of identifier, one of flags, payload.
inline CanFrame frame(std::string_view candump) {
  const auto digit = [&](std::size_t at) {
    const char c = candump.at(at);
    return static_cast<unsigned>(c <= '9' ? c - '0' : c - 'A' + 10);
  };
  CanFrame frame;
  frame.identifier = static_cast<std::uint16_t>((digit(0) << 8) | (digit(1) << 4) | digit(2));
  for (std::size_t at = 6; at < candump.size(); at += 2) {
    frame.payload.at(frame.length++) = static_cast<std::uint8_t>((digit(at) << 4) | digit(at + 1));
  }
  return frame;
}

/// Counter 0xA5, tick 0x12345678.
inline constexpr std::string_view kSync = "080##16CBEA50078563412";
inline constexpr std::string_view kLockstepServed = "7F0##12417A50078563412";

/// Counter 7, tick 1200. Right: watchdog expired and damping, values at the ends of their ranges among
/// them. Left: torque limited.
inline constexpr std::string_view kLegStateRight =
    "181##12D270705B004002CCFC01DFE0100009EFA0FB102F800D430D08A0100FFFF3930B4E23075D08A0100FFFFA93348DD3075";
inline constexpr std::string_view kLegStateLeft =
    "182##137E00702B004000000A08601C0F2FCA02526FFFFFF7929ED0000DC0536F72F75F0FFF401E803FEF7050DE1B100000700";

/// Counter 255, tick 65535.
inline constexpr std::string_view kFootForceRight = "183##170A8FF00FFFF78EC0100FFFF007D0000";
inline constexpr std::string_view kFootForceLeft = "184##1877EFF00FFFFAA07E107000060070000";

/// Counter 1, tick 2.
inline constexpr std::string_view kImu = "185##141B201000200008301008813FFFF007DAA070000";

/// Counter 3, tick 4660; right kTorque, left kDamp; the torques of the leg states.
inline constexpr std::string_view kLegCommandRight = "201##169C503013412D08A0100FFFFA93348DD30750000";
inline constexpr std::string_view kLegCommandLeft = "202##17F8703003412E803FEF7050DE1B1000007000000";

/// Counter 5, tick 513; the angles of the leg states.
inline constexpr std::string_view kLegPositionRight = "301##1416105000102002CCFC01DFE0100009EFA0FB102F800D430";
inline constexpr std::string_view kLegPositionLeft = "302##1E5E305000102000000A08601C0F2FCA02526FFFFFF7929ED";

/// Counter 8, tick 40000.
inline constexpr std::string_view kLegInertialRight = "281##1B82F0800409CA20D";
inline constexpr std::string_view kLegInertialLeft = "282##197EC0800409C0083";

/// Counter 200, tick 7.
inline constexpr std::string_view kFootInertialRight = "283##1F0AAC800070088EB007D540F00830000";
inline constexpr std::string_view kFootInertialLeft = "284##13373C8000700010006FFFFFFAA070000";

/// By node, in the order of kNodes. Counter 9, tick 100, operational, protocol version 1.
inline constexpr std::array<std::string_view, 6> kHeartbeats{"701##105010900640060B2", "702##1050109006400157A",
                                                             "703##1050109006400C63D", "704##1050109006400DEFA",
                                                             "705##10501090064000DBD", "77F##10501090064007D9C"};

/// By node, in the order of kNodes. Counter 2, tick 321, code 0x8130, error register 0x11.
inline constexpr std::array<std::string_view, 6> kEmergencies{"081##1308111024101CE01", "082##1308111024101BBC9",
                                                              "083##1308111024101688E", "084##13081110241017049",
                                                              "085##1308111024101A30E", "0FF##1308111024101D32F"};

inline constexpr PerSide<LegVector> kAngleRad{
    {{-3.2, -0.123456, 1e-06, 1.047198, -0.523599, 3.2}, {0.0, 0.1, -0.2, 2.5, -1e-06, -1.234567}}};
inline constexpr PerSide<LegVector> kRateRadS{
    {{-30.0, 0.001, -0.001, 12.345, -7.5, 30.0}, {0.0, 1.5, -2.25, 29.999, -0.016, 0.5}}};
inline constexpr PerSide<LegVector> kTorqueNm{
    {{-300.0, 0.01, -0.01, 132.25, -88.88, 300.0}, {10.0, -20.5, 33.33, -199.99, 0.0, 0.07}}};
inline constexpr PerSide<std::array<double, 4>> kCornerForceN{
    {{-500.0, 0.1, -0.1, 3200.0}, {196.2, 201.7, 0.0, 188.8}}};
inline constexpr std::array<double, 3> kAngularRateRadS{-16.0, 0.0005, 2.5};
inline constexpr std::array<double, 3> kSpecificForceMS2{-0.005, 160.0, 9.81};

inline constexpr PerSide<double> kHipRollRateRadS{1.745, -16.0};
inline constexpr PerSide<std::array<double, 4>> kFootInertial{{{-0.262, 1.6, 19.62, -160.0},  // roll, pitch, x, y
                                                               {5e-05, -0.0125, -0.005, 9.81}}};

}  // namespace surefoot::can::golden
