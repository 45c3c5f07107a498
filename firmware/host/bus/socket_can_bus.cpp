#include "firmware/host/bus/socket_can_bus.hpp"

#include <linux/can.h>
#include <linux/can/error.h>

#include <cstring>
#include <utility>

#include "firmware/host/bus/can_interface.hpp"
#include "firmware/host/bus/frame_length.hpp"

namespace surefoot::host {

SocketCanBus::SocketCanBus(std::string interface, BusRole role)
    : SocketBus(CANFD_MTU), interface_(std::move(interface)), role_(role), socket_(open_can_socket(interface_, role)) {}

std::size_t SocketCanBus::encode(const can::CanFrame& frame, std::span<std::byte> datagram) noexcept {
  canfd_frame raw{};
  raw.can_id = frame.identifier;
  raw.len = frame.length;
  raw.flags = CANFD_BRS;
  std::memcpy(raw.data, frame.payload.data(), sizeof raw.data);
  std::memcpy(datagram.data(), &raw, sizeof raw);
  return sizeof raw;
}

bool SocketCanBus::decode(const Received& received, BusReport& report, can::CanFrame& frame) noexcept {
  canfd_frame raw{};  // a classic frame is its beginning
  if (received.bytes.size() <= sizeof raw) std::memcpy(&raw, received.bytes.data(), received.bytes.size());
  if ((raw.can_id & CAN_ERR_FLAG) != 0) {
    ++report.error_frames;
    if ((raw.can_id & CAN_ERR_BUSOFF) != 0) ++report.bus_off;
    return false;
  }
  if (received.bytes.size() != CANFD_MTU || received.is_truncated || raw.can_id > CAN_SFF_MASK ||
      !is_fd_length(raw.len)) {
    ++report.foreign_shape;
    return false;
  }
  frame = {.identifier = static_cast<std::uint16_t>(raw.can_id), .length = raw.len};
  std::memcpy(frame.payload.data(), raw.data, raw.len);
  return true;
}

bool SocketCanBus::restore_link() noexcept { return attach_again(socket_.get(), interface_, role_); }

}  // namespace surefoot::host
