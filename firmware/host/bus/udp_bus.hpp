#pragma once

#include <netinet/in.h>

#include <bitset>
#include <string>

#include "firmware/host/bus/file_descriptor.hpp"
#include "firmware/host/bus/socket_bus.hpp"
#include "firmware/host/bus/udp_datagram.hpp"

namespace surefoot::host {

/// CAN FD frames over UDP multicast, for machines whose kernel has no CAN: the wire format of python-can's
/// interface `udp_multicast`. Never leaves this machine: loopback only, time to live 0.
///
/// A Python client joins with
///   can.Bus(interface="udp_multicast", channel="239.74.163.2", port=43113, fd=True)
/// where the group is routed over loopback: `ip route add 239.74.163.2 dev lo`.
/// Own datagrams come back to the socket and are dropped: they wake `wait_readable`.
class UdpBus final : public SocketBus {
 public:
  static constexpr const char* kDefaultGroup = "239.74.163.2";  ///< of python-can
  static constexpr std::uint16_t kDefaultPort = 43113;          ///< of python-can

  /// @param group  IPv4 multicast address, 224.0.0.0 to 239.255.255.255
  /// @throws BusError  port taken, loopback down
  UdpBus(in_addr group, std::uint16_t port, BusRole role);

 protected:
  [[nodiscard]] int send_socket() const noexcept override { return send_socket_.get(); }
  [[nodiscard]] int receive_socket() const noexcept override { return receive_socket_.get(); }
  [[nodiscard]] std::size_t encode(const can::CanFrame& frame, std::span<std::byte> datagram) noexcept override;
  [[nodiscard]] bool decode(const Received& received, BusReport& report, can::CanFrame& frame) noexcept override;
  [[nodiscard]] bool restore_link() noexcept override;

 private:
  FileDescriptor send_socket_;
  FileDescriptor receive_socket_;
  std::uint16_t own_port_ = 0;  // of send_socket_: no other socket of this machine has it
  DatagramReader reader_;
  std::bitset<0x800> hears_;
};

}  // namespace surefoot::host
