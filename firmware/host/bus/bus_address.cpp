#include "firmware/host/bus/bus_address.hpp"

#include <arpa/inet.h>
#include <net/if.h>

#include <algorithm>
#include <charconv>
#include <string_view>

#include "firmware/host/bus/bus_bundle.hpp"
#include "firmware/host/bus/socket_can_bus.hpp"
#include "firmware/host/bus/udp_bus.hpp"

namespace surefoot::host {
namespace {

constexpr const char* kForms = "write socketcan:can0, socketcan:can0,can1 (one bus a leg) or udp[:GROUP:PORT]";

[[noreturn]] void refuse(const std::string& text, const std::string& fault) {
  throw BusError(BusError::Cause::kBadAddress, "bus address \"" + text + "\": " + fault, kForms);
}

/// What the kernel takes for a name (dev_valid_name in net/core/dev.c), of printable ASCII.
bool is_interface_name(std::string_view name) {
  const auto is_allowed = [](char letter) { return letter > ' ' && letter < 0x7F && letter != '/' && letter != ':'; };
  return !name.empty() && name.size() < IFNAMSIZ && name != "." && name != ".." &&
         std::ranges::all_of(name, is_allowed);
}

SocketCanAddress parse_interfaces(const std::string& text, std::string_view list) {
  SocketCanAddress address;
  while (true) {
    const std::size_t comma = list.find(',');
    const std::string name(list.substr(0, comma));
    if (!is_interface_name(name)) refuse(text, "\"" + name + "\" is no name of an interface (1 to 15 letters)");
    if (std::ranges::count(address.interfaces, name) > 0) refuse(text, name + " is named twice");
    address.interfaces.push_back(name);
    if (comma == std::string_view::npos) break;
    list.remove_prefix(comma + 1);
  }
  if (address.interfaces.size() > SocketBus::kMaxBuses) refuse(text, "more than two interfaces");
  return address;
}

UdpAddress parse_group(const std::string& text, std::string_view group_and_port) {
  const std::size_t colon = group_and_port.find(':');
  const std::string group(group_and_port.substr(0, colon));
  UdpAddress address{.group = {}, .port = UdpBus::kDefaultPort};
  if (::inet_pton(AF_INET, group.c_str(), &address.group) != 1 || !IN_MULTICAST(ntohl(address.group.s_addr))) {
    refuse(text, "\"" + group + "\" is no IPv4 multicast group (224.0.0.0 to 239.255.255.255)");
  }
  if (colon == std::string_view::npos) return address;
  const std::string_view port = group_and_port.substr(colon + 1);
  const auto [end, error] = std::from_chars(port.data(), port.data() + port.size(), address.port);
  if (error != std::errc() || end != port.data() + port.size() || address.port == 0) {
    refuse(text, "\"" + std::string(port) + "\" is no port (1 to 65535)");
  }
  return address;
}

std::unique_ptr<HostBus> open(const SocketCanAddress& address, BusRole role) {
  auto first = std::make_unique<SocketCanBus>(address.interfaces[0], role);
  if (address.interfaces.size() == 1) return first;
  auto second = std::make_unique<SocketCanBus>(address.interfaces[1], role);
  return std::make_unique<BusBundle>(BusBundle::Members{std::move(first), std::move(second)});
}

std::unique_ptr<HostBus> open(const UdpAddress& address, BusRole role) {
  return std::make_unique<UdpBus>(address.group, address.port, role);
}

}  // namespace

BusAddress parse_bus_address(const std::string& text) {
  const std::string_view all = text;
  const std::size_t colon = all.find(':');
  const std::string_view scheme = all.substr(0, colon);
  const std::string_view rest = colon == std::string_view::npos ? std::string_view() : all.substr(colon + 1);
  if (scheme == "socketcan") return parse_interfaces(text, rest);
  if (all == "udp") return parse_group(text, UdpBus::kDefaultGroup);
  if (scheme == "udp") return parse_group(text, rest);
  refuse(text, "unknown kind of bus \"" + std::string(scheme) + "\"");
}

std::unique_ptr<HostBus> open_bus(const std::string& address, BusRole role) {
  return std::visit([role](const auto& parsed) { return open(parsed, role); }, parse_bus_address(address));
}

}  // namespace surefoot::host
