#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tools/doctor/multicast_checks.hpp"

namespace surefoot::doctor {
namespace {

using ::testing::HasSubstr;

constexpr std::uint32_t kLcmGroup = 0xEFFF4C43;  // 239.255.76.67

// As Linux 6 prints it: the four bytes of an address, read as a number of this (little-endian) machine.
const std::string kHead = "Iface\tDestination\tGateway \tFlags\tRefCnt\tUse\tMetric\tMask\t\tMTU\tWindow\tIRTT   \n";
const std::string kDefaultOverEth0 = "eth0\t00000000\t010200C0\t0003\t0\t0\t0\t00000000\t0\t0\t0      \n";
const std::string kLocalNet = "eth0\t000200C0\t00000000\t0001\t0\t0\t0\t00FFFFFF\t0\t0\t0      \n";
const std::string kMulticastOverLo = "lo\t000000E0\t00000000\t0001\t0\t0\t0\t000000F0\t0\t0\t0      \n";

TEST(DoctorRoutes, WithoutARouteThereIsNoInterface) {
  EXPECT_EQ(interface_towards("", kLcmGroup), "");
  EXPECT_EQ(interface_towards(kHead, kLcmGroup), "");
  EXPECT_EQ(interface_towards(kHead + kLocalNet, kLcmGroup), "");
}

TEST(DoctorRoutes, TheDefaultRouteTakesMulticastToo) {
  EXPECT_EQ(interface_towards(kHead + kDefaultOverEth0 + kLocalNet, kLcmGroup), "eth0");
}

// Masks compared as the table prints them would let 000000F0 lose against 00FFFFFF.
TEST(DoctorRoutes, TheLongestPrefixThatFitsWinsInWhateverOrder) {
  EXPECT_EQ(interface_towards(kHead + kDefaultOverEth0 + kLocalNet + kMulticastOverLo, kLcmGroup), "lo");
  EXPECT_EQ(interface_towards(kHead + kMulticastOverLo + kLocalNet + kDefaultOverEth0, kLcmGroup), "lo");
  EXPECT_EQ(interface_towards(kHead + kMulticastOverLo + kDefaultOverEth0, 0xC0000202), "eth0");  // 192.0.2.2
}

TEST(DoctorRoutes, OfTwoEqualPrefixesTheLowerMetricWins) {
  const std::string wlan = "wlan0\t00000000\t010200C0\t0003\t0\t0\t600\t00000000\t0\t0\t0      \n";
  const std::string wire = "eth1\t00000000\t010200C0\t0003\t0\t0\t100\t00000000\t0\t0\t0      \n";
  EXPECT_EQ(interface_towards(kHead + wlan + wire, kLcmGroup), "eth1");
  EXPECT_EQ(interface_towards(kHead + wire + wlan, kLcmGroup), "eth1");
}

TEST(DoctorRoutes, ARouteThatIsDownOrRejectsLeadsNowhere) {
  const std::string down = "eth0\t00000000\t010200C0\t0002\t0\t0\t0\t00000000\t0\t0\t0      \n";
  EXPECT_EQ(interface_towards(kHead + down, kLcmGroup), "");
  const std::string rejects = "*\t000000E0\t00000000\t0201\t0\t0\t0\t000000F0\t0\t0\t0      \n";
  EXPECT_EQ(interface_towards(kHead + kDefaultOverEth0 + rejects, kLcmGroup), "");
}

TEST(DoctorRoutes, GarbageIsNoRoute) { EXPECT_EQ(interface_towards("eth0\tnumber\nlo\n\n\t\t\n", kLcmGroup), ""); }

TEST(DoctorMulticast, IsFineOverLoAloneAndMendedByTheTwoCommandsOtherwise) {
  EXPECT_EQ(judge_multicast_route("lo", true).status, Status::kOk);
  EXPECT_EQ(judge_multicast_route("lo", false).status, Status::kWarning);
  EXPECT_EQ(judge_multicast_route("eth0", true).status, Status::kWarning);
  EXPECT_EQ(judge_multicast_route("", true).status, Status::kMissing);
  EXPECT_THAT(judge_multicast_route("", true).remedy, HasSubstr("ip route add 224.0.0.0/4 dev lo"));
  EXPECT_THAT(judge_multicast_route("", true).remedy, HasSubstr("ip link set lo up multicast on"));
}

TEST(DoctorSelfTests, ThatFailSayWhatTheirLibrarySaidFirst) {
  EXPECT_EQ(judge_lcm({0, "chatter"}).status, Status::kOk);
  EXPECT_THAT(judge_lcm({1, "connect: Network is unreachable\nmore\nof it"}).detail,
              ::testing::EndsWith("not received: connect: Network is unreachable"));
  EXPECT_THAT(judge_lcm({142, ""}).detail, ::testing::EndsWith("not received"));
  EXPECT_EQ(judge_udp_bus({0, ""}).status, Status::kOk);
  const Finding failed = judge_udp_bus({1, "udp: no multicast over loopback\n  remedy: ip link set lo up"});
  EXPECT_THAT(failed.detail, ::testing::EndsWith("udp: no multicast over loopback"));
  EXPECT_THAT(failed.remedy, HasSubstr("ip link set lo up"));
}

}  // namespace
}  // namespace surefoot::doctor
