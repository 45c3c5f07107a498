#pragma once

#include <netinet/in.h>

#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "firmware/host/bus/bus_error.hpp"
#include "firmware/host/bus/host_bus.hpp"

namespace surefoot::host {

struct SocketCanAddress {
  std::vector<std::string> interfaces;  ///< one or two, different
};

struct UdpAddress {
  in_addr group;       ///< 224.0.0.0 to 239.255.255.255
  std::uint16_t port;  ///< 1 to 65535
};

using BusAddress = std::variant<SocketCanAddress, UdpAddress>;

/// Reads the address of a bus; touches nothing of the machine.
/// - "socketcan:can0": CAN FD frames on one SocketCAN interface, see `SocketCanBus`;
/// - "socketcan:can0,can1": one bus a leg, see `BusBundle`;
/// - "udp:239.74.163.2:43113", or "udp" for just that: python-can's `udp_multicast`, see `UdpBus`.
///
/// @throws BusError  (kBadAddress) with what is wrong and what to write instead
[[nodiscard]] BusAddress parse_bus_address(const std::string& text);

/// Opens a bus by its address.
/// @throws BusError  with the fault of the text or of the machine, and its remedy
[[nodiscard]] std::unique_ptr<HostBus> open_bus(const std::string& address, BusRole role);

}  // namespace surefoot::host
