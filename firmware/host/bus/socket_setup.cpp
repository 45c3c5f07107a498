#include "firmware/host/bus/socket_setup.hpp"

#include <sys/socket.h>

#include <system_error>

namespace surefoot::host {
namespace {

constexpr int kReceiveBufferBytes = 4 << 20;  // the kernel doubles it: some 9000 frames of 64 bytes

}  // namespace

bool set_option(int socket, int level, int option, int value) noexcept {
  return ::setsockopt(socket, level, option, &value, sizeof value) == 0;
}

void prepare_receiving(int socket) noexcept {
  if (!set_option(socket, SOL_SOCKET, SO_RCVBUFFORCE, kReceiveBufferBytes)) {
    // Without CAP_NET_ADMIN no more than net.core.rmem_max.
    static_cast<void>(set_option(socket, SOL_SOCKET, SO_RCVBUF, kReceiveBufferBytes));
  }
  static_cast<void>(set_option(socket, SOL_SOCKET, SO_TIMESTAMPNS, 1));
  static_cast<void>(set_option(socket, SOL_SOCKET, SO_RXQ_OVFL, 1));
}

std::string error_text(int error) { return std::generic_category().message(error); }

}  // namespace surefoot::host
