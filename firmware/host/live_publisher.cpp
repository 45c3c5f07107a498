#include "firmware/host/live_publisher.hpp"

#include <fmt/format.h>
#include <lcm/lcm.h>

#include <stdexcept>

namespace surefoot::host {

LivePublisher::LivePublisher(const std::string& provider) : lcm_(lcm_create(provider.c_str()), &lcm_destroy) {
  if (!lcm_) {
    throw std::runtime_error(
        fmt::format("LCM can not open {}\n  remedy: ip link set lo multicast on; ip route add 224.0.0.0/4 dev lo; "
                    "or run without live telemetry",
                    provider));
  }
}

void LivePublisher::publish(Channel channel, const std::byte* encoded, std::size_t size) noexcept {
  if (lcm_publish(lcm_.get(), name(channel), encoded, static_cast<unsigned>(size)) != 0) ++failures_;
}

}  // namespace surefoot::host
