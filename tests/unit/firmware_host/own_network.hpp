#pragma once

#include <fcntl.h>
#include <net/if.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstring>

namespace surefoot::host::testing {

/// A network of the calling thread's own, for as long as it lives: a loopback that is up, and no route.
class OwnNetwork {
 public:
  OwnNetwork() : before_(::open("/proc/thread-self/ns/net", O_RDONLY | O_CLOEXEC)) {
    is_ours_ = before_ >= 0 && ::unshare(CLONE_NEWNET) == 0;
    if (is_ours_) set_loopback_up(true);
  }
  ~OwnNetwork() {
    if (is_ours_) ::setns(before_, CLONE_NEWNET);
    ::close(before_);
  }
  OwnNetwork(const OwnNetwork&) = delete;
  OwnNetwork& operator=(const OwnNetwork&) = delete;

  /// False where this takes a right that the user has not.
  [[nodiscard]] bool is_ours() const { return is_ours_; }

  void set_loopback_up(bool up) const {
    ifreq request{};
    std::strcpy(request.ifr_name, "lo");
    request.ifr_flags = up ? IFF_UP : 0;
    const int socket = ::socket(AF_INET, SOCK_DGRAM, 0);
    ::ioctl(socket, SIOCSIFFLAGS, &request);
    ::close(socket);
  }

 private:
  int before_;
  bool is_ours_ = false;
};

}  // namespace surefoot::host::testing
