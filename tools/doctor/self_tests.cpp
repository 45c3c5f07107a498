#include "tools/doctor/self_tests.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <lcm/lcm.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <exception>
#include <memory>
#include <span>
#include <string>

#include "firmware/host/bus/udp_bus.hpp"
#include "firmware/host/live_publisher.hpp"
#include "firmware/host/realtime/monotonic_clock.hpp"

namespace surefoot::doctor {
namespace {

constexpr int kPatienceMs = 2000;
constexpr int kNotReceived = 1;

int lcm_round_trip() {
  const std::unique_ptr<lcm_t, void (*)(lcm_t*)> lcm(lcm_create(host::LivePublisher::kLocalProvider), &lcm_destroy);
  if (!lcm) return kNotReceived;  // it has said why
  bool is_received = false;
  const std::string channel = fmt::format("SUREFOOT_DOCTOR_{}", getpid());
  const auto receive = [](const lcm_recv_buf_t*, const char*, void* received) { *static_cast<bool*>(received) = true; };
  lcm_subscribe(lcm.get(), channel.c_str(), receive, &is_received);
  const std::uint8_t message = 1;
  if (lcm_publish(lcm.get(), channel.c_str(), &message, sizeof message) != 0) return kNotReceived;
  lcm_handle_timeout(lcm.get(), kPatienceMs);
  return is_received ? 0 : kNotReceived;
}

int udp_round_trip() {
  in_addr group{};
  inet_pton(AF_INET, host::UdpBus::kDefaultGroup, &group);
  const std::uint16_t port = host::UdpBus::kDefaultPort + 1;
  try {
    host::UdpBus receiver(group, port, host::BusRole::kEverything);
    host::UdpBus sender(group, port, host::BusRole::kEverything);
    // Another doctor may be at work: its frame has another number in it.
    can::CanFrame frame{.identifier = 0x7FF, .length = 4, .payload = {}};
    for (std::size_t i = 0; i < 4; ++i) frame.payload[i] = static_cast<std::uint8_t>(getpid() >> (8 * i));
    if (sender.send({&frame, 1}) != 1) return kNotReceived;
    const std::int64_t deadline_ns = host::MonotonicClock::now_ns() + kPatienceMs * std::int64_t{1'000'000};
    while (receiver.wait_readable(deadline_ns)) {
      can::CanFrame received;
      if (receiver.receive({&received, 1}) == 1 && received.payload == frame.payload) return 0;
    }
  } catch (const std::exception& error) {
    fmt::print("{}\n", error.what());
  }
  return kNotReceived;
}

}  // namespace

Outcome test_lcm() { return in_child_process(lcm_round_trip); }

Outcome test_udp_bus() { return in_child_process(udp_round_trip); }

}  // namespace surefoot::doctor
