#include "firmware/can/other_master.hpp"

#include <gtest/gtest.h>

namespace surefoot::can {
namespace {

CanFrame controller_heartbeat(std::uint32_t tick) {
  return encode_heartbeat(Node::kController, {.tick = tick}, {.state = NodeState::kOperational});
}

TEST(OtherMaster, IsWhoeverSendsTheControllersFramesOfThisTickOrOfOneToCome) {
  for (const std::uint32_t tick : {0U, 5000U, 65'535U, 65'536U, 4'000'000'000U}) {
    for (const std::uint32_t ahead : {0U, 1U, 1000U}) {
      EXPECT_TRUE(is_of_another_master(encode_sync({.tick = tick + ahead}), tick));
      EXPECT_TRUE(is_of_another_master(controller_heartbeat(tick + ahead), tick));
      for (const Side side : kSides) {
        EXPECT_TRUE(is_of_another_master(encode_leg_command(side, {.tick = tick + ahead}, {}), tick));
        EXPECT_TRUE(
            is_of_another_master(encode_leg_command(side, {.tick = tick + ahead}, {.mode = LegMode::kPosition}), tick));
      }
    }
    EXPECT_TRUE(is_of_another_master(encode_sync({.tick = tick + 100'000}), tick)) << "it runs for longer than we do";
  }
}

TEST(OtherMaster, IsNotAnOldFramePlayedBack) {
  for (const std::uint32_t tick : {70'000U, 4'000'000'000U}) {
    for (const std::uint32_t age : {1U, 100U, 30'000U, 64'000U}) {
      EXPECT_FALSE(is_of_another_master(encode_sync({.tick = tick - age}), tick)) << age;
      EXPECT_FALSE(is_of_another_master(controller_heartbeat(tick - age), tick)) << age;
      EXPECT_FALSE(is_of_another_master(encode_leg_command(Side::kLeft, {.tick = tick - age}, {}), tick)) << age;
    }
  }
}

TEST(OtherMaster, SpeaksInIntactFramesThatOnlyAControllerSends) {
  CanFrame damaged = encode_sync({.tick = 7});
  damaged.payload[4] ^= 1;
  CanFrame cut = encode_leg_command(Side::kRight, {.tick = 7}, {});
  cut.length = 16;
  for (const CanFrame& frame :
       {damaged, cut, encode_imu({.tick = 7}, {}), encode_heartbeat(Node::kLegRight, {.tick = 7}, {}),
        encode_emergency(Node::kController, {.tick = 7}, {}), encode_lockstep_served({.tick = 7}),
        CanFrame{.identifier = 0x123}}) {
    EXPECT_FALSE(is_of_another_master(frame, 7)) << frame.identifier;
    EXPECT_FALSE(is_of_a_master(frame)) << frame.identifier;
  }
}

TEST(OtherMaster, IsAnyMasterAtAllWhileNoTickRuns) {
  EXPECT_TRUE(is_of_a_master(encode_sync({.tick = 3})));
  EXPECT_TRUE(is_of_a_master(encode_leg_command(Side::kLeft, {.tick = 3}, {})));
  EXPECT_TRUE(is_of_a_master(controller_heartbeat(3)));
}

}  // namespace
}  // namespace surefoot::can
