#include "sim_hw/bus/tick_timeline.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace surefoot::sim_hw {
namespace {

using Identifiers = std::initializer_list<std::uint16_t>;

can::CanFrame frame_of(std::uint16_t identifier) {
  can::CanFrame frame{.identifier = identifier, .length = robot_traffic()[stream_of(identifier)].length};
  frame.payload.fill(0x55);  // few stuff bits
  return frame;
}

std::int64_t wire_ns(std::uint16_t identifier) {
  return static_cast<std::int64_t>(duration_ns(frame_bits(frame_of(identifier))));
}

void take_tick(TickTimeline& timeline, Identifiers with = {}) {
  timeline.take(frame_of(0x080));
  for (const std::uint16_t identifier : Identifiers{0x181, 0x183, 0x182, 0x184, 0x185})
    timeline.take(frame_of(identifier));
  for (const std::uint16_t identifier : with) timeline.take(frame_of(identifier));
  for (const std::uint16_t identifier : Identifiers{0x201, 0x202}) timeline.take(frame_of(identifier));
}

std::int64_t response_ns(const TickTimeline& timeline, std::uint16_t identifier, std::uint32_t bus = 0) {
  return timeline.tally(bus).stream(stream_of(identifier)).worst_response_ns;
}

// All answers are ready as SYNC ends, and go by identifier; the torques when the last is there and 20 us later.
TEST(TickTimeline, FramesFollowTheTickOneAfterAnother) {
  TickTimeline timeline({}, 1e-3, 1);
  take_tick(timeline);
  timeline.finish();
  EXPECT_EQ(response_ns(timeline, 0x080), wire_ns(0x080));
  EXPECT_EQ(response_ns(timeline, 0x181), wire_ns(0x181));
  EXPECT_EQ(response_ns(timeline, 0x182), wire_ns(0x181) + wire_ns(0x182));
  EXPECT_EQ(response_ns(timeline, 0x185),
            wire_ns(0x181) + wire_ns(0x182) + wire_ns(0x183) + wire_ns(0x184) + wire_ns(0x185));
  EXPECT_EQ(response_ns(timeline, 0x201), wire_ns(0x201));
  EXPECT_EQ(response_ns(timeline, 0x202), wire_ns(0x201) + wire_ns(0x202));
  EXPECT_EQ(timeline.tally(0).frames(), 8U);
}

// A heartbeat finds the bus free while the controller computes, and the torques wait for its end.
TEST(TickTimeline, AHeartbeatInTheComputingTimeBlocksTheTorques) {
  TickTimeline timeline({.compute_s = 20e-6}, 1e-3, 1);
  take_tick(timeline, {0x703});
  timeline.finish();
  EXPECT_EQ(response_ns(timeline, 0x201), wire_ns(0x703) - 20'000 + wire_ns(0x201));
}

// With no computing time they are ready as the last state ends, and win.
TEST(TickTimeline, TorquesReadyAtOnceGoAheadOfAHeartbeat) {
  TickTimeline timeline({.compute_s = 0.0}, 1e-3, 1);
  take_tick(timeline, {0x703});
  timeline.finish();
  EXPECT_EQ(response_ns(timeline, 0x201), wire_ns(0x201));
}

TEST(TickTimeline, TwoBusesWorkSideBySideAndBothCarrySync) {
  TickTimeline timeline({.count = 2}, 1e-3, 1);
  take_tick(timeline);
  timeline.finish();
  EXPECT_EQ(timeline.tally(0).frames(), 5U);  // SYNC, leg, foot, IMU, torques
  EXPECT_EQ(timeline.tally(1).frames(), 4U);
  EXPECT_EQ(response_ns(timeline, 0x182, 1), wire_ns(0x182));
  EXPECT_EQ(response_ns(timeline, 0x202, 1), wire_ns(0x202));
  EXPECT_EQ(response_ns(timeline, 0x182, 0), 0);
}

// Load and bits are those of the frames, however they were timed.
TEST(TickTimeline, WeighsEveryFrameOnce) {
  TickTimeline timeline({}, 1e-3, 1);
  BusTally expected;
  for (int tick = 0; tick < 50; ++tick) take_tick(timeline, {0x701});
  timeline.finish();
  for (const std::uint16_t identifier : Identifiers{0x080, 0x181, 0x182, 0x183, 0x184, 0x185, 0x201, 0x202, 0x701}) {
    for (int tick = 0; tick < 50; ++tick) expected.add_bits(frame_bits(frame_of(identifier)));
  }
  EXPECT_EQ(timeline.tally(0).busy_ns(), expected.busy_ns());
  EXPECT_DOUBLE_EQ(timeline.load_percent(50'000'000), expected.load_percent(50'000'000));
}

// More than the bus can hold in a tick waits for the next, SYNC goes ahead of it, and none is lost.
TEST(TickTimeline, WhatATickCannotFinishGoesOnInTheNext) {
  TickTimeline timeline({}, 1e-3, 1);
  for (int tick = 0; tick < 3; ++tick) {
    take_tick(timeline);
    for (int i = 0; i < 10; ++i) timeline.take(frame_of(0x701));
  }
  timeline.finish();
  EXPECT_EQ(timeline.tally(0).frames(), 54U);
  EXPECT_GT(response_ns(timeline, 0x701), 1'000'000);
  EXPECT_LT(response_ns(timeline, 0x080), wire_ns(0x701) + wire_ns(0x080));
}

TEST(TickTimeline, WeighsABabbleThatNoQueueHolds) {
  TickTimeline timeline({}, 1e-3, 1);
  timeline.take(frame_of(0x080));
  const can::CanFrame stranger{.identifier = 0x123, .length = 8};
  for (int i = 0; i < 1000; ++i) timeline.take(stranger);
  timeline.finish();
  EXPECT_EQ(timeline.tally(0).frames(), 1001U);
  EXPECT_EQ(timeline.tally(0).busy_ns(),
            static_cast<std::uint64_t>(wire_ns(0x080)) + 1000U * duration_ns(frame_bits(stranger)));
}

TEST(TickTimeline, LatencyAndJitterDelayTheAnswersAndSoTheTorques) {
  TickTimeline prompt({}, 1e-3, 1);
  TickTimeline slow({.node_latency_s = 100e-6, .node_jitter_s = 40e-6}, 1e-3, 7);
  TickTimeline same_seed({.node_latency_s = 100e-6, .node_jitter_s = 40e-6}, 1e-3, 7);
  for (TickTimeline* timeline : {&prompt, &slow, &same_seed}) {
    for (int tick = 0; tick < 100; ++tick) take_tick(*timeline);
    timeline->finish();
  }
  EXPECT_NE(response_ns(slow, 0x182), response_ns(prompt, 0x182));
  EXPECT_EQ(response_ns(slow, 0x182), response_ns(same_seed, 0x182));
  EXPECT_EQ(slow.tally(0).busy_ns(), prompt.tally(0).busy_ns());
}

}  // namespace
}  // namespace surefoot::sim_hw
