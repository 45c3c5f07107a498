#include "firmware/host/bus/udp_bus.hpp"

#include <arpa/inet.h>
#include <net/if.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include <cerrno>

#include "firmware/host/bus/bus_error.hpp"
#include "firmware/host/bus/heard_identifiers.hpp"
#include "firmware/host/bus/socket_setup.hpp"

namespace surefoot::host {
namespace {

constexpr const char* kLoopback = "lo";

sockaddr_in address_of(in_addr group, std::uint16_t port) noexcept {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr = group;
  address.sin_port = htons(port);
  return address;
}

[[noreturn]] void fail(const sockaddr_in& address, const char* what, const char* remedy) {
  const int error = errno;
  throw BusError(BusError::Cause::kMachineLacks,
                 std::string("udp:") + ::inet_ntoa(address.sin_addr) + ":" + std::to_string(ntohs(address.sin_port)) +
                     ": " + what + ": " + error_text(error),
                 remedy);
}

bool is_loopback_up(int socket) noexcept {
  ifreq request{};
  std::string_view(kLoopback).copy(request.ifr_name, IFNAMSIZ);
  return ::ioctl(socket, SIOCGIFFLAGS, &request) == 0 && (request.ifr_flags & IFF_UP) != 0;
}

FileDescriptor open_socket(const sockaddr_in& address) {
  FileDescriptor socket(::socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  if (socket.get() < 0) fail(address, "no UDP socket", "permit IPv4 sockets");
  return socket;
}

ip_mreqn membership(in_addr group) noexcept {
  return {.imr_multiaddr = group, .imr_address = {}, .imr_ifindex = static_cast<int>(::if_nametoindex(kLoopback))};
}

FileDescriptor open_sender(const sockaddr_in& address) {
  FileDescriptor socket = open_socket(address);
  const ip_mreqn loopback = membership({});
  const bool stays_here = ::setsockopt(socket.get(), IPPROTO_IP, IP_MULTICAST_IF, &loopback, sizeof loopback) == 0 &&
                          set_option(socket.get(), IPPROTO_IP, IP_MULTICAST_TTL, 0) &&
                          set_option(socket.get(), IPPROTO_IP, IP_MULTICAST_LOOP, 1);
  if (!stays_here || !is_loopback_up(socket.get()) ||
      ::connect(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    fail(address, "no multicast over loopback", "ip link set lo up");
  }
  return socket;
}

FileDescriptor open_receiver(const sockaddr_in& address) {
  FileDescriptor socket = open_socket(address);
  // python-can binds to the port too.
  if (!set_option(socket.get(), SOL_SOCKET, SO_REUSEADDR, 1) ||
      ::bind(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    fail(address, "the port is taken", "give another one, --bus udp:239.74.163.2:PORT");
  }
  const ip_mreqn group = membership(address.sin_addr);
  // Not what other programs of this machine joined on a real network.
  if (!set_option(socket.get(), IPPROTO_IP, IP_MULTICAST_ALL, 0) ||
      ::setsockopt(socket.get(), IPPROTO_IP, IP_ADD_MEMBERSHIP, &group, sizeof group) != 0) {
    fail(address, "cannot join the group on loopback", "ip link set lo up");
  }
  prepare_receiving(socket.get());
  return socket;
}

std::uint16_t port_of(const FileDescriptor& socket) noexcept {
  sockaddr_in own{};
  socklen_t size = sizeof own;
  ::getsockname(socket.get(), reinterpret_cast<sockaddr*>(&own), &size);
  return ntohs(own.sin_port);
}

}  // namespace

UdpBus::UdpBus(in_addr group, std::uint16_t port, BusRole role)
    : SocketBus(kMaxDatagramBytes),
      send_socket_(open_sender(address_of(group, port))),
      receive_socket_(open_receiver(address_of(group, port))),
      own_port_(port_of(send_socket_)) {
  for (const std::uint16_t identifier : heard_identifiers(role)) hears_.set(identifier);
  if (hears_.none()) hears_.set();
}

std::size_t UdpBus::encode(const can::CanFrame& frame, std::span<std::byte> datagram) noexcept {
  return encode_datagram(frame, datagram);
}

bool UdpBus::decode(const Received& received, BusReport& report, can::CanFrame& frame) noexcept {
  if (received.udp_source_port == own_port_) return false;
  const DatagramKind kind = received.is_truncated ? DatagramKind::kForeign : reader_.read(received.bytes, frame);
  if (kind == DatagramKind::kErrorFrame) ++report.error_frames;
  if (kind == DatagramKind::kForeign) ++report.foreign_shape;
  return kind == DatagramKind::kFrame && hears_.test(frame.identifier);
}

bool UdpBus::restore_link() noexcept { return is_loopback_up(send_socket_.get()); }

}  // namespace surefoot::host
