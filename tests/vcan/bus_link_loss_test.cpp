#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ctime>

#include "firmware/host/allocation_guard.hpp"
#include "firmware/host/bus/bus_error.hpp"
#include "firmware/host/bus/socket_can_bus.hpp"
#include "tests/unit/firmware_host/frames.hpp"
#include "tests/unit/firmware_host/received.hpp"
#include "tests/vcan/interface.hpp"

namespace surefoot::host {
namespace {

using testing::from_now_ns;
using ::testing::HasSubstr;
using testing::Interface;
using testing::numbered_frame;
using testing::received;

constexpr std::int64_t kMs = 1'000'000;
const std::vector<can::CanFrame> kOneFrame{numbered_frame(7)};

std::int64_t processor_time_ns() {
  timespec used{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
  return std::int64_t{used.tv_sec} * 1'000'000'000 + used.tv_nsec;
}

class LinkLoss : public ::testing::Test {
 protected:
  Interface interface_{"sfbus1"};
  SocketCanBus bus_{"sfbus1", BusRole::kController};
  SocketCanBus other_{"sfbus1", BusRole::kController};

  /// Both ways. Waits until the link has been found again, which is looked for every 100 ms.
  void expect_it_works_again() {
    const std::int64_t give_up_ns = from_now_ns(20'000 * kMs);
    bool is_heard = false;
    while (!is_heard && from_now_ns(0) < give_up_ns) {
      bus_.send(kOneFrame);
      is_heard = other_.wait_readable(from_now_ns(20 * kMs)) && !received(other_, 1).empty();
    }
    EXPECT_TRUE(is_heard);
    EXPECT_EQ(other_.send(kOneFrame), 1U);
    EXPECT_EQ(received(bus_, 1).size(), 1U);
    EXPECT_TRUE(bus_.report().is_up);
    EXPECT_TRUE(other_.report().is_up);
  }
};

TEST_F(LinkLoss, IsCountedAndTheLinkWorksOnceItIsUp) {
  interface_.down();
  EXPECT_EQ(bus_.send(kOneFrame), 0U);
  EXPECT_TRUE(received(other_, 0).empty());
  for (const SocketCanBus* each : {&bus_, &other_}) {
    EXPECT_FALSE(each->report().is_up);
    EXPECT_GE(each->report().link_down, 1U);
    EXPECT_EQ(each->report().refused_no_buffer, 0U);
  }
  interface_.up();
  expect_it_works_again();
}

TEST_F(LinkLoss, ThatNobodySawIsNoObstacle) {
  interface_.down();
  interface_.up();
  EXPECT_EQ(bus_.send(kOneFrame), 1U) << "the old error of the socket stood in the way of a frame";
  EXPECT_EQ(received(other_, 1).size(), 1U);
}

TEST_F(LinkLoss, FramesThatHadComeBeforeAreStillHandedOver) {
  bus_.send(kOneFrame);
  ASSERT_TRUE(other_.wait_readable(from_now_ns(testing::kLongNs)));
  interface_.down();
  EXPECT_EQ(received(other_, 1).size(), 1U);
}

TEST_F(LinkLoss, AnInterfaceThatIsDeletedAndMadeAgainIsFound) {
  interface_.remove();
  EXPECT_EQ(bus_.send(kOneFrame), 0U);
  EXPECT_TRUE(received(other_, 0).empty());
  EXPECT_FALSE(bus_.report().is_up);
  EXPECT_FALSE(other_.report().is_up);
  interface_.create();
  expect_it_works_again();
  const testing::RawSocket raw("sfbus1");
  raw.send_fd(0x3FF, 8);
  raw.send_fd(0x182, 8);
  EXPECT_THAT(testing::identifiers(received(bus_, 1)), ::testing::ElementsAre(0x182)) << "the filters were forgotten";
}

TEST_F(LinkLoss, AnInterfaceThatComesAgainWithoutCanFdIsDownUntilItHasIt) {
  interface_.remove();
  received(other_, 0);
  ASSERT_TRUE(testing::ip("link add sfbus1 type vcan") && testing::ip("link set sfbus1 mtu 16 up"));
  EXPECT_FALSE(other_.wait_readable(from_now_ns(250 * kMs)));
  EXPECT_FALSE(other_.report().is_up);
  EXPECT_EQ(bus_.send(kOneFrame), 0U);
  interface_.down();
  ASSERT_TRUE(testing::ip("link set sfbus1 mtu 72 up"));
  expect_it_works_again();
}

// Processor time, not the wall's: a loop that spins uses all of it.
TEST_F(LinkLoss, WaitingSleepsToTheDeadlineAlthoughTheLinkIsDownOrGone) {
  for (const bool is_gone : {false, true}) {
    is_gone ? interface_.remove() : interface_.down();
    const std::int64_t deadline_ns = from_now_ns(400 * kMs);
    const std::int64_t used_ns = processor_time_ns();
    EXPECT_FALSE(bus_.wait_readable(deadline_ns));
    EXPECT_GE(from_now_ns(0), deadline_ns);
    EXPECT_LT(processor_time_ns() - used_ns, 200 * kMs) << "it spins";
    EXPECT_FALSE(bus_.report().is_up) << "waiting alone tells";
    EXPECT_LE(bus_.report().link_down, is_gone ? 3U : 1U);
  }
}

TEST_F(LinkLoss, AndReturnAllocateNothing) {
  if (!allocation_guard::is_available()) GTEST_SKIP() << "a sanitizer owns malloc";
  interface_.remove();
  std::vector<can::CanFrame> inbox(10);
  allocation_guard::arm();
  bus_.send(kOneFrame);
  other_.receive(inbox);
  other_.wait_readable(from_now_ns(150 * kMs));
  auto counts = allocation_guard::disarm();
  EXPECT_EQ(counts.allocations, 0U);
  interface_.create();
  allocation_guard::arm();
  other_.wait_readable(from_now_ns(150 * kMs));
  bus_.send(kOneFrame);
  counts = allocation_guard::disarm();
  EXPECT_EQ(counts.allocations, 0U);
  EXPECT_TRUE(other_.report().is_up);
}

struct Refusal {
  const char* interface;
  const char* said;
  const char* remedy;
};

void expect_refused(const Refusal& expected) {
  try {
    SocketCanBus(expected.interface, BusRole::kRobot);
    FAIL() << expected.interface << " was taken";
  } catch (const BusError& error) {
    EXPECT_THAT(error.what(), HasSubstr(std::string(expected.interface) + ": " + expected.said));
    EXPECT_THAT(error.what(), HasSubstr(std::string("\n  remedy: ") + expected.remedy));
  }
}

TEST(SocketCanOpen, RefusesWhatIsNoCanFdInterfaceWithTheCommandThatMendsIt) {
  const Interface classic("sfbus2", CAN_MTU);
  Interface down("sfbus3");
  down.down();
  expect_refused({"vcan99", "no such interface", "ip link add vcan99 type vcan && ip link set vcan99 mtu 72 up"});
  expect_refused({"can99", "no such interface", "plug it in"});
  expect_refused({"lo", "is not a CAN interface", "name one of those"});
  expect_refused({"sfbus2", "carries classic CAN only", "ip link set sfbus2 down && ip link set sfbus2 up type can"});
  expect_refused({"sfbus3", "is down", "ip link set sfbus3 up"});
}

}  // namespace
}  // namespace surefoot::host
