#pragma once

#include <gtest/gtest.h>
#include <linux/can.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

namespace surefoot::host::testing {

/// Runs a command of iproute2. @return whether it succeeded
inline bool ip(const std::string& arguments, const char* program = "ip") {
  return std::system((std::string(program) + ' ' + arguments + " 2>/dev/null").c_str()) == 0;
}

/// A virtual CAN interface of a test's own.
class Interface {
 public:
  explicit Interface(std::string name, int mtu = CANFD_MTU) : name_(std::move(name)), mtu_(mtu) { create(); }
  ~Interface() { remove(); }
  Interface(const Interface&) = delete;
  Interface& operator=(const Interface&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }
  void create() {
    EXPECT_TRUE(ip("link add " + name_ + " type vcan")) << "run this under tools/with-vcan";
    EXPECT_TRUE(ip("link set " + name_ + " mtu " + std::to_string(mtu_)));
    up();
  }
  void remove() { ip("link del " + name_); }
  void up() { EXPECT_TRUE(ip("link set " + name_ + " up")); }
  void down() { EXPECT_TRUE(ip("link set " + name_ + " down")); }

 private:
  std::string name_;
  int mtu_;
};

/// A plain socket that shares nothing with the code under test: writes frames of any shape, reads what a bus sends.
class RawSocket {
 public:
  explicit RawSocket(const std::string& interface) : socket_(::socket(PF_CAN, SOCK_RAW | SOCK_NONBLOCK, CAN_RAW)) {
    const int on = 1;
    EXPECT_EQ(::setsockopt(socket_, SOL_CAN_RAW, CAN_RAW_FD_FRAMES, &on, sizeof on), 0);
    sockaddr_can address{};
    address.can_family = AF_CAN;
    address.can_ifindex = static_cast<int>(::if_nametoindex(interface.c_str()));
    EXPECT_EQ(::bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  }
  ~RawSocket() { ::close(socket_); }
  RawSocket(const RawSocket&) = delete;
  RawSocket& operator=(const RawSocket&) = delete;

  void send_fd(canid_t identifier, std::uint8_t length, std::uint8_t flags = CANFD_BRS) const {
    canfd_frame frame{};
    frame.can_id = identifier;
    frame.len = length;
    frame.flags = flags;
    for (std::uint8_t i = 0; i < length; ++i) frame.data[i] = i;
    EXPECT_EQ(::write(socket_, &frame, CANFD_MTU), static_cast<ssize_t>(CANFD_MTU));
  }
  void send_classic(canid_t identifier, std::uint8_t length = 8) const {
    can_frame frame{};
    frame.can_id = identifier;
    frame.len = length;
    EXPECT_EQ(::write(socket_, &frame, CAN_MTU), static_cast<ssize_t>(CAN_MTU));
  }
  /// Waits for so many CAN FD frames.
  [[nodiscard]] std::vector<canfd_frame> read(std::size_t count) const {
    std::vector<canfd_frame> frames;
    pollfd waiting{.fd = socket_, .events = POLLIN, .revents = 0};
    while (frames.size() < count && ::poll(&waiting, 1, 20'000) == 1) {
      canfd_frame frame{};
      if (::read(socket_, &frame, sizeof frame) == static_cast<ssize_t>(CANFD_MTU)) frames.push_back(frame);
    }
    return frames;
  }

 private:
  int socket_;
};

}  // namespace surefoot::host::testing
