#include "firmware/host/bus/bus_bundle.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "firmware/host/allocation_guard.hpp"
#include "firmware/host/bus/bus_address.hpp"
#include "tests/unit/firmware_host/frames.hpp"
#include "tests/unit/firmware_host/received.hpp"
#include "tests/vcan/interface.hpp"

namespace surefoot::host {
namespace {

using ::testing::ElementsAre;
using testing::frame_of;
using testing::from_now_ns;
using testing::identifiers;
using testing::Interface;
using testing::kLongNs;
using testing::number_of;
using testing::numbered_frame;
using testing::RawSocket;
using testing::receive_all;
using testing::received;

class Bundle : public ::testing::Test {
 protected:
  Interface right_{"sfbus4"};
  Interface left_{"sfbus5"};
  RawSocket raw_right_{"sfbus4"};
  RawSocket raw_left_{"sfbus5"};
  std::unique_ptr<HostBus> controller_ = open_bus("socketcan:sfbus4,sfbus5", BusRole::kController);
  std::unique_ptr<HostBus> robot_ = open_bus("socketcan:sfbus4,sfbus5", BusRole::kRobot);
};

std::vector<std::uint16_t> seen(const RawSocket& raw, std::size_t count) {
  std::vector<std::uint16_t> all;
  for (const canfd_frame& frame : raw.read(count)) all.push_back(static_cast<std::uint16_t>(frame.can_id));
  return all;
}

std::vector<can::CanFrame> frames_of(const std::vector<std::uint16_t>& identifiers) {
  std::vector<can::CanFrame> frames;
  for (const std::uint16_t identifier : identifiers) frames.push_back(frame_of(identifier, {1, 2, 3}));
  return frames;
}

TEST_F(Bundle, SendsEachLegsFramesOnItsBusAndTheControllersClockOnBoth) {
  EXPECT_EQ(controller_->send(frames_of({0x080, 0x77F, 0x201, 0x202})), 4U);
  EXPECT_THAT(seen(raw_right_, 3), ElementsAre(0x080, 0x77F, 0x201));
  EXPECT_THAT(seen(raw_left_, 3), ElementsAre(0x080, 0x77F, 0x202));
  EXPECT_EQ(robot_->send(
                frames_of({0x181, 0x182, 0x183, 0x184, 0x185, 0x081, 0x082, 0x084, 0x701, 0x702, 0x704, 0x705, 0x7F0})),
            13U);
  EXPECT_THAT(seen(raw_right_, 7), ElementsAre(0x181, 0x183, 0x185, 0x081, 0x701, 0x705, 0x7F0));
  EXPECT_THAT(seen(raw_left_, 6), ElementsAre(0x182, 0x184, 0x082, 0x084, 0x702, 0x704));
}

TEST_F(Bundle, HearsANodeOnTheWrongLegsBusAsWell) {
  raw_left_.send_fd(0x181, 8);
  EXPECT_TRUE(controller_->wait_readable(from_now_ns(kLongNs)));
  raw_right_.send_fd(0x182, 8);
  EXPECT_THAT(identifiers(received(*controller_, 2)), ElementsAre(0x181, 0x182));
}

TEST_F(Bundle, MergesBothBusesInTheOrderOfArrival) {
  for (int i = 0; i < 100; ++i) {
    raw_right_.send_fd(0x181, 8);
    raw_left_.send_fd(0x182, 8);
    raw_left_.send_fd(0x184, 8);
  }
  std::vector<can::CanFrame> batch(7);  // never a whole number of rounds
  std::vector<std::uint16_t> heard;
  std::int64_t last_ns = 0;
  while (heard.size() < 300 && controller_->wait_readable(from_now_ns(kLongNs))) {
    const std::size_t count = controller_->receive(batch);
    ASSERT_EQ(controller_->receive_times_ns().size(), count);
    for (std::size_t i = 0; i < count; ++i) {
      heard.push_back(batch[i].identifier);
      EXPECT_LE(last_ns, controller_->receive_times_ns()[i]);
      last_ns = controller_->receive_times_ns()[i];
    }
  }
  ASSERT_EQ(heard.size(), 300U);
  for (std::size_t i = 0; i < heard.size(); i += 3) {
    ASSERT_THAT((std::vector{heard[i], heard[i + 1], heard[i + 2]}), ElementsAre(0x181, 0x182, 0x184)) << i;
  }
}

TEST_F(Bundle, WhatItHoldsBackForTheNextCallIsReadable) {
  for (int i = 0; i < 3; ++i) raw_right_.send_fd(0x181, 8);
  std::vector<can::CanFrame> one(1);
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE(controller_->wait_readable(from_now_ns(kLongNs)));
    EXPECT_EQ(controller_->receive(one), 1U);
  }
  EXPECT_FALSE(controller_->wait_readable(0));
}

// Torques of a tick and SYNC of the next leave in one call: a board must not see SYNC first.
TEST_F(Bundle, SyncComesOnceAndAfterBothLegsTorques) {
  std::vector<can::CanFrame> batch(4);
  for (int tick = 0; tick < 200; ++tick) {
    controller_->send(frames_of({0x201, 0x202, 0x080, 0x77F}));
    ASSERT_EQ(receive_all(*robot_, batch), 4U);
    const std::vector<std::uint16_t> heard = identifiers(batch);
    ASSERT_THAT((std::vector{heard[0], heard[1]}), ::testing::UnorderedElementsAre(0x201, 0x202));
    ASSERT_THAT((std::vector{heard[2], heard[3]}), ElementsAre(0x080, 0x77F));
  }
}

TEST_F(Bundle, ASyncPlayedBackIsNoCopy) {
  raw_right_.send_fd(0x080, 8);
  raw_right_.send_fd(0x080, 8);
  raw_left_.send_fd(0x080, 8);  // the copy of the last one
  raw_left_.send_fd(0x080, 8);
  raw_right_.send_fd(0x201, 8);
  EXPECT_THAT(identifiers(received(*robot_, 4)), ElementsAre(0x080, 0x080, 0x080, 0x201));
}

// In lockstep the marker must not overtake what its sender sent before, on whichever bus.
TEST_F(Bundle, ALockstepMarkerComesAfterAllThatWasSentBeforeIt) {
  for (int tick = 0; tick < 200; ++tick) {
    robot_->send(frames_of({0x181, 0x182, 0x183, 0x184, 0x185, 0x7F0}));
    std::vector<can::CanFrame> batch(6);
    ASSERT_EQ(receive_all(*controller_, batch), 6U);
    ASSERT_EQ(batch[5].identifier, 0x7F0);
  }
}

TEST_F(Bundle, ALegsBusThatIsDownDoesNotSilenceTheOther) {
  left_.down();
  EXPECT_EQ(controller_->send(frames_of({0x080, 0x202, 0x201})), 1U);
  EXPECT_THAT(seen(raw_right_, 2), ElementsAre(0x080, 0x201));
  EXPECT_THAT(identifiers(received(*robot_, 2)), ElementsAre(0x080, 0x201));
  EXPECT_FALSE(controller_->report().is_up);
  raw_right_.send_fd(0x181, 8);
  EXPECT_THAT(identifiers(received(*controller_, 1)), ElementsAre(0x181));
}

TEST_F(Bundle, AFloodOfOneBusDoesNotHideTheOther) {
  for (int i = 0; i < 1000; ++i) raw_right_.send_fd(0x181, 8);
  raw_left_.send_fd(0x182, 8);
  std::size_t at = 0;
  for (const can::CanFrame& frame : received(*controller_, 1001)) {
    if (frame.identifier == 0x182) break;
    ++at;
  }
  EXPECT_EQ(at, 1000U) << "it came after the flood, and is handed over after it";
  EXPECT_EQ(controller_->report().received, 1001U);
}

TEST_F(Bundle, AllocatesNothing) {
  if (!allocation_guard::is_available()) GTEST_SKIP() << "a sanitizer owns malloc";
  std::vector<can::CanFrame> frames(150);
  for (std::uint32_t i = 0; i < frames.size(); ++i) frames[i] = numbered_frame(i);
  std::vector<can::CanFrame> inbox(150);
  allocation_guard::arm();
  robot_->send(frames);
  const std::size_t count = receive_all(*controller_, inbox);
  EXPECT_EQ(allocation_guard::disarm().allocations, 0U);
  ASSERT_EQ(count, 150U);
  for (std::uint32_t i = 0; i < count; ++i) ASSERT_EQ(number_of(inbox[i]), i);
}

}  // namespace
}  // namespace surefoot::host
