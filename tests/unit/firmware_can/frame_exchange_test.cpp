#include <gtest/gtest.h>

#include "tests/unit/firmware_can/frame_exchange_fixture.hpp"

namespace surefoot::can {
namespace {

using FrameExchangeTest = testing::FrameExchangeTest;

TEST_F(FrameExchangeTest, OpensEachTickWithASyncOfThatTick) {
  for (std::uint32_t tick : {70'001U, 70'002U}) exchange.begin_tick(bus, tick);
  ASSERT_EQ(bus.sent.size(), 2U);
  FrameStamp first;
  FrameStamp second;
  ASSERT_EQ(decode_sync(bus.sent[0], first), Rejection::kNone);
  ASSERT_EQ(decode_sync(bus.sent[1], second), Rejection::kNone);
  EXPECT_EQ(first.tick, 70'001U);
  EXPECT_EQ(second.tick, 70'002U);
  EXPECT_EQ(second.counter, first.counter + 1);
}

TEST_F(FrameExchangeTest, SendsItsHeartbeatEveryHundredTicksAfterTheSync) {
  for (std::uint32_t tick = 0; tick <= 200; ++tick) exchange.begin_tick(bus, tick);
  ASSERT_EQ(bus.sent.size(), 201U + 3U);
  for (const std::size_t place : {std::size_t{1}, std::size_t{102}, std::size_t{203}}) {
    FrameStamp stamp;
    Heartbeat heartbeat;
    EXPECT_EQ(bus.sent[place].identifier, heartbeat_identifier(Node::kController));
    ASSERT_EQ(decode_heartbeat(bus.sent[place], stamp, heartbeat), Rejection::kNone);
    EXPECT_EQ(heartbeat.state, NodeState::kOperational);
    EXPECT_EQ(heartbeat.protocol_version, kProtocolVersion);
    EXPECT_EQ(stamp.counter, place / 101);
  }
}

TEST_F(FrameExchangeTest, IsCompleteOnlyWhenAllFiveNodesHaveAnswered) {
  const std::vector<CanFrame> answer = robot.answer(1);
  for (std::size_t missing = 0; missing < answer.size(); ++missing) {
    FrameExchange fresh;
    fresh.begin_tick(bus, 1);
    bus.incoming = answer;
    bus.incoming.erase(bus.incoming.begin() + static_cast<std::ptrdiff_t>(missing));
    EXPECT_FALSE(fresh.collect(bus)) << missing;
    bus.incoming = {answer[missing]};
    EXPECT_TRUE(fresh.collect(bus)) << missing;
  }
}

TEST_F(FrameExchangeTest, PutsEachNodesValuesInItsPlace) {
  const SensorSnapshot& snapshot = run_tick(9, robot.answer(9));
  EXPECT_EQ(snapshot.tick, 9U);
  EXPECT_NEAR(snapshot.leg[index(Side::kRight)].angle_rad[3], 0.25, 1e-9);
  EXPECT_NEAR(snapshot.leg[index(Side::kLeft)].angle_rad[3], -0.25, 1e-9);
  EXPECT_NEAR(snapshot.foot[index(Side::kRight)].corner_force_n[0], 100.0, 1e-9);
  EXPECT_NEAR(snapshot.foot[index(Side::kLeft)].corner_force_n[0], 50.0, 1e-9);
  EXPECT_NEAR(snapshot.torso.specific_force_body_m_s2.z(), 9.81, 1e-9);
  EXPECT_TRUE(snapshot.leg[0].freshness.is_fresh());
  EXPECT_TRUE(snapshot.torso.freshness.is_fresh());
  EXPECT_TRUE(snapshot.leg[0].is_damping);
  EXPECT_EQ(exchange.counters().received, 5U);
  EXPECT_EQ(rejected(), 0U);
}

TEST_F(FrameExchangeTest, KeepsAndAgesTheValuesOfANodeThatFellSilentAndRenewsThem) {
  static_cast<void>(run_tick(1, robot.answer(1)));
  for (std::uint32_t tick = 2; tick <= 4; ++tick) {
    std::vector<CanFrame> answer = robot.answer(tick);
    answer.erase(answer.begin() + 2);  // the right foot
    const SensorSnapshot& snapshot = run_tick(tick, answer);
    EXPECT_EQ(snapshot.foot[index(Side::kRight)].freshness.age_ticks, tick - 1);
    EXPECT_NEAR(snapshot.foot[index(Side::kRight)].corner_force_n[0], 100.0, 1e-9);
    EXPECT_TRUE(snapshot.foot[index(Side::kLeft)].freshness.is_fresh());
  }
  EXPECT_EQ(exchange.counters().lost, 0U);  // a gap shows only when the counter comes back
  EXPECT_TRUE(run_tick(5, robot.answer(5)).foot[index(Side::kRight)].freshness.is_fresh());
  EXPECT_EQ(exchange.counters().lost, 3U);
  EXPECT_EQ(rejected(), 0U);
}

TEST_F(FrameExchangeTest, NeverTakesANodeForHeardThatWasNot) {
  for (std::uint32_t tick = 0; tick < 3; ++tick) {
    EXPECT_FALSE(run_tick(tick, {robot.imu(tick)}).leg[0].freshness.was_heard());
  }
}

TEST_F(FrameExchangeTest, DropsTheSecondCopyOfAFrame) {
  std::vector<CanFrame> answer = robot.answer(1);
  answer.push_back(answer.front());
  static_cast<void>(run_tick(1, answer));
  EXPECT_EQ(rejected(Rejection::kRepeated), 1U);
  EXPECT_EQ(exchange.counters().received, 5U);
}

TEST_F(FrameExchangeTest, DropsAnswersToAnotherTick) {
  static_cast<void>(run_tick(10, robot.answer(10)));
  const SensorSnapshot& snapshot = run_tick(11, robot.answer(10));
  EXPECT_EQ(rejected(Rejection::kLate), 5U);
  EXPECT_EQ(snapshot.torso.freshness.age_ticks, 1U);
  static_cast<void>(run_tick(12, robot.answer(13)));
  EXPECT_EQ(rejected(Rejection::kLate), 10U);
}

// An old frame whose counter is the one that comes next: were it to move the counter, the true frame
// would be taken for its copy and dropped.
TEST_F(FrameExchangeTest, IsNotBlindedByAnOldFramePlayedBack) {
  const CanFrame old = encode_imu({.tick = 1, .counter = 1}, {});
  static_cast<void>(run_tick(300, {robot.imu(300)}));  // counter 0
  const SensorSnapshot& snapshot = run_tick(301, {old, robot.imu(301)});
  EXPECT_EQ(rejected(Rejection::kLate), 1U);
  EXPECT_TRUE(snapshot.torso.freshness.is_fresh());
  EXPECT_NEAR(snapshot.torso.specific_force_body_m_s2.z(), 9.81, 1e-9);
  EXPECT_EQ(exchange.counters().lost, 0U);
}

TEST_F(FrameExchangeTest, ComparesTheLowSixteenBitsOfTheTick) {
  for (const std::uint32_t tick : {65'535U, 65'536U, 65'537U}) {
    EXPECT_TRUE(run_tick(tick, robot.answer(tick)).torso.freshness.is_fresh()) << tick;
  }
  EXPECT_EQ(rejected(), 0U);
}

TEST_F(FrameExchangeTest, NeverLetsADamagedOrImplausibleFrameReachTheSnapshot) {
  static_cast<void>(run_tick(1, {robot.imu(1)}));
  CanFrame damaged = robot.imu(2);
  damaged.payload[17] ^= 0x40;
  CanFrame cut = robot.imu(2);
  cut.length = 16;
  const SensorSnapshot& snapshot = run_tick(2, {damaged, cut});
  EXPECT_EQ(rejected(Rejection::kWrongCrc), 1U);
  EXPECT_EQ(rejected(Rejection::kWrongLength), 1U);
  EXPECT_NEAR(snapshot.torso.specific_force_body_m_s2.z(), 9.81, 1e-9);
  EXPECT_EQ(snapshot.torso.freshness.age_ticks, 1U);
}

TEST_F(FrameExchangeTest, AcceptsHeartbeatsAndEmergenciesOfNodesOnce) {
  const CanFrame heartbeat = encode_heartbeat(Node::kFootLeft, {.tick = 0, .counter = 0}, {});
  const CanFrame emergency = encode_emergency(Node::kLegRight, {.tick = 0, .counter = 0}, {.code = 0x8130});
  static_cast<void>(run_tick(50, {heartbeat, emergency}));
  EXPECT_EQ(exchange.counters().received, 2U);
  EXPECT_EQ(rejected(), 0U);
  static_cast<void>(run_tick(51, {heartbeat, emergency}));
  EXPECT_EQ(rejected(Rejection::kRepeated), 2U);
}

TEST_F(FrameExchangeTest, CountsEachNodeAndEachKindOfFrameOnItsOwn) {
  std::vector<CanFrame> incoming;
  for (const Node node : {Node::kLegRight, Node::kLegLeft, Node::kFootRight, Node::kFootLeft, Node::kTorsoImu}) {
    incoming.push_back(encode_heartbeat(node, {.tick = 1, .counter = 0}, {}));
    incoming.push_back(encode_emergency(node, {.tick = 1, .counter = 0}, {}));
  }
  const std::vector<CanFrame> answer = robot.answer(1);  // counter 0 as well
  incoming.insert(incoming.end(), answer.begin(), answer.end());
  static_cast<void>(run_tick(1, incoming));
  EXPECT_EQ(exchange.counters().received, 15U);
  EXPECT_EQ(rejected(), 0U);
  EXPECT_EQ(exchange.counters().lost, 0U);
}

TEST_F(FrameExchangeTest, RefusesANodeThatAnnouncesAnotherProtocolUntilItAnnouncesTheRightOne) {
  const auto heartbeat = [](std::uint8_t counter, std::uint8_t version) {
    return encode_heartbeat(Node::kFootLeft, {.tick = 1, .counter = counter},
                            {.state = NodeState::kOperational, .protocol_version = version});
  };
  static_cast<void>(run_tick(1, robot.answer(1)));
  exchange.begin_tick(bus, 2);
  bus.incoming = robot.answer(2);
  bus.incoming.insert(bus.incoming.begin(), heartbeat(0, kProtocolVersion + 1));
  EXPECT_FALSE(exchange.collect(bus)) << "its answer does not count";
  EXPECT_EQ(exchange.finish_collecting().foot[index(Side::kLeft)].freshness.age_ticks, 1U);
  EXPECT_EQ(rejected(Rejection::kForeignVersion), 2U);  // the heartbeat and the state
  EXPECT_EQ(exchange.finding().fault, safety::Fault::kForeignVersion);
  EXPECT_EQ(exchange.finding().needs, safety::SafeState::kStanceHold);
  EXPECT_TRUE(exchange.node_status(Node::kFootLeft).is_foreign());
  EXPECT_FALSE(run_tick(3, robot.answer(3)).foot[index(Side::kLeft)].freshness.is_fresh());

  std::vector<CanFrame> answer = robot.answer(4);
  answer.insert(answer.begin(), heartbeat(1, kProtocolVersion));
  EXPECT_TRUE(run_tick(4, answer).foot[index(Side::kLeft)].freshness.is_fresh());
  EXPECT_EQ(rejected(Rejection::kForeignVersion), 3U);
  EXPECT_EQ(exchange.finding().fault, safety::Fault::kNone);
}

TEST_F(FrameExchangeTest, ShowsARestartedNodeAndAcceptsItsCountersFromZeroOnAgain) {
  for (std::uint32_t tick = 1; tick <= 256; ++tick) static_cast<void>(run_tick(tick, robot.answer(tick)));
  const Heartbeat operational{.state = NodeState::kOperational};
  static_cast<void>(run_tick(257, {encode_heartbeat(Node::kTorsoImu, {.tick = 257, .counter = 0}, operational),
                                   encode_imu({.tick = 257, .counter = 0}, {})}));
  EXPECT_EQ(exchange.node_status(Node::kTorsoImu).restarts, 0U);
  const SensorSnapshot& snapshot =
      run_tick(258, {encode_heartbeat(Node::kTorsoImu, {.tick = 0, .counter = 0}, {.state = NodeState::kBootUp}),
                     encode_imu({.tick = 258, .counter = 0}, {})});
  EXPECT_TRUE(snapshot.torso.freshness.is_fresh());
  EXPECT_EQ(rejected(), 0U);
  EXPECT_EQ(exchange.node_status(Node::kTorsoImu).restarts, 1U);
  EXPECT_EQ(exchange.node_status(Node::kTorsoImu).last_heartbeat_tick, 258U);
}

TEST_F(FrameExchangeTest, KeepsTheLastEmergencyOfEachNode) {
  static_cast<void>(run_tick(7, {encode_emergency(Node::kLegLeft, {.tick = 7, .counter = 0}, {.code = 0x8150})}));
  EXPECT_EQ(exchange.node_status(Node::kLegLeft).last_emergency_code, 0x8150);
  EXPECT_EQ(exchange.node_status(Node::kLegLeft).emergencies, 1U);
  EXPECT_EQ(exchange.node_status(Node::kLegRight).emergencies, 0U);
}

// The simulated robot in lockstep: a node that is dead by scenario is not waited for.
TEST_F(FrameExchangeTest, ReportsAFaultAsAnEmergencyOfTheController) {
  exchange.begin_tick(bus, 77);
  bus.sent.clear();
  exchange.report(bus, safety::Fault::kSensorImplausible);
  ASSERT_EQ(bus.sent.size(), 1U);
  FrameStamp stamp;
  Emergency emergency;
  EXPECT_EQ(bus.sent[0].identifier, emergency_identifier(Node::kController));
  ASSERT_EQ(decode_emergency(bus.sent[0], stamp, emergency), Rejection::kNone);
  EXPECT_EQ(emergency.code, 0xFF08);
  EXPECT_EQ(stamp.tick, 77U);
}

TEST_F(FrameExchangeTest, CountsForeignersAndItsOwnIdentifiersSentByOthersAsUnknown) {
  CanFrame beyond_eleven_bits = robot.imu(1);
  beyond_eleven_bits.identifier = 0x1985;
  static_cast<void>(run_tick(1, {encode_sync({.tick = 1}), encode_leg_command(Side::kRight, {.tick = 1}, {}),
                                 encode_leg_command(Side::kLeft, {.tick = 1}, {}),
                                 encode_heartbeat(Node::kController, {}, {}), CanFrame{.identifier = 0x000},
                                 CanFrame{.identifier = 0x186}, CanFrame{.identifier = 0x7FF}, beyond_eleven_bits}));
  EXPECT_EQ(rejected(Rejection::kUnknownIdentifier), 8U);
  EXPECT_EQ(exchange.counters().received, 0U);
}

TEST_F(FrameExchangeTest, SendsTheTorquesOfThisTickToBothLegs) {
  exchange.begin_tick(bus, 66'000);
  bus.sent.clear();
  PerSide<LegCommand> command{};
  command[index(Side::kLeft)] = {.mode = LegMode::kTorque, .torque_nm = {1, 2, 3, 4, 5, 6}};
  exchange.send_commands(bus, command);
  ASSERT_EQ(bus.sent.size(), 2U);
  EXPECT_EQ(bus.sent[0].identifier, 0x201);
  EXPECT_EQ(bus.sent[1].identifier, 0x202);
  FrameStamp stamp;
  LegCommand heard;
  ASSERT_EQ(decode_leg_command(bus.sent[1], stamp, heard), Rejection::kNone);
  EXPECT_EQ(stamp.tick, 66'000U & 0xFFFFU);
  EXPECT_EQ(heard.mode, LegMode::kTorque);
  EXPECT_NEAR(heard.torque_nm[5], 6.0, 1e-9);
}

TEST_F(FrameExchangeTest, SendsAnglesToALegThatShallHoldThemAndTorquesOtherwise) {
  exchange.begin_tick(bus, 5);
  bus.sent.clear();
  PerSide<LegCommand> command{};
  command[index(Side::kRight)] = {.mode = LegMode::kPosition, .angle_rad = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6}};
  exchange.send_commands(bus, command);
  exchange.send_commands(bus, {});  // a damped leg is told so by a frame of torques
  exchange.send_commands(bus, command);
  constexpr std::array kExpected{0x301, 0x202, 0x201, 0x202, 0x301, 0x202};
  constexpr std::array kCounters{0, 0, 0, 1, 1, 2};  // each identifier counts on its own
  ASSERT_EQ(bus.sent.size(), kExpected.size());
  for (std::size_t i = 0; i < kExpected.size(); ++i) {
    FrameStamp stamp;
    LegCommand heard;
    EXPECT_EQ(bus.sent[i].identifier, kExpected[i]);
    ASSERT_EQ(decode_leg_command(bus.sent[i], stamp, heard), Rejection::kNone);
    EXPECT_EQ(stamp.counter, kCounters[i]);
    EXPECT_EQ(heard.mode, kExpected[i] == 0x301 ? LegMode::kPosition : LegMode::kDamp);
  }
}

TEST_F(FrameExchangeTest, CountsItsCommandsUpForEachLeg) {
  for (int tick = 0; tick < 3; ++tick) exchange.send_commands(bus, {});
  ASSERT_EQ(bus.sent.size(), 6U);
  for (std::size_t i = 0; i < bus.sent.size(); ++i) {
    FrameStamp stamp;
    LegCommand heard;
    ASSERT_EQ(decode_leg_command(bus.sent[i], stamp, heard), Rejection::kNone);
    EXPECT_EQ(stamp.counter, i / 2);
  }
}

TEST_F(FrameExchangeTest, CountsWhatTheBusDoesNotTake) {
  bus.room_for = 1;
  exchange.begin_tick(bus, 0);  // SYNC and heartbeat
  exchange.send_commands(bus, {});
  EXPECT_EQ(exchange.counters().sent, 2U);
  EXPECT_EQ(exchange.counters().refused_by_bus, 2U);
}

TEST_F(FrameExchangeTest, FindsTheAnswersBehindALongQueueOfNoiseButDoesNotReadAFloodForEver) {
  const CanFrame noise{.identifier = 0x555};
  exchange.begin_tick(bus, 1);
  bus.incoming.assign(1000, noise);
  const std::vector<CanFrame> answer = robot.answer(1);
  bus.incoming.insert(bus.incoming.end(), answer.begin(), answer.end());
  EXPECT_FALSE(exchange.collect(bus));
  EXPECT_EQ(bus.incoming.size(), 1005U - 256U);
  for (int call = 0; call < 2; ++call) EXPECT_FALSE(exchange.collect(bus));
  EXPECT_TRUE(exchange.collect(bus));
}

// A second sender on a node's identifier: its frame is intact and of this tick, its counter moves on.
TEST_F(FrameExchangeTest, KeepsTheFirstAnswerOfATickAndRefusesASecond) {
  std::vector<CanFrame> incoming = robot.answer(3);
  FootSensors forged;
  forged.corner_force_n.fill(1000.0);
  incoming.push_back(encode_foot_force(Side::kRight, {.tick = 3, .counter = robot.counter[2]}, forged));
  const SensorSnapshot& snapshot = run_tick(3, incoming);
  EXPECT_NEAR(snapshot.foot[index(Side::kRight)].corner_force_n[0], 100.0, 1e-9);
  EXPECT_EQ(rejected(Rejection::kRepeated), 1U);
  EXPECT_TRUE(run_tick(4, robot.answer(4)).foot[index(Side::kRight)].freshness.is_fresh()) << "the true node goes on";
}

}  // namespace
}  // namespace surefoot::can
