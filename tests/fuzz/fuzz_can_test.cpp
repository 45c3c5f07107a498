// Random and half-right frames against every decoder and the whole receiver, from fixed seeds: nothing
// may crash (the sanitizers watch) and nothing outside its physical range may come through.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <random>

#include "firmware/can/end_to_end.hpp"
#include "firmware/can/frame_exchange.hpp"
#include "firmware/can/physical_range.hpp"

namespace surefoot::can {
namespace {

constexpr int kFrames = 200'000;

/// Bits are taken from the engine alone: distributions differ between standard libraries.
class FrameMonkey {
 public:
  explicit FrameMonkey(std::uint32_t seed) : random_(seed) {}

  /// Mostly near the truth: known identifiers, right lengths, valid CRC, each given up now and then.
  CanFrame next(std::uint32_t tick) {
    CanFrame frame = well_formed(tick);
    if (one_in(4)) {
      for (std::uint8_t& byte : frame.payload) byte = static_cast<std::uint8_t>(below(256));
    }
    if (one_in(4)) frame.payload[below(64)] = static_cast<std::uint8_t>(below(256));
    if (one_in(2)) {  // sign it again
      const bool crc_is_last = (frame.identifier >= 0x700 && frame.identifier != kLockstepServedIdentifier) ||
                               (frame.identifier > 0x080 && frame.identifier < 0x100);
      protect(frame, crc_is_last ? 6 : 0);
    }
    if (one_in(8)) frame.length = static_cast<std::uint8_t>(below(256));
    if (one_in(8)) frame.identifier = static_cast<std::uint16_t>(below(one_in(2) ? 0x800 : 0x10000));
    return frame;
  }

  std::uint32_t below(std::uint32_t bound) { return static_cast<std::uint32_t>(random_() % bound); }
  bool one_in(std::uint32_t chances) { return below(chances) == 0; }

 private:
  CanFrame well_formed(std::uint32_t tick) {
    const FrameStamp stamp{.tick = one_in(8) ? static_cast<std::uint32_t>(random_()) : tick,
                           .counter = static_cast<std::uint8_t>(below(256))};
    const Side side = one_in(2) ? Side::kRight : Side::kLeft;
    const Node node = kNodes[below(kNodes.size())];
    switch (below(11)) {
      case 0:
        return encode_sync(stamp);
      case 1:
        return encode_leg_command(side, stamp, {});
      case 2:
        return encode_leg_state(side, stamp, {}, {});
      case 3:
        return encode_foot_force(side, stamp, {});
      case 4:
        return encode_imu(stamp, {});
      case 5:
        return encode_heartbeat(node, stamp, {.protocol_version = static_cast<std::uint8_t>(one_in(16) ? 2 : 1)});
      case 6:
        return encode_lockstep_served(stamp);
      case 7:
        return encode_leg_command(side, stamp, {.mode = LegMode::kPosition});
      case 8:
        return encode_leg_inertial(side, stamp, {});
      case 9:
        return encode_foot_inertial(side, stamp, {});
      default:
        return encode_emergency(node, stamp, {});
    }
  }

  std::mt19937 random_;
};

/// An endless source of such frames, in batches of any size.
class MonkeyBus final : public CanBus {
 public:
  explicit MonkeyBus(std::uint32_t seed) : monkey_(seed) {}

  std::size_t send(std::span<const CanFrame> frames) noexcept override {
    return monkey_.below(static_cast<std::uint32_t>(frames.size() + 1));
  }

  std::size_t receive(std::span<CanFrame> frames) noexcept override {
    const std::size_t count = monkey_.below(static_cast<std::uint32_t>(frames.size() + 1));
    for (CanFrame& frame : frames.first(count)) frame = monkey_.next(tick);
    delivered += count;
    return count;
  }

  std::uint32_t tick = 0;
  std::uint64_t delivered = 0;

 private:
  FrameMonkey monkey_;
};

template <typename Values>
void expect_inside(const Values& values, PhysicalRange range) {
  for (const double value : values) {
    ASSERT_TRUE(value >= range.lowest - 1e-9 && value <= range.highest + 1e-9) << value;
  }
}

void expect_plausible(const LegSensors& leg) {
  expect_inside(leg.angle_rad, kJointAngleRad);
  expect_inside(leg.rate_rad_s, kJointRateRadS);
  expect_inside(leg.torque_nm, kJointTorqueNm);
}

void expect_plausible(const ImuSensors& imu) {
  expect_inside(imu.angular_rate_body_rad_s, kAngularRateRadS);
  expect_inside(imu.specific_force_body_m_s2, kSpecificForceMS2);
}

void expect_plausible(const LegInertialSensors& leg) {
  expect_inside(std::array{leg.hip_roll_rate_rad_s}, kAngularRateRadS);
}

void expect_plausible(const FootInertialSensors& foot) {
  expect_inside(std::array{foot.roll_rad, foot.pitch_rad}, kSoleTiltRad);
  expect_inside(std::array{foot.specific_force_x_foot_m_s2, foot.specific_force_y_foot_m_s2}, kSpecificForceMS2);
}

TEST(FuzzCan, DecodersLetOnlyPlausibleValuesThrough) {
  FrameMonkey monkey(1);
  std::array<int, kRejectionCauses> outcomes{};
  for (int i = 0; i < kFrames; ++i) {
    const CanFrame frame = monkey.next(static_cast<std::uint32_t>(i));
    FrameStamp stamp;
    LegSensors leg;
    LegStatus status;
    FootSensors foot;
    ImuSensors imu;
    LegCommand command;
    LegInertialSensors leg_inertial;
    FootInertialSensors foot_inertial;
    Heartbeat heartbeat;
    Emergency emergency;
    for (const Rejection outcome :
         {decode_sync(frame, stamp), decode_leg_command(frame, stamp, command),
          decode_leg_state(frame, stamp, leg, status), decode_foot_force(frame, stamp, foot),
          decode_imu(frame, stamp, imu), decode_heartbeat(frame, stamp, heartbeat),
          decode_emergency(frame, stamp, emergency), decode_lockstep_served(frame, stamp),
          decode_leg_inertial(frame, stamp, leg_inertial), decode_foot_inertial(frame, stamp, foot_inertial)}) {
      ++outcomes[static_cast<std::size_t>(outcome)];
    }
    expect_plausible(leg);
    expect_plausible(imu);
    expect_inside(foot.corner_force_n, kCornerForceN);
    expect_plausible(leg_inertial);
    expect_plausible(foot_inertial);
    expect_inside(command.torque_nm, kJointTorqueNm);
    expect_inside(command.angle_rad, kJointAngleRad);
    ASSERT_LE(command.mode, LegMode::kPosition);
    if (HasFatalFailure()) return;
  }
  for (const Rejection reached : {Rejection::kNone, Rejection::kUnknownIdentifier, Rejection::kWrongLength,
                                  Rejection::kWrongCrc, Rejection::kImplausible}) {
    EXPECT_GT(outcomes[static_cast<std::size_t>(reached)], kFrames / 200) << static_cast<int>(reached);
  }
}

TEST(FuzzCan, TheReceiverAccountsForEveryFrameAndKeepsASaneSnapshot) {
  for (const std::uint32_t seed : {1U, 2U, 3U}) {
    MonkeyBus bus(seed);
    FrameExchange exchange;
    for (std::uint32_t tick = 65'000; tick < 66'000; ++tick) {
      bus.tick = tick;
      exchange.begin_tick(bus, tick);
      static_cast<void>(exchange.collect(bus));
      const SensorSnapshot& snapshot = exchange.finish_collecting();
      ASSERT_EQ(snapshot.tick, tick);
      for (const Side side : kSides) {
        expect_plausible(snapshot.leg[index(side)]);
        expect_inside(snapshot.foot[index(side)].corner_force_n, kCornerForceN);
        expect_plausible(snapshot.leg_inertial[index(side)]);
        expect_plausible(snapshot.foot_inertial[index(side)]);
      }
      expect_plausible(snapshot.torso);
      if (HasFatalFailure()) return;
      exchange.send_commands(bus, {});
    }
    std::uint64_t accounted = exchange.counters().received;
    for (const std::uint64_t count : exchange.counters().rejected) accounted += count;
    EXPECT_EQ(accounted, bus.delivered);
    for (std::size_t cause = 1; cause < exchange.counters().rejected.size(); ++cause) {
      EXPECT_GT(exchange.counters().rejected[cause], 0U) << "seed " << seed << ", cause " << cause;
    }
  }
}

}  // namespace
}  // namespace surefoot::can
