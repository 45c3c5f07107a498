#include <gtest/gtest.h>

#include "tests/unit/firmware_can/frame_exchange_fixture.hpp"

namespace surefoot::can {
namespace {

/// What happens before tick 0, and who else may be on the bus.
using FrameExchangeStartUpTest = testing::FrameExchangeTest;

TEST_F(FrameExchangeStartUpTest, AnnouncesItselfAndWaitsUntilEverybodyHasAnnouncedTheRightVersion) {
  exchange.announce(bus, NodeState::kPreOperational);
  ASSERT_EQ(bus.sent.size(), 1U);
  FrameStamp stamp;
  Heartbeat heartbeat;
  ASSERT_EQ(decode_heartbeat(bus.sent[0], stamp, heartbeat), Rejection::kNone);
  EXPECT_EQ(bus.sent[0].identifier, heartbeat_identifier(Node::kController));
  EXPECT_EQ(heartbeat.state, NodeState::kPreOperational);
  for (const Node node : kSensorNodes) {
    EXPECT_FALSE(exchange.is_everybody_ready());
    bus.incoming = {encode_heartbeat(node, {}, {.state = NodeState::kPreOperational})};
    exchange.listen(bus);
  }
  EXPECT_TRUE(exchange.is_everybody_ready());
}

TEST_F(FrameExchangeStartUpTest, TakesNoStateBeforeTheLoopAndNamesAMasterThatRunsAlready) {
  bus.incoming = robot.answer(0);  // to a SYNC of somebody else
  exchange.listen(bus);
  EXPECT_EQ(rejected(Rejection::kLate), 5U);
  EXPECT_EQ(exchange.finding().fault, safety::Fault::kNone);
  bus.incoming = {encode_sync({.tick = 400'000})};
  exchange.listen(bus);
  EXPECT_EQ(exchange.finding().fault, safety::Fault::kSecondMaster);
  exchange.announce(bus, NodeState::kPreOperational);
  EXPECT_EQ(exchange.finding().fault, safety::Fault::kNone) << "heard since the last announcement, or not";
}

TEST_F(FrameExchangeStartUpTest, TellsASecondMasterFromAnOldFramePlayedBack) {
  exchange.begin_tick(bus, 2000);
  bus.incoming = {encode_sync({.tick = 1999}), encode_leg_command(Side::kRight, {.tick = 1999}, {})};
  static_cast<void>(exchange.collect(bus));
  EXPECT_EQ(exchange.finding().fault, safety::Fault::kNone);
  EXPECT_EQ(exchange.counters().from_other_master, 0U);
  bus.incoming = {encode_leg_command(Side::kRight, {.tick = 2000}, {})};
  static_cast<void>(exchange.collect(bus));
  EXPECT_EQ(exchange.finding().fault, safety::Fault::kSecondMaster);
  EXPECT_EQ(exchange.finding().needs, safety::SafeState::kStanceHold);
  EXPECT_EQ(exchange.counters().from_other_master, 1U);
  EXPECT_EQ(rejected(Rejection::kUnknownIdentifier), 3U);
}

TEST_F(FrameExchangeStartUpTest, IsCompleteWhenTheSimulatedRobotSaysThatItHasServedThisTick) {
  bus.incoming = {encode_lockstep_served({})};
  exchange.listen(bus);
  EXPECT_TRUE(exchange.is_robot_in_lockstep());
  exchange.begin_tick(bus, 70'000);
  bus.incoming = {encode_lockstep_served({.tick = 69'999, .counter = 0})};
  EXPECT_FALSE(exchange.collect(bus));
  bus.incoming = {encode_lockstep_served({.tick = 70'000 - 65'536, .counter = 1})};
  EXPECT_FALSE(exchange.collect(bus)) << "it carries all 32 bits";
  EXPECT_EQ(rejected(Rejection::kLate), 2U);
  bus.incoming = {encode_lockstep_served({.tick = 70'000, .counter = 2})};
  EXPECT_TRUE(exchange.collect(bus));
  EXPECT_EQ(exchange.finish_collecting().torso.freshness.was_heard(), false);
  exchange.begin_tick(bus, 70'001);
  EXPECT_FALSE(exchange.collect(bus)) << "the next tick is awaited anew";
}

TEST_F(FrameExchangeStartUpTest, TakesAnAnnouncementThatCrossedTheFirstSyncForWhatItIs) {
  const CanFrame announcement = encode_lockstep_served({.tick = kAnnouncedBeforeAnyTick, .counter = 3});
  bus.incoming = {announcement};
  exchange.listen(bus);
  exchange.begin_tick(bus, 0);
  bus.incoming = {announcement};
  EXPECT_FALSE(exchange.collect(bus)) << "nothing was answered yet";
  EXPECT_EQ(rejected(Rejection::kLate), 0U);
  EXPECT_EQ(exchange.counters().lost, 0U);
}

TEST_F(FrameExchangeStartUpTest, DoesNotTakeTheWordOfALockstepRobotThatNeverSaidItWasOne) {
  exchange.begin_tick(bus, 5);
  bus.incoming = {encode_lockstep_served({.tick = 5})};
  EXPECT_FALSE(exchange.collect(bus)) << "one foreign frame a tick would make every node look silent";
}

TEST_F(FrameExchangeStartUpTest, AnnouncesItselfAgainAfterMissedTicks) {
  exchange.begin_tick(bus, 7);
  bus.sent.clear();
  exchange.begin_tick(bus, 8);
  EXPECT_EQ(bus.sent.size(), 1U) << "SYNC alone";
  bus.sent.clear();
  exchange.begin_tick(bus, 31);
  ASSERT_EQ(bus.sent.size(), 2U);
  EXPECT_EQ(bus.sent[1].identifier, heartbeat_identifier(Node::kController));
}

}  // namespace
}  // namespace surefoot::can
