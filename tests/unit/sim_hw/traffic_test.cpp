#include "sim_hw/bus/traffic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <vector>

#include "firmware/can/messages.hpp"

namespace surefoot::sim_hw {
namespace {

// What the codec really sends, one of each.
std::vector<can::CanFrame> one_of_each() {
  std::vector<can::CanFrame> frames{can::encode_sync({}), can::encode_imu({}, {})};
  for (const Side side : kSides) {
    frames.push_back(can::encode_leg_state(side, {}, {}, {}));
    frames.push_back(can::encode_foot_force(side, {}, {}));
    frames.push_back(can::encode_leg_command(side, {}, {}));
    frames.push_back(can::encode_leg_command(side, {}, {.mode = LegMode::kPosition}));
    frames.push_back(can::encode_leg_inertial(side, {}, {}));
    frames.push_back(can::encode_foot_inertial(side, {}, {}));
  }
  for (const can::Node node : can::kNodes) {
    frames.push_back(can::encode_heartbeat(node, {}, {}));
    frames.push_back(can::encode_emergency(node, {}, {}));
  }
  return frames;
}

TEST(RobotTraffic, IsWhatTheCodecSends) {
  const std::vector<can::CanFrame> frames = one_of_each();
  EXPECT_EQ(robot_traffic().size(), frames.size());
  for (const can::CanFrame& frame : frames) {
    const std::size_t place = stream_of(frame.identifier);
    ASSERT_LT(place, robot_traffic().size()) << frame.identifier;
    EXPECT_EQ(robot_traffic()[place].identifier, frame.identifier);
    EXPECT_EQ(robot_traffic()[place].length, frame.length) << robot_traffic()[place].name;
  }
}

TEST(RobotTraffic, RisesWithTheIdentifier) {
  EXPECT_TRUE(std::ranges::is_sorted(robot_traffic(), std::less{}, &TrafficStream::identifier));
}

std::vector<std::uint16_t> of_each_tick(TrafficOptions options) {
  std::vector<std::uint16_t> identifiers;
  for (const TrafficStream& stream : streams_of(options)) {
    if (stream.period_ticks == 1) identifiers.push_back(stream.identifier);
  }
  return identifiers;
}

TEST(RobotTraffic, IsThatOfTheRobotAtHand) {
  using Identifiers = std::vector<std::uint16_t>;
  EXPECT_EQ(of_each_tick({}), (Identifiers{0x080, 0x181, 0x182, 0x183, 0x184, 0x185, 0x201, 0x202}));
  EXPECT_EQ(of_each_tick({.has_inertial_legs = true, .commands_angles = true}),
            (Identifiers{0x080, 0x181, 0x182, 0x183, 0x184, 0x185, 0x281, 0x282, 0x283, 0x284, 0x301, 0x302}));
  EXPECT_EQ(streams_of({}).size(), robot_traffic().size() - 6) << "without what it never sends";
  EXPECT_EQ(streams_of({.has_inertial_legs = true, .commands_angles = true}).size(), robot_traffic().size())
      << "with the torque frames, which damp";
}

TEST(RobotTraffic, KnowsNoStrangers) {
  for (const std::uint16_t identifier :
       std::initializer_list<std::uint16_t>{0x000, 0x100, 0x203, 0x7FF, 0x800, 0xFFFF}) {
    EXPECT_EQ(stream_of(identifier), kNoStream);
  }
}

TEST(TravelsOn, OneBusCarriesEverything) {
  for (std::uint16_t identifier = 0; identifier <= 0x7FF; ++identifier) {
    EXPECT_TRUE(travels_on(identifier, 0, 1));
    EXPECT_FALSE(travels_on(identifier, 1, 1));
  }
}

TEST(TravelsOn, TwoBusesShareTheLegsAndBothHearTheController) {
  using can::Node;
  for (const std::uint16_t both : {can::kSyncIdentifier, can::heartbeat_identifier(Node::kController),
                                   can::emergency_identifier(Node::kController)}) {
    EXPECT_TRUE(travels_on(both, 0, 2) && travels_on(both, 1, 2)) << both;
  }
  for (const Node node : {Node::kLegRight, Node::kFootRight, Node::kTorsoImu}) {
    EXPECT_TRUE(travels_on(can::state_identifier(node), 0, 2) && !travels_on(can::state_identifier(node), 1, 2));
  }
  for (const Node node : {Node::kLegLeft, Node::kFootLeft}) {
    EXPECT_TRUE(!travels_on(can::heartbeat_identifier(node), 0, 2) &&
                travels_on(can::heartbeat_identifier(node), 1, 2));
    EXPECT_TRUE(!travels_on(can::emergency_identifier(node), 0, 2) &&
                travels_on(can::emergency_identifier(node), 1, 2));
  }
  EXPECT_TRUE(travels_on(can::command_identifier(Node::kLegLeft), 1, 2));
  EXPECT_TRUE(travels_on(can::command_identifier(Node::kLegRight), 0, 2));
}

TEST(BitTimes, AreTheRatesInverse) {
  const BitTiming timing = bit_timing({.nominal_bit_rate_hz = 500e3, .data_bit_rate_hz = 8e6});
  EXPECT_EQ(timing.nominal_bit_ns, 2000U);
  EXPECT_EQ(timing.data_bit_ns, 125U);
}

}  // namespace
}  // namespace surefoot::sim_hw
