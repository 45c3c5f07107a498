#include "firmware/host/bus/can_interface.hpp"

#include <linux/can.h>
#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <net/if_arp.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>

#include "firmware/host/bus/bus_error.hpp"
#include "firmware/host/bus/heard_identifiers.hpp"
#include "firmware/host/bus/socket_setup.hpp"

namespace surefoot::host {
namespace {

using enum BusError::Cause;

/// The request of one of the SIOCGIF... calls. @return false and errno where the interface is missing
bool ask(int socket, unsigned long what, const std::string& interface, ifreq& answer) noexcept {
  answer = {};
  interface.copy(answer.ifr_name, IFNAMSIZ - 1);
  return ::ioctl(socket, what, &answer) == 0;
}

bool is_up(int socket, const std::string& interface) noexcept {
  ifreq answer;
  return ask(socket, SIOCGIFFLAGS, interface, answer) && (answer.ifr_flags & IFF_UP) != 0;
}

bool carries_fd(int socket, const std::string& interface) noexcept {
  ifreq answer;
  return ask(socket, SIOCGIFMTU, interface, answer) && answer.ifr_mtu >= static_cast<int>(CANFD_MTU);
}

bool bind_to(int socket, int interface_index) noexcept {
  sockaddr_can address{};
  address.can_family = AF_CAN;
  address.can_ifindex = interface_index;
  return ::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
}

/// vcan is made with one line, a controller needs its bit rates.
std::string remedy_to_bring_up(const std::string& interface) {
  if (interface.starts_with("vcan")) return "ip link set " + interface + " mtu 72 up";
  return "ip link set " + interface + " up type can bitrate 1000000 dbitrate 5000000 fd on";
}

void check_interface(int socket, const std::string& interface) {
  ifreq answer;
  if (!ask(socket, SIOCGIFINDEX, interface, answer)) {
    const std::string make = interface.starts_with("vcan")
                                 ? "ip link add " + interface + " type vcan && " + remedy_to_bring_up(interface) +
                                       ", or run under tools/with-vcan"
                                 : "plug it in and load its driver; `ip link show type can` lists what is there";
    throw BusError(kMachineLacks, interface + ": no such interface", make);
  }
  if (!ask(socket, SIOCGIFHWADDR, interface, answer) || answer.ifr_hwaddr.sa_family != ARPHRD_CAN) {
    throw BusError(kBadAddress, interface + ": is not a CAN interface",
                   "name one of those that `ip link show type can` and `ip link show type vcan` list");
  }
  if (!carries_fd(socket, interface)) {
    throw BusError(kMachineLacks, interface + ": carries classic CAN only (mtu below 72)",
                   "ip link set " + interface + " down && " + remedy_to_bring_up(interface));
  }
  if (!is_up(socket, interface)) {
    throw BusError(kMachineLacks, interface + ": is down", remedy_to_bring_up(interface));
  }
}

FileDescriptor open_raw_socket(const std::string& interface) {
  FileDescriptor socket(::socket(PF_CAN, SOCK_RAW | SOCK_NONBLOCK | SOCK_CLOEXEC, CAN_RAW));
  if (socket.get() >= 0) return socket;
  const int error = errno;
  if (error == EPERM || error == EACCES) {
    throw BusError(kMachineLacks, interface + ": no permission to open a CAN socket",
                   "run as root, or grant CAP_NET_RAW: setcap cap_net_raw+ep PROGRAM");
  }
  const std::string what = error == EAFNOSUPPORT ? "this kernel has no CAN" : "no raw CAN socket: " + error_text(error);
  throw BusError(kMachineLacks, interface + ": " + what,
                 "modprobe -a can can-raw vcan, or run under tools/with-vcan, or use --bus udp");
}

bool set_filters(int socket, BusRole role) noexcept {
  std::array<can_filter, kMaxHeardIdentifiers> filters{};  // the first one alone passes everything
  std::size_t count = 0;
  for (const std::uint16_t identifier : heard_identifiers(role)) {
    filters[count++] = {.can_id = identifier, .can_mask = CAN_SFF_MASK | CAN_EFF_FLAG | CAN_RTR_FLAG};
  }
  return ::setsockopt(socket, SOL_CAN_RAW, CAN_RAW_FILTER, filters.data(),
                      static_cast<socklen_t>(std::max<std::size_t>(count, 1) * sizeof(can_filter))) == 0;
}

}  // namespace

FileDescriptor open_can_socket(const std::string& interface, BusRole role) {
  FileDescriptor socket = open_raw_socket(interface);
  check_interface(socket.get(), interface);
  ifreq answer;
  if (!set_option(socket.get(), SOL_CAN_RAW, CAN_RAW_FD_FRAMES, 1) || !set_filters(socket.get(), role) ||
      !set_option(socket.get(), SOL_CAN_RAW, CAN_RAW_ERR_FILTER, CAN_ERR_MASK) ||
      !ask(socket.get(), SIOCGIFINDEX, interface, answer) || !bind_to(socket.get(), answer.ifr_ifindex)) {
    throw BusError(kMachineLacks, interface + ": cannot be used: " + error_text(errno),
                   "see `ip -details link show " + interface + "`, or use --bus udp");
  }
  prepare_receiving(socket.get());
  return socket;
}

bool attach_again(int socket, const std::string& interface, BusRole role) noexcept {
  ifreq answer;
  if (!ask(socket, SIOCGIFINDEX, interface, answer)) return false;
  // The kernel forgets the filters of an interface that is deleted (raw_notify in net/can/raw.c).
  if (!set_filters(socket, role) || !bind_to(socket, answer.ifr_ifindex)) return false;
  int error = 0;
  socklen_t size = sizeof error;
  ::getsockopt(socket, SOL_SOCKET, SO_ERROR, &error, &size);
  return carries_fd(socket, interface) && is_up(socket, interface);
}

}  // namespace surefoot::host
