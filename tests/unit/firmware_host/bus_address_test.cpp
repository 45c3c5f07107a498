#include "firmware/host/bus/bus_address.hpp"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "firmware/host/bus/heard_identifiers.hpp"

namespace surefoot::host {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string group_of(const UdpAddress& address) { return ::inet_ntoa(address.group); }

TEST(BusAddress, NamesOneInterfaceOrOneForEachLeg) {
  EXPECT_THAT(std::get<SocketCanAddress>(parse_bus_address("socketcan:can0")).interfaces, ElementsAre("can0"));
  EXPECT_THAT(std::get<SocketCanAddress>(parse_bus_address("socketcan:vcan1,vcan0")).interfaces,
              ElementsAre("vcan1", "vcan0"));
  // net/if.h: 15 letters and a zero.
  EXPECT_THAT(std::get<SocketCanAddress>(parse_bus_address("socketcan:fifteen-letters")).interfaces,
              ElementsAre("fifteen-letters"));
}

// python-can 4.6, UdpMulticastBus: DEFAULT_GROUP_IPv4 and the default of `port`.
TEST(BusAddress, UdpAloneIsPythonCansDefault) {
  const auto address = std::get<UdpAddress>(parse_bus_address("udp"));
  EXPECT_EQ(group_of(address), "239.74.163.2");
  EXPECT_EQ(address.port, 43113);
}

TEST(BusAddress, TakesAnyIpv4MulticastGroupAndPort) {
  EXPECT_EQ(group_of(std::get<UdpAddress>(parse_bus_address("udp:224.0.0.0:1"))), "224.0.0.0");
  EXPECT_EQ(group_of(std::get<UdpAddress>(parse_bus_address("udp:239.255.255.255:65535"))), "239.255.255.255");
  EXPECT_EQ(std::get<UdpAddress>(parse_bus_address("udp:239.255.255.255:65535")).port, 65535);
  EXPECT_EQ(std::get<UdpAddress>(parse_bus_address("udp:239.1.2.3")).port, 43113);
}

struct BadAddress {
  const char* text;
  const char* said;
};

void PrintTo(const BadAddress& address, std::ostream* out) { *out << '"' << address.text << '"'; }

class BadBusAddress : public ::testing::TestWithParam<BadAddress> {};

TEST_P(BadBusAddress, IsRefusedWithItsFaultAndTheFormsThatAre) {
  try {
    static_cast<void>(open_bus(GetParam().text, BusRole::kEverything));
    FAIL() << "taken for an address";
  } catch (const BusError& error) {
    EXPECT_EQ(error.cause(), BusError::Cause::kBadAddress);
    EXPECT_THAT(error.what(), HasSubstr(std::string("\"") + GetParam().text + "\": "));
    EXPECT_THAT(error.what(), HasSubstr(GetParam().said));
    EXPECT_THAT(error.what(), HasSubstr("\n  remedy: write socketcan:can0, "));
  }
}

INSTANTIATE_TEST_SUITE_P(All, BadBusAddress,
                         ::testing::Values(BadAddress{"", "unknown kind of bus \"\""},
                                           BadAddress{"can0", "unknown kind of bus \"can0\""},
                                           BadAddress{"UDP", "unknown kind of bus \"UDP\""},
                                           BadAddress{"slcan:/dev/ttyUSB0", "unknown kind of bus \"slcan\""},
                                           BadAddress{"socketcan", "\"\" is no name of an interface"},
                                           BadAddress{"socketcan:", "\"\" is no name of an interface"},
                                           BadAddress{"socketcan:can0,", "\"\" is no name of an interface"},
                                           BadAddress{"socketcan:,can0", "\"\" is no name of an interface"},
                                           BadAddress{"socketcan:can0, can1", "\" can1\" is no name of an interface"},
                                           BadAddress{"socketcan:sixteen-letters-", "is no name of an interface"},
                                           BadAddress{"socketcan:../can0", "is no name of an interface"},
                                           BadAddress{"socketcan:can0,can0", "can0 is named twice"},
                                           BadAddress{"socketcan:a,b,c", "more than two interfaces"},
                                           BadAddress{"udp:", "\"\" is no IPv4 multicast group"},
                                           BadAddress{"udp:223.255.255.255:1", "is no IPv4 multicast group"},
                                           BadAddress{"udp:240.0.0.0:1", "is no IPv4 multicast group"},
                                           BadAddress{"udp:127.0.0.1:1", "is no IPv4 multicast group"},
                                           BadAddress{"udp:ff15::1", "is no IPv4 multicast group"},
                                           BadAddress{"udp:239.1.2.3:", "\"\" is no port"},
                                           BadAddress{"udp:239.1.2.3:0", "\"0\" is no port"},
                                           BadAddress{"udp:239.1.2.3:65536", "\"65536\" is no port"},
                                           BadAddress{"udp:239.1.2.3:-1", "\"-1\" is no port"},
                                           BadAddress{"udp:239.1.2.3:1:2", "\"1:2\" is no port"},
                                           BadAddress{"udp:239.1.2.3:1 ", "\"1 \" is no port"}));

// Node by node from surefoot.dbc, not from the formulas of identifiers.hpp.
TEST(HeardIdentifiers, ControllerHearsTheNodesAndWhatASecondControllerWouldSend) {
  EXPECT_THAT(heard_identifiers(BusRole::kController),
              ::testing::UnorderedElementsAre(0x181, 0x182, 0x183, 0x184, 0x185,         // states
                                              0x281, 0x282, 0x283, 0x284,                // inertial sensors
                                              0x081, 0x082, 0x083, 0x084, 0x085,         // emergencies
                                              0x701, 0x702, 0x703, 0x704, 0x705,         // heartbeats
                                              0x080, 0x201, 0x202, 0x301, 0x302, 0x77F,  // a second controller's
                                              0x7F0));                                   // lockstep
}

TEST(HeardIdentifiers, RobotHearsTheControllerAlone) {
  EXPECT_THAT(heard_identifiers(BusRole::kRobot),
              ::testing::UnorderedElementsAre(0x080, 0x201, 0x202, 0x301, 0x302, 0x77F));
}

TEST(HeardIdentifiers, EverythingHasNoFilter) { EXPECT_TRUE(heard_identifiers(BusRole::kEverything).empty()); }

}  // namespace
}  // namespace surefoot::host
