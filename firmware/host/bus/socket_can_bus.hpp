#pragma once

#include <string>

#include "firmware/host/bus/file_descriptor.hpp"
#include "firmware/host/bus/socket_bus.hpp"

namespace surefoot::host {

/// CAN FD frames with bit rate switch on one SocketCAN interface.
///
/// Frames of another shape (classic, extended, remote, impossible length) are counted and dropped; a role's
/// kernel filters keep out all but its own identifiers, extended and remote frames included.
/// A link that goes down, or is deleted and made again, is counted and found again.
class SocketCanBus final : public SocketBus {
 public:
  /// @throws BusError  see `open_can_socket`
  SocketCanBus(std::string interface, BusRole role);

 protected:
  [[nodiscard]] int send_socket() const noexcept override { return socket_.get(); }
  [[nodiscard]] int receive_socket() const noexcept override { return socket_.get(); }
  [[nodiscard]] std::size_t encode(const can::CanFrame& frame, std::span<std::byte> datagram) noexcept override;
  [[nodiscard]] bool decode(const Received& received, BusReport& report, can::CanFrame& frame) noexcept override;
  [[nodiscard]] bool restore_link() noexcept override;

 private:
  std::string interface_;
  BusRole role_;
  FileDescriptor socket_;
};

}  // namespace surefoot::host
