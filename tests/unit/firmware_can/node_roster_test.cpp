#include "firmware/can/node_roster.hpp"

#include <gtest/gtest.h>

namespace surefoot::can {
namespace {

constexpr Heartbeat kReady{.state = NodeState::kPreOperational};

NodeRoster all_ready() {
  NodeRoster roster;
  for (const Node node : kSensorNodes) static_cast<void>(roster.on_heartbeat(node, kReady, 0));
  return roster;
}

TEST(NodeRoster, IsReadyWhenAllFiveHaveAnnouncedThemselves) {
  EXPECT_TRUE(all_ready().is_everybody_ready());
  for (const Node missing : kSensorNodes) {
    NodeRoster roster;
    for (const Node node : kSensorNodes) {
      if (node != missing) static_cast<void>(roster.on_heartbeat(node, kReady, 0));
    }
    EXPECT_FALSE(roster.is_everybody_ready()) << name(missing);
  }
}

TEST(NodeRoster, TakesANodeForStaleAfterThreeOfTheControllersOwnHeartbeats) {
  for (const Node silent : kSensorNodes) {
    NodeRoster roster = all_ready();
    for (int beat = 0; beat < 4; ++beat) {
      EXPECT_TRUE(roster.is_everybody_ready());
      roster.on_own_heartbeat();
      for (const Node node : kSensorNodes) {
        if (node != silent) static_cast<void>(roster.on_heartbeat(node, kReady, 0));
      }
    }
    EXPECT_FALSE(roster.is_everybody_ready());
    EXPECT_EQ(roster.status(silent).missed_heartbeats, 4U);
    static_cast<void>(roster.on_heartbeat(silent, kReady, 0));
    EXPECT_TRUE(roster.is_everybody_ready());
  }
}

TEST(NodeRoster, AccusesANodeOfAnotherVersionUntilItSpeaksOurs) {
  for (const Node foreign : kSensorNodes) {
    NodeRoster roster = all_ready();
    EXPECT_EQ(roster.finding().fault, safety::Fault::kNone);
    static_cast<void>(roster.on_heartbeat(foreign, {.state = NodeState::kOperational, .protocol_version = 9}, 5));
    EXPECT_FALSE(roster.is_everybody_ready());
    EXPECT_TRUE(roster.status(foreign).is_foreign());
    EXPECT_EQ(roster.status(foreign).protocol_version, 9);
    EXPECT_EQ(roster.finding().fault, safety::Fault::kForeignVersion);
    EXPECT_EQ(roster.finding().needs,
              is_leg_board(foreign) ? safety::SafeState::kDamp : safety::SafeState::kStanceHold);
    static_cast<void>(roster.on_heartbeat(foreign, kReady, 6));
    EXPECT_EQ(roster.finding().fault, safety::Fault::kNone);
  }
}

TEST(NodeRoster, CountsABootUpAsARestartOnceTheNodeIsKnown) {
  NodeRoster roster;
  EXPECT_TRUE(roster.on_heartbeat(Node::kFootRight, {.state = NodeState::kBootUp}, 0));
  EXPECT_EQ(roster.status(Node::kFootRight).restarts, 0U);
  EXPECT_FALSE(roster.on_heartbeat(Node::kFootRight, {.state = NodeState::kOperational}, 103));
  EXPECT_TRUE(roster.on_heartbeat(Node::kFootRight, {.state = NodeState::kBootUp}, 700));
  const NodeStatus& status = roster.status(Node::kFootRight);
  EXPECT_EQ(status.restarts, 1U);
  EXPECT_EQ(status.last_heartbeat_tick, 700U);
  EXPECT_EQ(status.state, NodeState::kBootUp);
  EXPECT_FALSE(roster.status(Node::kFootLeft).was_announced);
}

TEST(NodeRoster, HasNoForeignerInANodeThatNeverSpoke) { EXPECT_EQ(NodeRoster().finding().fault, safety::Fault::kNone); }

}  // namespace
}  // namespace surefoot::can
