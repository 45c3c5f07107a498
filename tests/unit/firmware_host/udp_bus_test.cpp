#include "firmware/host/bus/udp_bus.hpp"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>

#include "firmware/host/allocation_guard.hpp"
#include "firmware/host/bus/bus_address.hpp"
#include "firmware/host/bus/bus_error.hpp"
#include "tests/unit/firmware_host/frames.hpp"
#include "tests/unit/firmware_host/own_network.hpp"
#include "tests/unit/firmware_host/received.hpp"

namespace surefoot::host {
namespace {

using ::testing::ElementsAre;
using testing::frame_of;
using ::testing::HasSubstr;
using testing::identifiers;
using testing::numbered_frame;
using testing::OwnNetwork;
using testing::receive_all;
using testing::received;

std::unique_ptr<HostBus> open_everything(const char* address = "udp") {
  return open_bus(address, BusRole::kEverything);
}

/// Datagrams that no bus would send; and what a bus sends, as it arrives.
class PlainSocket {
 public:
  PlainSocket() : socket_(::socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK, 0)) {
    group_.sin_family = AF_INET;
    group_.sin_port = htons(UdpBus::kDefaultPort);
    ::inet_pton(AF_INET, UdpBus::kDefaultGroup, &group_.sin_addr);
    in_addr loopback{.s_addr = htonl(INADDR_LOOPBACK)};
    EXPECT_EQ(::setsockopt(socket_, IPPROTO_IP, IP_MULTICAST_IF, &loopback, sizeof loopback), 0);
  }
  ~PlainSocket() { ::close(socket_); }
  PlainSocket(const PlainSocket&) = delete;
  PlainSocket& operator=(const PlainSocket&) = delete;

  void send(std::string_view bytes) const {
    EXPECT_EQ(
        ::sendto(socket_, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr*>(&group_), sizeof group_),
        static_cast<ssize_t>(bytes.size()));
  }
  /// @return the time to live of the next datagram, -1 if there is none
  [[nodiscard]] int received_time_to_live() const {
    std::array<char, 1024> bytes;
    alignas(cmsghdr) std::array<char, 64> control;
    iovec part{.iov_base = bytes.data(), .iov_len = bytes.size()};
    msghdr message{};
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    message.msg_control = control.data();
    message.msg_controllen = control.size();
    if (::recvmsg(socket_, &message, 0) < 0) return -1;
    int time_to_live = -1;
    std::memcpy(&time_to_live, CMSG_DATA(CMSG_FIRSTHDR(&message)), sizeof time_to_live);
    return time_to_live;
  }
  void join() const {
    const int on = 1;
    EXPECT_EQ(::setsockopt(socket_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on), 0);
    EXPECT_EQ(::setsockopt(socket_, IPPROTO_IP, IP_RECVTTL, &on, sizeof on), 0);
    EXPECT_EQ(::bind(socket_, reinterpret_cast<const sockaddr*>(&group_), sizeof group_), 0);
    const ip_mreq membership{.imr_multiaddr = group_.sin_addr, .imr_interface = {htonl(INADDR_LOOPBACK)}};
    EXPECT_EQ(::setsockopt(socket_, IPPROTO_IP, IP_ADD_MEMBERSHIP, &membership, sizeof membership), 0);
  }

 private:
  int socket_;
  sockaddr_in group_{};
};

class Udp : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!network_.is_ours()) GTEST_SKIP() << "a network of its own takes CAP_SYS_ADMIN here";
  }
  OwnNetwork network_;  // with a loopback, without a route: no more than the bus needs
};

TEST_F(Udp, FramesReachTheOtherEndAndNeverTheSender) {
  const auto one = open_everything();
  const auto other = open_everything();
  std::vector<can::CanFrame> frames;
  for (std::uint16_t i = 0; i < 150; ++i) {
    frames.push_back(frame_of(i, std::vector<std::uint8_t>(48, static_cast<std::uint8_t>(i))));
  }
  ASSERT_EQ(one->send(frames), frames.size());
  const auto got = received(*other, frames.size());
  ASSERT_EQ(got.size(), frames.size());
  for (std::size_t i = 0; i < got.size(); ++i) {
    ASSERT_EQ(got[i].identifier, i);
    ASSERT_EQ(got[i].length, 48);
    ASSERT_EQ(got[i].payload, frames[i].payload);
  }
  EXPECT_TRUE(received(*one, 0).empty());
  EXPECT_EQ(one->report().sent, 150U);
  EXPECT_EQ(one->report().foreign_shape, 0U);
  EXPECT_EQ(other->report().received, 150U);
}

TEST_F(Udp, HearsWhatItsRoleHears) {
  const auto robot = open_bus("udp", BusRole::kRobot);
  const auto controller = open_bus("udp", BusRole::kController);
  const auto sender = open_everything();
  for (const std::uint16_t identifier : std::array<std::uint16_t, 5>{0x080, 0x181, 0x201, 0x3FF, 0x705})
    sender->send(std::vector{frame_of(identifier, {})});
  EXPECT_THAT(identifiers(received(*robot, 2)), ElementsAre(0x080, 0x201));
  EXPECT_THAT(identifiers(received(*controller, 4)), ElementsAre(0x080, 0x181, 0x201, 0x705));
  EXPECT_EQ(robot->report().foreign_shape, 0U);
}

TEST_F(Udp, ReceiveTimesAreTheKernels) {
  const auto one = open_everything();
  const auto other = open_everything();
  timespec before{};
  ::clock_gettime(CLOCK_REALTIME, &before);
  one->send(std::vector{numbered_frame(1), numbered_frame(2)});
  ASSERT_EQ(one->report().sent, 2U);
  std::vector<can::CanFrame> frames(1);
  ASSERT_EQ(receive_all(*other, frames), 1U);
  const std::int64_t first_ns = other->receive_times_ns()[0];
  ASSERT_EQ(receive_all(*other, frames), 1U);
  EXPECT_GE(first_ns, std::int64_t{before.tv_sec} * 1'000'000'000 + before.tv_nsec);
  EXPECT_LE(first_ns, other->receive_times_ns()[0]);
}

TEST_F(Udp, GarbageIsCountedAndDropped) {
  const auto bus = open_everything();
  const auto other = open_everything();
  const PlainSocket stranger;
  stranger.send("");
  stranger.send("\x8B");
  stranger.send(std::string(2000, '\x91'));
  other->send(std::vector{numbered_frame(1)});
  EXPECT_EQ(received(*bus, 1).size(), 1U);
  EXPECT_EQ(bus->report().foreign_shape, 3U);
}

TEST_F(Udp, GroupsAndPortsAreBusesOfTheirOwn) {
  const auto here = open_everything("udp:239.74.163.2:43113");
  const auto other_group = open_everything("udp:239.74.163.3:43113");
  const auto other_port = open_everything("udp:239.74.163.2:43114");
  open_everything("udp")->send(std::vector{numbered_frame(1)});
  EXPECT_EQ(received(*here, 1).size(), 1U);
  EXPECT_TRUE(received(*other_group, 0).empty());
  EXPECT_TRUE(received(*other_port, 0).empty());
}

TEST_F(Udp, LeavesTheMachineNever) {
  const auto bus = open_everything();
  const PlainSocket listener;
  listener.join();
  const auto other = open_everything();
  bus->send(std::vector{numbered_frame(1)});
  ASSERT_EQ(received(*other, 1).size(), 1U);
  EXPECT_EQ(listener.received_time_to_live(), 0);
}

TEST_F(Udp, LossOfTheLoopbackIsCountedAndNoEnd) {
  const auto bus = open_everything();
  const auto other = open_everything();
  network_.set_loopback_up(false);
  EXPECT_EQ(bus->send(std::vector{numbered_frame(1)}), 0U);
  EXPECT_GE(bus->report().link_down, 1U);
  EXPECT_FALSE(bus->report().is_up);
  network_.set_loopback_up(true);
  EXPECT_EQ(bus->send(std::vector{numbered_frame(2)}), 1U);
  EXPECT_TRUE(bus->report().is_up);
  EXPECT_EQ(received(*other, 1).size(), 1U);
}

TEST_F(Udp, WithoutALoopbackItIsRefusedWithTheCommandThatMendsIt) {
  network_.set_loopback_up(false);
  try {
    open_everything();
    FAIL() << "opened";
  } catch (const BusError& error) {
    EXPECT_EQ(error.cause(), BusError::Cause::kMachineLacks);
    EXPECT_THAT(error.what(), HasSubstr("udp:239.74.163.2:43113: no multicast over loopback: "));
    EXPECT_THAT(error.what(), HasSubstr("\n  remedy: ip link set lo up"));
  }
}

TEST_F(Udp, NothingAllocatesBetweenStartAndStop) {
  if (!allocation_guard::is_available()) GTEST_SKIP() << "a sanitizer owns malloc";
  const auto bus = open_everything();
  const auto other = open_everything();
  PlainSocket().send("garbage");
  const std::vector<can::CanFrame> frames(100, numbered_frame(1));
  std::vector<can::CanFrame> inbox(100);
  allocation_guard::arm();
  bus->send(frames);
  const std::size_t count = receive_all(*other, inbox);
  EXPECT_EQ(allocation_guard::disarm().allocations, 0U);
  EXPECT_EQ(count, 100U);
}

}  // namespace
}  // namespace surefoot::host
