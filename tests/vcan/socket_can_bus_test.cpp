#include "firmware/host/bus/socket_can_bus.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/can/error.h>

#include <ctime>
#include <random>

#include "firmware/host/allocation_guard.hpp"
#include "firmware/host/bus/heard_identifiers.hpp"
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

class SocketCan : public ::testing::Test {
 protected:
  Interface interface_{"sfbus0"};
  SocketCanBus bus_{"sfbus0", BusRole::kEverything};
  SocketCanBus other_{"sfbus0", BusRole::kEverything};
  RawSocket raw_{"sfbus0"};
};

std::vector<can::CanFrame> numbered_frames(std::uint32_t count) {
  std::vector<can::CanFrame> frames;
  for (std::uint32_t i = 0; i < count; ++i) frames.push_back(numbered_frame(i));
  return frames;
}

TEST_F(SocketCan, FramesOfEveryLengthReachTheOtherEndAndNeverTheSender) {
  std::mt19937 random(1);
  std::vector<can::CanFrame> frames;
  for (const std::size_t length : {0U, 1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U, 12U, 16U, 20U, 24U, 32U, 48U, 64U}) {
    std::vector<std::uint8_t> payload(length);
    for (std::uint8_t& byte : payload) byte = static_cast<std::uint8_t>(random());
    frames.push_back(frame_of(static_cast<std::uint16_t>(0x7FF - length), payload));
  }
  ASSERT_EQ(bus_.send(frames), frames.size());
  const auto got = received(other_, frames.size());
  ASSERT_EQ(got.size(), frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(got[i].identifier, frames[i].identifier);
    EXPECT_EQ(got[i].length, frames[i].length);
    EXPECT_EQ(got[i].payload, frames[i].payload);
  }
  EXPECT_TRUE(received(bus_, 0).empty());
  EXPECT_EQ(bus_.report().sent, frames.size());
  EXPECT_EQ(other_.report().received, frames.size());
}

TEST_F(SocketCan, SendsCanFdFramesWithBitRateSwitch) {
  bus_.send(std::vector{frame_of(0x181, {1, 2, 3})});
  const auto frames = raw_.read(1);
  ASSERT_EQ(frames.size(), 1U) << "not a CAN FD frame";
  EXPECT_EQ(frames[0].can_id, 0x181U);
  EXPECT_EQ(frames[0].len, 3);
  EXPECT_EQ(frames[0].flags & CANFD_BRS, CANFD_BRS);
}

TEST_F(SocketCan, MoreFramesThanABatchKeepTheirOrder) {
  ASSERT_EQ(bus_.send(numbered_frames(200)), 200U);
  const auto got = received(other_, 200);
  ASSERT_EQ(got.size(), 200U);
  for (std::uint32_t i = 0; i < 200; ++i) ASSERT_EQ(number_of(got[i]), i);
}

TEST_F(SocketCan, WhatDoesNotFitIntoTheCallersSpanWaits) {
  bus_.send(numbered_frames(5));
  std::vector<can::CanFrame> two(2);
  EXPECT_EQ(receive_all(other_, two), 2U);
  EXPECT_EQ(number_of(two[1]), 1U);
  EXPECT_EQ(received(other_, 3).size(), 3U);
}

TEST_F(SocketCan, ForeignShapesAreCountedAndDropped) {
  raw_.send_classic(0x181);
  raw_.send_classic(0x181 | CAN_RTR_FLAG);
  raw_.send_classic(0x181 | CAN_EFF_FLAG);
  raw_.send_fd(0x18000181 | CAN_EFF_FLAG, 8);
  raw_.send_fd(0x181, 9);
  raw_.send_fd(0x182, 8, 0);  // without bit rate switch, yet CAN FD
  EXPECT_THAT(identifiers(received(bus_, 1)), ElementsAre(0x182));
  EXPECT_EQ(bus_.report().foreign_shape, 5U);
  EXPECT_EQ(bus_.report().received, 1U);
}

TEST_F(SocketCan, ErrorFramesAreCountedAndBusOffBesides) {
  SocketCanBus controller{"sfbus0", BusRole::kController};
  raw_.send_classic(CAN_ERR_FLAG | CAN_ERR_CRTL);
  raw_.send_classic(CAN_ERR_FLAG | CAN_ERR_BUSOFF);
  raw_.send_fd(0x181, 8);
  EXPECT_EQ(received(controller, 1).size(), 1U);
  EXPECT_EQ(controller.report().error_frames, 2U);
  EXPECT_EQ(controller.report().bus_off, 1U);
  EXPECT_EQ(controller.report().foreign_shape, 0U);
}

class SocketCanRole : public SocketCan, public ::testing::WithParamInterface<BusRole> {};

// All 2048 identifiers in every shape: what is not the role's never leaves the kernel.
TEST_P(SocketCanRole, HearsItsIdentifiersAlone) {
  SocketCanBus bus{"sfbus0", GetParam()};
  std::vector<std::uint16_t> heard;
  for (std::uint16_t identifier = 0; identifier < 0x800; ++identifier) {
    raw_.send_fd(identifier, 8);
    raw_.send_classic(identifier | CAN_RTR_FLAG);
    raw_.send_fd(identifier | CAN_EFF_FLAG, 8);
    for (const std::uint16_t each : identifiers(received(bus, 0))) heard.push_back(each);
  }
  const auto promised = heard_identifiers(GetParam());
  for (const std::uint16_t each : identifiers(received(bus, promised.size() - heard.size()))) heard.push_back(each);
  EXPECT_THAT(heard, ::testing::UnorderedElementsAreArray(promised.begin(), promised.end()));
  EXPECT_EQ(bus.report().foreign_shape, 0U) << "extended and remote frames passed the kernel's filter";
}

INSTANTIATE_TEST_SUITE_P(Of, SocketCanRole, ::testing::Values(BusRole::kController, BusRole::kRobot));

TEST_F(SocketCan, TimeStampsAreTheKernelsOneForEachFrameAndNeverGoBack) {
  timespec before{};
  ::clock_gettime(CLOCK_REALTIME, &before);
  bus_.send(numbered_frames(150));
  ASSERT_TRUE(other_.wait_readable(from_now_ns(kLongNs)));
  std::vector<can::CanFrame> frames(200);
  const std::size_t count = other_.receive(frames);
  timespec after{};
  ::clock_gettime(CLOCK_REALTIME, &after);
  const auto times_ns = other_.receive_times_ns();
  ASSERT_EQ(times_ns.size(), count);
  ASSERT_GT(count, 0U);
  EXPECT_TRUE(std::ranges::is_sorted(times_ns));
  EXPECT_GE(times_ns.front(), std::int64_t{before.tv_sec} * 1'000'000'000 + before.tv_nsec);
  EXPECT_LE(times_ns.back(), std::int64_t{after.tv_sec} * 1'000'000'000 + after.tv_nsec);
  received(other_, 150 - count);
  EXPECT_EQ(other_.receive(frames), 0U);
  EXPECT_TRUE(other_.receive_times_ns().empty());
}

TEST_F(SocketCan, FramesThatTheKernelHadNoRoomForAreCounted) {
  constexpr std::uint32_t kSent = 50'000;
  for (std::uint32_t i = 0; i < kSent; ++i) ASSERT_EQ(bus_.send(std::vector{numbered_frame(i)}), 1U);
  const std::size_t count = received(other_, 500).size();
  EXPECT_LT(count, kSent) << "the queue was larger than the test thought";
  EXPECT_GT(count, 500U) << "SO_RCVBUF was left at its default";
  // The kernel says how many were lost with each frame that gets in afterwards.
  bus_.send(numbered_frames(3));
  const std::size_t more = received(other_, 3).size();
  EXPECT_GT(other_.report().queue_overflow, 0U);
  EXPECT_LE(other_.report().queue_overflow, kSent + 3 - count - more) << "more than there were: the total was added up";
}

TEST_F(SocketCan, AFullSendQueueRefusesIsCountedAndIsNoEnd) {
  if (!testing::ip("qdisc add dev sfbus0 root pfifo limit 0", "tc")) GTEST_SKIP() << "no tc here";
  EXPECT_EQ(bus_.send(numbered_frames(100)), 0U);
  EXPECT_EQ(bus_.report().refused_no_buffer, 100U);
  EXPECT_EQ(bus_.report().link_down, 0U);
  EXPECT_TRUE(bus_.report().is_up);
  ASSERT_TRUE(testing::ip("qdisc del dev sfbus0 root", "tc"));
  EXPECT_EQ(bus_.send(numbered_frames(1)), 1U);
  EXPECT_EQ(received(other_, 1).size(), 1U);
  EXPECT_EQ(bus_.report().sent, 1U);
}

TEST_F(SocketCan, ASlowBusTakesWhatItCanAndRefusesTheRest) {
  const std::string module = "/usr/lib/uml/modules/$(uname -r)/kernel/net/sched/sch_tbf.ko";
  if (!testing::ip("qdisc add dev sfbus0 root tbf rate 8kbit burst 720 limit 720", "tc") &&
      (!testing::ip(module, "insmod") ||
       !testing::ip("qdisc add dev sfbus0 root tbf rate 8kbit burst 720 limit 720", "tc"))) {
    GTEST_SKIP() << "this kernel has no token bucket (sch_tbf)";
  }
  const auto frames = numbered_frames(100);
  const std::size_t taken = bus_.send(frames);
  EXPECT_GT(taken, 0U);
  EXPECT_LT(taken, 100U);
  EXPECT_EQ(bus_.report().sent, taken);
  EXPECT_EQ(bus_.report().refused_no_buffer, 100U - taken);
  const auto got = received(other_, 1);
  for (std::size_t i = 0; i < got.size(); ++i) EXPECT_EQ(number_of(got[i]), i) << "not a beginning of what was sent";
}

TEST_F(SocketCan, WaitingEndsAtTheDeadlineOrAtOnceWhenItHasPassed) {
  const std::int64_t deadline_ns = from_now_ns(3'300'000);
  EXPECT_FALSE(bus_.wait_readable(deadline_ns));
  EXPECT_GE(from_now_ns(0), deadline_ns) << "woke too early";
  EXPECT_FALSE(bus_.wait_readable(from_now_ns(-1)));
  EXPECT_FALSE(bus_.wait_readable(0));
  raw_.send_fd(0x181, 8);
  EXPECT_TRUE(bus_.wait_readable(from_now_ns(kLongNs)));
  EXPECT_TRUE(bus_.wait_readable(0)) << "what is there is there, also after the deadline";
}

TEST_F(SocketCan, NothingAllocatesBetweenStartAndStop) {
  if (!allocation_guard::is_available()) GTEST_SKIP() << "a sanitizer owns malloc";
  const auto frames = numbered_frames(100);
  std::vector<can::CanFrame> inbox(100);
  raw_.send_classic(0x181);
  allocation_guard::arm();
  bus_.send(frames);
  const std::size_t got = receive_all(other_, inbox);
  other_.wait_readable(0);
  const auto counts = allocation_guard::disarm();
  EXPECT_EQ(got, 100U);
  EXPECT_EQ(counts.allocations, 0U);
  EXPECT_EQ(counts.frees, 0U);
}

}  // namespace
}  // namespace surefoot::host
