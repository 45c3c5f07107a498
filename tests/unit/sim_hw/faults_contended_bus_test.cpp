#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "firmware/can/messages.hpp"
#include "sim_hw/faults/contended_bus.hpp"

namespace surefoot::sim_hw {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using Identifiers = std::vector<std::uint16_t>;

const can::CanFrame kSync = can::encode_sync({.tick = 7});
const can::CanFrame kBabbled = can::encode_emergency(can::Node::kTorsoImu, {.tick = 7}, {});

/// One tick after the other, with the frames of a walking robot.
class Bus {
 public:
  explicit Bus(const BusConfig& config = {}) : bus_(config, 1e-3, 1) { begin(0); }

  Identifiers begin(std::int64_t elapsed = 1) {
    Identifiers late;
    while (const auto arrival = bus_.finish_period(elapsed)) late.push_back(arrival->frame.identifier);
    bus_.begin_period(period_ += elapsed, elapsed);
    return late;
  }

  void babble(int count, const can::CanFrame& frame = kBabbled) {
    for (int i = 0; i < count; ++i) taken += bus_.babble(frame, static_cast<double>(i) / count, false) ? 1 : 0;
  }

  Identifiers sync() { return cross({kSync}, true); }
  Identifiers answers() {
    return cross({can::encode_leg_state(Side::kRight, {}, {}, {}), can::encode_leg_state(Side::kLeft, {}, {}, {}),
                  can::encode_foot_force(Side::kRight, {}, {}), can::encode_foot_force(Side::kLeft, {}, {}),
                  can::encode_imu({}, {})},
                 false);
  }
  Identifiers commands() {
    return cross({can::encode_leg_command(Side::kRight, {}, {}), can::encode_leg_command(Side::kLeft, {}, {})}, true);
  }

  int taken = 0;

 private:
  Identifiers cross(const std::vector<can::CanFrame>& frames, bool is_for_nodes) {
    for (const can::CanFrame& frame : frames) EXPECT_TRUE(bus_.queue(frame, is_for_nodes));
    Identifiers crossed;
    while (const auto arrival = bus_.advance()) {
      crossed.push_back(arrival->frame.identifier);
      EXPECT_EQ(arrival->is_for_nodes, crossed.back() == 0x080 || (crossed.back() & 0x780) == 0x200);
    }
    return crossed;
  }

  ContendedBus bus_;
  std::int64_t period_ = 0;
};

TEST(ContendedBus, CarriesTheRobotsTickInItsTickByPriority) {
  Bus bus;
  for (int tick = 0; tick < 100; ++tick) {
    EXPECT_THAT(bus.sync(), ElementsAre(0x080));
    EXPECT_THAT(bus.answers(), ElementsAre(0x181, 0x182, 0x183, 0x184, 0x185));
    EXPECT_THAT(bus.commands(), ElementsAre(0x201, 0x202));
    EXPECT_THAT(bus.begin(), IsEmpty());
  }
}

// At 1 and 5 Mbit/s an emergency lasts some 50 us, the robot's tick some 650: five fit in, twelve do not.
TEST(ContendedBus, BabbleOfHighPriorityKeepsTheLowestFramesOutOfTheirTick) {
  Bus bus;
  bus.babble(12);
  Identifiers in_tick = bus.sync();
  for (const Identifiers& more : {bus.answers(), bus.commands()}) {
    in_tick.insert(in_tick.end(), more.begin(), more.end());
  }
  EXPECT_EQ(std::ranges::count(in_tick, 0x080), 1);
  EXPECT_EQ(std::ranges::count(in_tick, 0x181), 1);
  EXPECT_EQ(std::ranges::count(in_tick, 0x202), 0) << "the last of all";
  Identifiers later = bus.begin();
  const Identifiers next = bus.answers();
  later.insert(later.end(), next.begin(), next.end());
  const Identifiers rest = bus.commands();
  later.insert(later.end(), rest.begin(), rest.end());
  EXPECT_GE(std::ranges::count(later, 0x202), 1) << "it arrives in the next";
}

TEST(ContendedBus, FloodStarvesTheStatesButNotSyncAndEndsWithTheFlood) {
  Bus bus;
  for (int tick = 0; tick < 20; ++tick) {
    (void)bus.begin();
    bus.babble(200);
    const Identifiers crossed = bus.sync();
    EXPECT_EQ(std::ranges::count(crossed, 0x080), 1);
    EXPECT_THAT(bus.answers(), ::testing::Not(::testing::Contains(0x185)));
  }
  EXPECT_LT(bus.taken, 20 * 30) << "no more than the bus carries";
  for (int tick = 0; tick < 40; ++tick) {
    (void)bus.begin();
    (void)bus.sync();
  }
  EXPECT_THAT(bus.begin(), IsEmpty());
  EXPECT_THAT(bus.answers(), ElementsAre(0x181, 0x182, 0x183, 0x184, 0x185));
}

TEST(ContendedBus, ALongPauseLetsEverythingArrive) {
  Bus bus;
  bus.babble(20);
  (void)bus.answers();
  const Identifiers late = bus.begin(1000);
  EXPECT_THAT(late, ::testing::Contains(0x185));
  EXPECT_THAT(bus.begin(), IsEmpty());
}

TEST(ContendedBus, OnTwoBusesEachFrameArrivesOnceAndBabbleHurtsOnlyItsOwn) {
  BusConfig two;
  two.count = 2;
  Bus bus(two);
  bus.babble(20);  // the torso is on the right leg's bus
  EXPECT_EQ(std::ranges::count(bus.sync(), 0x080), 1);
  const Identifiers crossed = bus.answers();
  EXPECT_THAT(crossed, ::testing::Contains(0x182));
  EXPECT_THAT(crossed, ::testing::Contains(0x184));
  EXPECT_THAT(crossed, ::testing::Not(::testing::Contains(0x185)));
}

TEST(ContendedBus, LatencyAndJitterOfTheNodesDelayTheirAnswers) {
  BusConfig slow;
  slow.node_latency_s = 8e-4;
  Bus bus(slow);
  (void)bus.sync();
  EXPECT_LT(bus.answers().size(), 5U);
  EXPECT_FALSE(bus.begin().empty());
}

}  // namespace
}  // namespace surefoot::sim_hw
